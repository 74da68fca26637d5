#include "pipeline/render_clip.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "base/atomic_file.h"
#include "base/error.h"
#include "pipeline/clip_record.h"
#include "pipeline/fingerprint.h"
#include "pipeline/frame_drawer.h"
#include "pipeline/machine.h"
#include "pipeline/poster.h"
#include "pipeline/trajectory_csv.h"

namespace rotatebook::pipeline {
namespace {

using VideoSinks = std::vector<std::unique_ptr<VideoSink>>;

VideoSinks openVideos(const ClipFiles& files, const video::VideoSettings& settings,
                      const std::vector<video::VideoFormat>& formats) {
  VideoSinks videos;
  for (const video::VideoFormat format : formats) {
    videos.push_back(std::make_unique<VideoSink>(format, files.video(format), settings));
  }
  return videos;
}

/// "libx264, gif"
std::string encoderNames(const VideoSinks& videos) {
  std::string names;
  for (const auto& video : videos) names += (names.empty() ? "" : ", ") + video->encoderName();
  return names;
}

std::vector<SinkThreads> sinksOf(const VideoSinks& videos, PngSequenceSink& png, int pngThreads) {
  std::vector<SinkThreads> sinks;
  if (pngThreads > 0) sinks.push_back({png, pngThreads, false});
  for (const auto& video : videos) sinks.push_back({*video});
  return sinks;
}

ClipFiles filesOf(const scene::Scene& scene, const RenderOptions& options, FrameRange range) {
  return options.frames ? clipFiles(options.folder, scene.name, range)
                        : clipFiles(options.folder, scene.name);
}

/// All files of a whole clip but its frames.
std::vector<std::filesystem::path> allFiles(const RenderResult& result,
                                            const std::vector<video::VideoFormat>& formats) {
  std::vector<std::filesystem::path> files = result.csvs;
  files.push_back(result.files.poster);
  for (const video::VideoFormat format : formats) files.push_back(result.files.video(format));
  return files;
}

/// A render on its way.
class Render {
 public:
  Render(const scene::Scene& scene, const ClipMotion& motion, const RenderOptions& options)
      : scene_(scene),
        motion_(motion),
        options_(options),
        range_(framesToRender(motion, options.frames)),
        drawer_(scene, motion, options.device) {
    result_.files = filesOf(scene, options, range_);
    result_.csvs = csvFiles(result_.files.csv, scene);
  }

  RenderResult run(const RenderListener& listener) {
    createFolders(options_.folder);
    const std::string record =
        sceneRecord(scene_, makingOf(scene_, motion_, drawer_.description()));
    ClipFolder folder(result_.files, {.scene = scene_,
                                      .record = record,
                                      .made = fingerprint(scene_, drawer_.description(),
                                                          options_.pngOptions.level),
                                      .earlier = options_.earlier,
                                      .part = options_.frames.has_value(),
                                      .png = options_.png});
    const std::vector<std::filesystem::path> files = allFiles(result_, options_.formats);
    result_.wasDone =
        !options_.frames && options_.earlier.resume && folder.isDone(files, pngRange());
    if (result_.wasDone) return result_;
    // Better said now than when all is drawn.
    if (!options_.frames) std::ranges::for_each(files, requireReplaceable);
    try {
      renderInto(folder, record, listener);
      if (!result_.interrupted) finishFolder(folder, files);
      if (!result_.interrupted) result_.others = folder.keptOfOtherSettings();
    } catch (const MachineError& error) {
      throw MachineError(error.what() + keptText(folder));
    }
    return result_;
  }

 private:
  std::optional<FrameRange> pngRange() const {
    return options_.png ? std::optional(range_) : std::nullopt;
  }

  void finishFolder(ClipFolder& folder, const std::vector<std::filesystem::path>& files) const {
    if (!options_.frames) return folder.finish(files, pngRange());
    if (options_.png) folder.sums().requireFiles(range_);
  }

  std::string keptText(const ClipFolder& folder) const {
    const std::size_t count = options_.png ? folder.resumableFrames() : 0;
    if (count == 0) return "";
    return "\n  " + std::to_string(count) +
           (count == 1 ? " finished frame is kept in " : " finished frames are kept in ") +
           folder.path().string() + "/; go on with the same command and --resume";
  }

  void renderInto(ClipFolder& folder, const std::string& record, const RenderListener& listener) {
    const std::string shown = options_.frames ? recordOfPart(record, range_) : record;
    const VideoSinks videos =
        openVideos(result_.files, videoSettings(scene_, shown), options_.formats);
    drawInto(videos, folder.sums(), listener);
    result_.interrupted ? finishPartial(videos) : finish(videos);
  }

  void drawInto(const VideoSinks& videos, FrameSums& sums, const RenderListener& listener) {
    image::PngOptions pngOptions = options_.pngOptions;
    pngOptions.transparent = isTransparent(scene_);
    PngSequenceSink png(sums, pngOptions);
    RenderStart start{drawer_.description(), encoderNames(videos)};
    if (options_.png) {
      start.pngThreads = options_.pngThreads > 0 ? options_.pngThreads : pngThreads(coreCount());
    }
    const FrameSums* kept = options_.earlier.resume ? &sums : nullptr;
    start.space = diskSpace(scene_, toWrite(kept), options_.folder);
    if (listener.started) listener.started(start);
    const DrawnCount count = drawFrames(drawer_, {range_, kept, options_.stop},
                                        sinksOf(videos, png, start.pngThreads), listener.progress);
    result_.framesWritten = count.total();
    result_.framesKept = count.kept;
    result_.interrupted = count.total() < range_.count();
  }

  /// Frames of `kept`, which may be null, aren't written again; videos are, from the first frame.
  FilesToWrite toWrite(const FrameSums* kept) const {
    FilesToWrite files{.frames = range_.count(), .formats = options_.formats};
    if (!options_.png) return files;
    files.pngs = range_.count();
    if (kept == nullptr) return files;
    for (const std::int64_t index : framesIn(kept->folder())) {
      if (range_.first <= index && index < range_.end) --files.pngs;
    }
    return files;
  }

  /// A clip of no frames isn't worth a file.
  void finishPartial(const VideoSinks& videos) const {
    if (result_.framesWritten == 0) return;
    for (const auto& video : videos) video->finishAs(result_.files.partialVideo(video->format()));
  }

  void finish(const VideoSinks& videos) {
    writeTables(result_.csvs, motion_);
    if (!options_.frames) {
      writePoster(drawer_, posterFrame(scene_.clip, range_.count()), isTransparent(scene_),
                  result_.files.poster);
    }
    for (const auto& video : videos) video->finish();
    for (const auto& video : videos) removeFile(result_.files.partialVideo(video->format()));
  }

  const scene::Scene& scene_;
  const ClipMotion& motion_;
  const RenderOptions& options_;
  FrameRange range_;
  FrameDrawer drawer_;
  RenderResult result_;
};

}  // namespace

// Packing PNGs is the only stage that can be shared out; drawing, finishing and encoding need a
// core too.
int pngThreads(int cores) {
  return std::clamp(cores - 1, 1, 6);
}

FrameRange framesToRender(const ClipMotion& motion, std::optional<FrameRange> wanted) {
  const std::int64_t count = motion.frameCount();
  const FrameRange range = wanted.value_or(FrameRange{0, count});
  if (0 <= range.first && range.first < range.end && range.end <= count) return range;
  throw InputError("frames " + std::to_string(range.first) + ":" + std::to_string(range.end) +
                   " don't exist; this clip has 0:" + std::to_string(count) +
                   (motion.allDiverge() ? ", up to a second after its motion diverges" : ""));
}

RenderResult renderClip(const scene::Scene& scene, const ClipMotion& motion,
                        const RenderOptions& options, const RenderListener& listener) {
  return Render(scene, motion, options).run(listener);
}

}  // namespace rotatebook::pipeline
