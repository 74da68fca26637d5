#include "pipeline/render_clip.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "picture/frame_drawer.h"
#include "picture/poster.h"
#include "scene/poster_frame.h"
#include "store/clip_folder.h"
#include "store/clip_record.h"
#include "store/encoding.h"
#include "store/fingerprint.h"
#include "store/other_settings.h"
#include "store/tables.h"
#include "system/atomic_file.h"
#include "system/machine.h"
#include "system/temporary_files.h"
#include "timeline/motion_checksum.h"
#include "timeline/web_vtt.h"

namespace rotatebook::pipeline {
namespace {

/// An output and its open sink.
struct OpenOutput {
  const RenderOutput* output;
  std::shared_ptr<FrameSink> sink;
};

/// Returns "libx264, gif".
std::string encoderNames(const std::vector<OpenOutput>& outputs) {
  std::string names;
  for (const OpenOutput& open : outputs) {
    const std::string name = open.sink->encoderName();
    if (!name.empty()) names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

int threadsOf(const RenderOutput& output) {
  return output.threads > 0 ? output.threads : pngThreads(system::coreCount());
}

store::ClipFiles filesOf(const scene::Scene& scene, const RenderOptions& options,
                         store::FrameRange range) {
  if (options.part) return store::clipFiles(options.folder, scene.name, *options.part);
  return options.frames ? store::clipFiles(options.folder, scene.name, range)
                        : store::clipFiles(options.folder, scene.name);
}

/// Returns the frames that a render draws. Those of a part may be none.
store::FrameRange framesOf(const timeline::ClipMotion& motion, const RenderOptions& options) {
  return options.part ? store::framesOf(*options.part, motion.frameCount())
                      : framesToRender(motion, options.frames);
}

/// A render in progress.
class Render {
 public:
  Render(const scene::Scene& scene, const timeline::ClipMotion& motion,
         const std::vector<timeline::MotionSummary>& summaries, const RenderOptions& options,
         const picture::TextureFiles& textures)
      : scene_(scene),
        motion_(motion),
        motionSum_(timeline::motionChecksum(motion)),
        summaries_(summaries),
        options_(options),
        png_(hasPng(options.outputs)),
        formats_(formatsOf(options.outputs)),
        range_(framesOf(motion, options)),
        drawer_(scene, motion, options.device, textures) {
    result_.files = filesOf(scene, options, range_);
    result_.csvs = store::csvFiles(result_.files.csv, scene);
    if (!scene.cues.empty()) result_.captions = result_.files.captions;
  }

  RenderResult run(const RenderListener& listener) {
    system::createFolders(options_.folder);
    const std::string& renderer = drawer_.description();
    const picture::TextureChecksums& textures = drawer_.textureChecksums();
    const std::string record =
        store::sceneRecord(scene_, store::provenanceOf(scene_, motionSum_, textures, renderer, ""));
    // Frames are drawn without FFmpeg, also where it can't be loaded
    const std::string videoRecord =
        formats_.empty() ? record : store::recordOfVideo(record, video::ffmpegVersion());
    const std::vector<std::filesystem::path> files = outputFiles(result_.files, scene_, formats_);
    store::ClipFolder folder(result_.files, {.scene = scene_,
                                             .record = record,
                                             .made = store::fingerprint(
                                                 scene_, textures, {renderer, drawer_.testFrame()}),
                                             .outputs = files,
                                             .earlier = options_.earlier,
                                             .part = options_.isPart(),
                                             .png = png_,
                                             .ownChecksums = options_.part.has_value()});
    result_.remainder = folder.remainder();
    result_.wasDone = !options_.isPart() && options_.earlier.resume && folder.isDone(pngRange()) &&
                      videosHold(videoRecord);
    if (result_.wasDone) {
      // A killed render may have left some after its last file
      system::removeStaleTemporaries(options_.folder);
      return result_;
    }
    folder.requireReplaceableOutputs(partialVideos());
    try {
      renderInto(folder, videoRecord, listener);
      if (!result_.interrupted) finishFolder(folder);
    } catch (const MachineError& error) {
      throw MachineError(error.what() + keptText(folder), error.kind());
    }
    return result_;
  }

 private:
  std::optional<store::FrameRange> pngRange() const {
    return png_ ? std::optional(range_) : std::nullopt;
  }

  std::vector<std::filesystem::path> partialVideos() const {
    std::vector<std::filesystem::path> videos;
    for (const video::VideoFormat format : formats_)
      videos.push_back(result_.files.partialVideo(format));
    return videos;
  }

  /// Returns whether the finished videos have this record: they don't if FFmpeg was another.
  bool videosHold(const std::string& record) const {
    return std::ranges::all_of(formats_, [&](video::VideoFormat format) {
      return !rowOf(format).holdsRecord || store::recordIn(result_.files.video(format)) == record;
    });
  }

  void finishFolder(store::ClipFolder& folder) {
    if (!options_.isPart()) {
      folder.finish(pngRange());
    } else if (png_) {
      folder.finishPart(range_);
    }
    result_.others = folder.keptOfOtherSettings();
    result_.replaced = folder.replacedOfOtherSettings();
    std::ranges::copy(removedVideos_, std::back_inserter(result_.replaced));
    result_.remainder = folder.remainder();
  }

  std::string keptText(const store::ClipFolder& folder) const {
    const std::size_t count = png_ ? folder.resumableFrames() : 0;
    if (count == 0) return "";
    return fmt::format("\n  {} finished {} kept in {}/; go on with the same command and --resume",
                       count, count == 1 ? "frame is" : "frames are", folder.path().string());
  }

  void renderInto(store::ClipFolder& folder, const std::string& record,
                  const RenderListener& listener) {
    const std::string shown = options_.isPart() ? store::recordOfPart(record, range_) : record;
    const video::VideoSettings video = store::videoSettings(scene_, shown, !options_.isPart());
    std::vector<OpenOutput> outputs;
    for (const RenderOutput& output : options_.outputs) {
      outputs.push_back({&output, output.open({scene_, result_.files, video, folder.checksums()})});
    }
    drawInto(outputs, folder.checksums(), listener);
    result_.interrupted ? finishPartial(outputs) : finish(outputs);
  }

  void drawInto(const std::vector<OpenOutput>& outputs, const store::FrameChecksums& checksums,
                const RenderListener& listener) {
    RenderStart start{drawer_.description(), encoderNames(outputs)};
    std::vector<SinkThreads> sinks;
    for (const auto& [output, sink] : outputs) {
      sinks.push_back({*sink, threadsOf(*output), !output->png});
      if (output->png) start.pngThreads = sinks.back().threads;
    }
    const store::FrameChecksums* kept = options_.earlier.resume ? &checksums : nullptr;
    start.space = store::diskSpace(scene_, toWrite(kept), options_.folder);
    if (listener.started) listener.started(start);
    const DrawnCount count =
        drawFrames(drawer_, {range_, kept, options_.stop}, sinks, listener.progress);
    result_.framesWritten = count.total();
    result_.framesKept = count.kept;
    result_.interrupted = count.total() < range_.count();
  }

  /// Returns the files still to write: PNGs without those of `kept`, which may be null, but videos
  /// from their first frame.
  store::FilesToWrite toWrite(const store::FrameChecksums* kept) const {
    store::FilesToWrite files{.frames = range_.count(), .formats = formats_};
    if (!png_) return files;
    files.pngs = range_.count();
    if (kept == nullptr) return files;
    for (const std::int64_t index : store::framesIn(kept->folder())) {
      if (range_.first <= index && index < range_.end) --files.pngs;
    }
    return files;
  }

  /// Completes the videos under their partial names, unless they have no frame.
  void finishPartial(const std::vector<OpenOutput>& outputs) const {
    if (result_.framesWritten == 0) return;
    for (const auto& [output, sink] : outputs) {
      if (output->format) sink->finishAs(result_.files.partialVideo(*output->format));
    }
  }

  void finish(const std::vector<OpenOutput>& outputs) {
    store::writeTables(result_.csvs, scene_, motion_);
    if (!result_.files.json.empty()) {
      store::writeResult(result_.files.json, scene_, motion_,
                         summaries_.empty() ? timeline::summarize(scene_, motion_) : summaries_,
                         motionSum_);
    }
    if (!result_.captions.empty()) {
      system::writeFileAtomically(
          result_.captions,
          timeline::webVtt(scene_, timeline::eventsOf(scene_, motion_), motion_.frameCount()));
    }
    if (!options_.isPart()) {
      picture::writePoster(drawer_, scene::posterFrame(scene_.clip, range_.count()),
                           scene::isTransparent(scene_), result_.files.poster);
    }
    for (const OpenOutput& open : outputs) open.sink->finish();
    for (const video::VideoFormat format : formats_) removePartialVideo(format);
  }

  /// Removes what an interrupted render left, and notes it unless that was this one.
  void removePartialVideo(video::VideoFormat format) {
    const std::filesystem::path video = result_.files.partialVideo(format);
    if (!std::filesystem::is_regular_file(video)) return;
    const std::string record = rowOf(format).holdsRecord ? store::recordIn(video) : "";
    const bool isOwn = record.empty() ? !rowOf(format).holdsRecord && options_.earlier.resume
                                      : store::isRecordOf(scene_, record);
    if (!isOwn) {
      removedVideos_.push_back(video.string() + (record.empty() ? store::kUnknownSettings : ""));
    }
    system::removeFile(video);
  }

  const scene::Scene& scene_;
  const timeline::ClipMotion& motion_;
  std::string motionSum_;
  const std::vector<timeline::MotionSummary>& summaries_;
  const RenderOptions& options_;
  bool png_;
  std::vector<video::VideoFormat> formats_;
  store::FrameRange range_;
  picture::FrameDrawer drawer_;
  RenderResult result_;
  std::vector<std::string> removedVideos_;  // Of interrupted renders of other settings.
};

}  // namespace

store::FrameRange framesToRender(const timeline::ClipMotion& motion,
                                 std::optional<store::FrameRange> wanted) {
  const std::int64_t count = motion.frameCount();
  const store::FrameRange range = wanted.value_or(store::FrameRange{0, count});
  if (0 <= range.first && range.first < range.end && range.end <= count) return range;
  throw InputError(
      fmt::format("frames {}:{} don't exist; this clip has 0:{}{}", range.first, range.end, count,
                  motion.allDiverge() ? ", up to a second after its motion diverges" : ""));
}

RenderResult renderClip(const scene::Scene& scene, const timeline::ClipMotion& motion,
                        const RenderOptions& options, const RenderListener& listener,
                        const picture::TextureFiles& textures,
                        const std::vector<timeline::MotionSummary>& summaries) {
  const store::FrameRange frames = framesOf(motion, options);
  if (frames.count() == 0) {
    RenderResult nothing;
    nothing.files = filesOf(scene, options, frames);
    return nothing;
  }
  return Render(scene, motion, summaries, options, textures).run(listener);
}

}  // namespace rotatebook::pipeline
