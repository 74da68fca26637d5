#include "pipeline/assemble.h"

#include <system_error>
#include <unistd.h>
#include <utility>

#include "base/error.h"
#include "base/text.h"
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

/// First and last frame; throws if there is none or a gap.
store::FrameRange wholeRange(const fs::path& folder) {
  const std::vector<std::int64_t> indices = store::framesIn(folder);
  if (indices.empty()) {
    throw InputError(folder.string() + " holds no frames named like " + store::frameName(0));
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::int64_t wanted = indices.front() + static_cast<std::int64_t>(i);
    if (indices[i] != wanted) {
      throw InputError(folder.string() + ": " + store::frameName(wanted) + " is missing; " +
                       store::frameName(indices[i]) + " comes next");
    }
  }
  return {indices.front(), indices.back() + 1};
}

/// What tells how the video is to be made.
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
    const std::string record = store::readSceneText(sceneCopy);
    const scene::Scene scene = scene::parseScene(record, sceneCopy);
    const Assembled made{range, timeline::simulateScene(scene).frameCount()};
    return {
        store::videoSettings(scene, made.isPart() ? store::recordOfPart(record, range) : record),
        made};
  }
  if (!frameRate) {
    throw InputError(folder.string() +
                     " has no scene.toml that tells the frame rate; give it with --fps");
  }
  video::VideoSettings settings;
  settings.frameRate = *frameRate;
  return {settings, {range}};
}

/// A render has an exclusive lock of NAME/ while it fills NAME.partial/.
fs::path lockedNameOf(const fs::path& folder) {
  std::error_code error;
  const fs::path path = fs::canonical(folder, error);
  return path.extension() == store::kPartialEnding ? path.parent_path() / path.stem() : path;
}

/// Keeps renders of the whole clip out of a folder of frames while they are read. Throws
/// MachineError if one is under way. Where nothing can be written, none is.
std::optional<system::AdvisoryLock> lockForReading(const fs::path& folder) {
  const fs::path name = lockedNameOf(folder);
  if (access(name.parent_path().c_str(), W_OK) != 0) return std::nullopt;
  return std::optional<system::AdvisoryLock>(std::in_place, name, system::Lock::Shared);
}

/// Tells the `problem` that a frame has by the checksums, and how it is mended, or `joined` anyway.
[[noreturn]] void throwUnlike(const store::FrameChecksums& sums, const std::string& problem,
                              const std::string& joined) {
  throw InputError(problem + "; render the scene with --resume, which draws it again, or remove " +
                   (sums.folder() / store::kFrameSumsName).string() + " to join " + joined);
}

/// Throws if a frame that was drawn isn't among those that are there.
void requireAllDrawn(const store::FrameChecksums& sums, store::FrameRange range) {
  for (const std::int64_t index : sums.known()) {
    if (range.first <= index && index < range.end) continue;
    throwUnlike(sums,
                sums.folder().string() + ": " + store::frameName(index) + " is missing, which " +
                    store::kFrameSumsName + " there tells of",
                "the frames that are there");
  }
}

/// Throws for a frame that has a checksum, and isn't as that says.
image::Image readFrame(const store::FrameChecksums& sums, std::int64_t index) {
  const fs::path path = sums.folder() / store::frameName(index);
  if (!sums.knows(index)) return image::readPng(path);
  const std::optional<std::string> bytes = sums.intact(index);
  if (!bytes) {
    system::checksumOfFile(path);  // Says why, if it can't be read.
    throwUnlike(sums,
                path.string() + " isn't the picture that was drawn: " +
                    (sums.folder() / store::kFrameSumsName).string() +
                    " has another checksum of it",
                "frames that were changed on purpose");
  }
  const auto* first = reinterpret_cast<const std::uint8_t*>(bytes->data());
  return image::decodePng({first, bytes->size()}, path.string());
}

void requireSameSize(const fs::path& path, const image::Image& picture, const fs::path& firstPath,
                     const image::Image& first) {
  if (picture.width() == first.width() && picture.height() == first.height()) return;
  throw InputError("frames differ in size: " + firstPath.string() + " is " +
                   sizeText(first.width(), first.height()) + ", " + path.string() + " is " +
                   sizeText(picture.width(), picture.height()));
}

/// What the file's ending says.
video::VideoFormat formatOf(const fs::path& path) {
  for (const video::FormatRow& row : video::kFormatRows) {
    if (path.extension() == row.ending) return row.format;
  }
  throw InputError(path.string() + " names no format of video; let it end in " +
                   listFormats(&video::FormatRow::ending, "or"));
}

}  // namespace

Assembled assemble(const fs::path& folder, const fs::path& video,
                   std::optional<FrameRate> frameRate,
                   const std::function<void(RenderProgress)>& progress) {
  const video::VideoFormat format = formatOf(video);
  const auto lock = lockForReading(folder);
  // First: of a part that is being drawn, frames are added meanwhile, each before its checksum.
  const store::FrameChecksums sums(folder);
  const store::FrameRange range = wholeRange(folder);
  auto [settings, made] = sourceFor(folder, range, frameRate);
  requireAllDrawn(sums, range);
  const fs::path firstPath = folder / store::frameName(range.first);
  const image::Image first = readFrame(sums, range.first);
  settings.width = first.width();
  settings.height = first.height();
  const bool hasAlpha = first.format() == image::PixelFormat::Rgba8;
  if (hasAlpha && keepsTransparency(format)) settings.transparent = true;
  VideoSink sink(format, video, settings);
  for (std::int64_t index = range.first; index < range.end; ++index) {
    const fs::path path = folder / store::frameName(index);
    const image::Image picture = readFrame(sums, index);
    requireSameSize(path, picture, firstPath, first);
    sink.write(index, picture.view());
    if (progress) progress({index - range.first + 1, range.count()});
  }
  sink.finish();
  return made;
}

}  // namespace rotatebook::pipeline
