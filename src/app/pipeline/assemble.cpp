#include "pipeline/assemble.h"

#include <algorithm>
#include <span>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "image/picture_file.h"
#include "image/png_colours.h"
#include "image/png_file.h"
#include "scene/scene_text.h"
#include "store/clip_files.h"
#include "store/clip_record.h"
#include "store/encoding.h"
#include "store/frame_checksums.h"
#include "store/scene_file.h"
#include "system/atomic_file.h"
#include "system/file_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;

/// Returns the range of the frames in `folder`. Throws InputError if there are none or one is
/// missing.
store::FrameRange wholeRange(const fs::path& folder) {
  const std::vector<std::int64_t> indices = store::framesIn(folder);
  if (indices.empty()) {
    throw InputError(
        fmt::format("{} holds no frames named like {}", folder.string(), store::frameName(0)));
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::int64_t wanted = indices.front() + static_cast<std::int64_t>(i);
    if (indices[i] != wanted) {
      throw InputError(fmt::format("{}: {} is missing; {} comes next", folder.string(),
                                   store::frameName(wanted), store::frameName(indices[i])));
    }
  }
  return {indices.front(), indices.back() + 1};
}

/// Returns the number of frames of the scene's whole clip. Recorded motions never diverge, and
/// their files needn't be here.
std::int64_t wholeFrameCount(const scene::Scene& scene) {
  const bool isRecorded = std::ranges::any_of(scene.motions, [](const auto& panel) {
    return panel.simulation.model == physics::Model::Recorded;
  });
  return isRecorded ? scene.clip.frameCount() : timeline::simulateScene(scene).frameCount();
}

/// Throws InputError if the scene has chapters, and events of a motion that isn't here.
void requireChapters(const scene::Scene& scene) {
  const auto hasOne = [](const scene::Cue& cue) { return !cue.chapter.empty(); };
  if (scene.cues.size() == scene.shownCues.size() || std::ranges::none_of(scene.cues, hasOne))
    return;
  throw InputError(
      scene.name +
      ": its cues name events of a recorded motion, whose file isn't among the frames, so its "
      "chapters can't be found; rotatebook render makes the video");
}

/// The settings and the frames of the video.
struct Source {
  video::VideoSettings settings;
  Assembled made;
};

Source sourceFor(const fs::path& folder, store::FrameRange range,
                 std::optional<FrameRate> frameRate) {
  const fs::path sceneCopy = folder / store::kSceneCopyName;
  if (fs::exists(sceneCopy)) {
    if (frameRate) {
      throw InputError(sceneCopy.string() + " sets the frame rate already; leave --fps out");
    }
    const std::string text = store::readSceneText(sceneCopy);
    const scene::Scene scene = scene::parseScene(text, sceneCopy);
    const std::string record = store::recordOfVideo(text, video::ffmpegVersion());
    const Assembled made{range, wholeFrameCount(scene)};
    requireChapters(scene);
    return {store::videoSettings(scene, made.isPart() ? store::recordOfPart(record, range) : record,
                                 !made.isPart()),
            made};
  }
  if (!frameRate) {
    throw InputError(folder.string() +
                     " has no scene.toml that sets the frame rate; give it with --fps");
  }
  video::VideoSettings settings;
  settings.frameRate = *frameRate;
  return {settings, {range}};
}

/// Returns the path that a render into `folder` locks: NAME/ also while it fills NAME.partial/.
fs::path lockedNameOf(const fs::path& folder) {
  std::error_code error;
  const fs::path path = fs::canonical(folder, error);
  return path.extension() == store::kPartialEnding ? path.parent_path() / path.stem() : path;
}

/// Locks a folder of frames against renders of the whole clip while the frames are read. Throws
/// MachineError if one is in progress. A read-only folder needs no lock: nobody renders there.
std::optional<system::AdvisoryLock> lockForReading(const fs::path& folder) {
  const fs::path name = lockedNameOf(folder);
  if (access(name.parent_path().c_str(), W_OK) != 0) return std::nullopt;
  return std::optional<system::AdvisoryLock>(std::in_place, name, system::Lock::Shared);
}

/// Throws InputError with the `problem` of a frame that doesn't match the checksums, how to fix it,
/// and how to assemble `joined` anyway.
[[noreturn]] void throwMismatch(const store::FrameChecksums& checksums, const std::string& problem,
                                const std::string& joined) {
  throw InputError(fmt::format(
      "{}; render the scene with --resume, which draws it again, or remove {} to join {}", problem,
      store::FrameChecksums::filesIn(checksums.folder()).string(), joined));
}

/// Throws InputError if a frame that has a checksum isn't in `range`, which has all that exist.
void requireAllDrawn(const store::FrameChecksums& checksums, store::FrameRange range) {
  for (const std::int64_t index : checksums.indices()) {
    if (range.first <= index && index < range.end) continue;
    throwMismatch(
        checksums,
        fmt::format("{}: {} is missing, although {} lists it", checksums.folder().string(),
                    store::frameName(index), store::kFrameChecksumsName),
        "the frames that are there");
  }
}

/// Throws InputError if the frames that are there aren't all of the scene's.
void requireWhole(const fs::path& folder, const Assembled& made) {
  if (!made.sceneFrames) {
    throw InputError(fmt::format(
        "--whole: {} has no scene.toml that says how many frames there are", folder.string()));
  }
  if (!made.isPart()) return;
  throw InputError(
      fmt::format("{} holds the frames {} of the scene's {}; render the scene with --resume, which "
                  "draws the others, or leave out --whole",
                  folder.string(), store::rangeText(made.frames), *made.sceneFrames));
}

/// Returns the bytes of frame `index`. Throws InputError if it doesn't match its checksum.
std::string frameBytes(const store::FrameChecksums& checksums, std::int64_t index) {
  const fs::path path = checksums.folder() / store::frameName(index);
  if (!checksums.contains(index)) return image::readPictureFile(path);
  std::optional<std::string> bytes = checksums.intact(index);
  if (!bytes) {
    system::checksumOfFile(path);  // Throws with the reason if the file can't be read.
    throwMismatch(
        checksums,
        fmt::format("{} isn't the picture that was drawn: {} has another checksum for it",
                    path.string(), (checksums.folder() / store::kFrameChecksumsName).string()),
        "frames that were changed on purpose");
  }
  return std::move(*bytes);
}

void noteColours(std::span<const std::uint8_t> png, std::vector<LostColours>& lost) {
  constexpr std::size_t kMaxKinds = 8;
  for (const std::string& text : image::lostColoursOf(png)) {
    const auto known = std::ranges::find(lost, text, &LostColours::text);
    if (known != lost.end()) {
      ++known->frames;
    } else if (lost.size() < kMaxKinds) {
      lost.push_back({text, 1});
    }
  }
}

/// Reads frame `index`, and notes what of its colours is lost. Throws InputError if it doesn't
/// match its checksum; one without a checksum is accepted if it is a PNG whose own are right.
image::Image readFrame(const store::FrameChecksums& checksums, std::int64_t index,
                       std::vector<LostColours>& lost) {
  const std::string bytes = frameBytes(checksums, index);
  const std::span png(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  image::Image picture =
      image::decodePng(png, (checksums.folder() / store::frameName(index)).string());
  noteColours(png, lost);
  return picture;
}

void requireSameSize(const fs::path& path, const image::Image& picture, const fs::path& firstPath,
                     const image::Image& first) {
  if (picture.width() == first.width() && picture.height() == first.height()) return;
  throw InputError(fmt::format("frames differ in size: {} is {}, {} is {}", firstPath.string(),
                               sizeText(first.width(), first.height()), path.string(),
                               sizeText(picture.width(), picture.height())));
}

bool isOpaque(const image::Image& picture) {
  if (picture.format() != image::PixelFormat::Rgba8) return true;
  for (int y = 0; y < picture.height(); ++y) {
    const std::uint8_t* row = picture.row(y);
    for (int x = 0; x < picture.width(); ++x) {
      if (row[4 * x + 3] != 255) return false;
    }
  }
  return true;
}

/// Throws InputError if the video would lose the transparency of a frame: because its format keeps
/// none, or because the first frame has none.
void requireOpaque(const fs::path& path, const image::Image& picture, video::VideoFormat format,
                   const fs::path& firstPath) {
  if (isOpaque(picture)) return;
  if (keepsTransparency(format)) {
    throw InputError(
        fmt::format("{} has transparent pixels, which would be lost, as {} has no alpha channel; "
                    "give all frames one",
                    path.string(), firstPath.string()));
  }
  throw InputError(fmt::format(
      "{} has transparent pixels, which {} can't hold; use the ending {}, or lay the frames over a "
      "background",
      path.string(), nameOf(format),
      listFormats(&video::FormatRow::ending, "or", &video::FormatRow::keepsTransparency)));
}

}  // namespace

Assembled assemble(const fs::path& folder, const fs::path& video,
                   std::optional<FrameRate> frameRate,
                   const std::function<void(RenderProgress)>& progress, bool whole) {
  const video::VideoFormat format = video::formatOfFile(video);
  const auto lock = lockForReading(folder);
  // Read the checksums before the frames: a part that is being rendered adds each frame before its
  // checksum.
  const store::FrameChecksums checksums(folder);
  const store::FrameRange range = wholeRange(folder);
  auto [settings, made] = sourceFor(folder, range, frameRate);
  requireAllDrawn(checksums, range);
  if (whole) requireWhole(folder, made);
  const auto listed = static_cast<std::int64_t>(checksums.indices().size());
  if (listed > 0) made.unlisted = range.count() - listed;
  const fs::path firstPath = folder / store::frameName(range.first);
  std::vector<LostColours> ofFirst;
  const image::Image first = readFrame(checksums, range.first, ofFirst);
  settings.width = first.width();
  settings.height = first.height();
  const bool hasAlpha = first.format() == image::PixelFormat::Rgba8;
  if (hasAlpha && keepsTransparency(format)) settings.transparent = true;
  VideoSink sink(format, video, settings);
  for (std::int64_t index = range.first; index < range.end; ++index) {
    const fs::path path = folder / store::frameName(index);
    const image::Image picture = readFrame(checksums, index, made.lost);
    requireSameSize(path, picture, firstPath, first);
    if (!settings.transparent) requireOpaque(path, picture, format, firstPath);
    sink.write(index, picture.view());
    if (progress) progress({index - range.first + 1, range.count()});
  }
  sink.finish();
  return made;
}

}  // namespace rotatebook::pipeline
