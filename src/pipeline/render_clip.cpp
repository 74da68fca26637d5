#include "pipeline/render_clip.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "pipeline/frame_folder.h"
#include "pipeline/frame_workers.h"
#include "pipeline/machine.h"
#include "pipeline/pool.h"
#include "pipeline/poster.h"
#include "pipeline/trajectory_csv.h"

namespace rotatebook::pipeline {
namespace {

constexpr int kPicturesInFlight = 8;
constexpr int kExposuresInFlight = 3;

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

/// Brings a finished render under its final names, in the place of an earlier one's files.
void finish(const VideoSinks& videos, const ClipFiles& files, const std::string& record,
            const RenderOptions& options) {
  for (const auto& video : videos) video->finish();
  for (const video::VideoFormat format : video::kVideoFormats) {
    removeFile(files.partialVideo(format));
  }
  if (options.frames) return;
  removeOutdated(files, record, options.png, options.formats);
  if (options.png) replaceFrames(files);
}

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

std::int64_t drawFrames(FrameDrawer& drawer, FrameRange range,
                        const std::vector<SinkThreads>& sinks, const std::atomic<bool>* stop,
                        const std::function<void(RenderProgress)>& progress) {
  using SharedExposure = std::shared_ptr<const Exposure>;
  FirstError error;
  PicturePool pictures(drawer.makePicture(), kPicturesInFlight);
  Pool<Exposure> exposures(drawer.makeExposure(), kExposuresInFlight);
  std::vector<std::unique_ptr<FrameWorkers>> workers;
  for (const SinkThreads& entry : sinks) {
    workers.push_back(std::make_unique<FrameWorkers>(entry.sink, entry.threads, error));
  }
  const auto finish = [&](const SharedExposure& exposure) {
    const std::shared_ptr<image::Image> picture = pictures.take();
    drawer.finish(*exposure, *picture);
    for (const auto& sink : workers) sink->submit({exposure->frame, picture});
  };
  Workers<SharedExposure> finisher(finish, 1, error);
  std::int64_t done = 0;
  if (progress) progress({done, range.count()});
  while (done < range.count() && !(stop != nullptr && *stop)) {
    const std::shared_ptr<Exposure> exposure = exposures.take();
    try {
      drawer.expose(range.first + done, *exposure);
    } catch (...) {
      error.set(std::current_exception());
    }
    error.rethrow();
    finisher.submit(exposure);
    ++done;
    if (progress) progress({done, range.count()});
  }
  finisher.drain();
  for (const auto& sink : workers) sink->drain();
  error.rethrow();
  return done;
}

RenderResult renderClip(const scene::Scene& scene, const ClipMotion& motion,
                        const RenderOptions& options, const RenderListener& listener) {
  const FrameRange range = framesToRender(motion, options.frames);
  FrameDrawer drawer(scene, motion);
  const std::string record = sceneRecord(scene, drawer.description());

  RenderResult result;
  result.files = options.frames ? clipFiles(options.folder, scene.name, range)
                                : clipFiles(options.folder, scene.name);
  result.csvs = csvFiles(result.files.csv, scene);
  createFolders(options.folder);
  if (options.frames) refuseForeignFrames(result.files, record);
  const VideoSinks videos = openVideos(result.files, videoSettings(scene, record), options.formats);
  if (options.png && options.frames) startPart(result.files, record);
  if (options.png && !options.frames) startWholeClip(result.files, record);
  image::PngOptions pngOptions = options.pngOptions;
  pngOptions.transparent = isTransparent(scene);
  PngSequenceSink png(options.frames ? result.files.frameFolder : result.files.partialFrameFolder,
                      pngOptions);

  std::vector<SinkThreads> sinks;
  RenderStart start{drawer.description(), encoderNames(videos)};
  if (options.png) {
    start.pngThreads = options.pngThreads > 0 ? options.pngThreads : pngThreads(coreCount());
    sinks.push_back({png, start.pngThreads});
  }
  for (const auto& video : videos) sinks.push_back({*video, 1});
  if (listener.started) listener.started(start);
  result.framesWritten = drawFrames(drawer, range, sinks, options.stop, listener.progress);
  result.interrupted = result.framesWritten < range.count();
  if (result.interrupted) {
    // A clip of no frames isn't worth a file.
    for (const auto& video : videos) {
      if (result.framesWritten > 0) video->finishAs(result.files.partialVideo(video->format()));
    }
  } else {
    finish(videos, result.files, record, options);
    writeTables(result.csvs, motion);
    if (!options.frames) {
      writePoster(drawer, posterFrame(scene.clip, range.count()), isTransparent(scene),
                  result.files.poster);
    }
  }
  return result;
}

}  // namespace rotatebook::pipeline
