#include "pipeline/benchmark.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "picture/frame_drawer.h"
#include "pipeline/frame_sink.h"
#include "pipeline/render_clip.h"
#include "store/clip_files.h"
#include "store/encoding.h"
#include "system/machine.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;

// Frames that one stage processes in a row. Stages take turns, so that whatever else the machine
// does slows all of them alike.
constexpr std::int64_t kBatch = 8;

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    if (error) throw failure("find a folder for temporary files", error.message());
    std::string pattern = (parent / "rotatebook-bench-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw failure("make a folder in " + parent.string(), std::strerror(errno));
    }
    path_ = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }

 private:
  static MachineError failure(const std::string& what, const std::string& error) {
    return MachineError(
        fmt::format("can't {}: {}; let TMPDIR name a folder that can be written", what, error));
  }

  fs::path path_;
};

/// Measures wall-clock and processor time since its construction. Processor time is the whole
/// process's, because a software rasteriser and an encoder have threads of their own.
class Stopwatch {
 public:
  WorkTime elapsed() const { return {now(CLOCK_MONOTONIC) - wall_, now(kUsed) - processor_}; }

 private:
  static constexpr clockid_t kUsed = CLOCK_PROCESS_CPUTIME_ID;

  static double now(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }

  double wall_ = now(CLOCK_MONOTONIC);
  double processor_ = now(kUsed);
};

template <typename Work>
WorkTime timed(const Work& work) {
  const Stopwatch watch;
  work();
  return watch.elapsed();
}

WorkTime perFrame(const WorkTime& all, std::int64_t frames) {
  const auto count = static_cast<double>(frames);
  return {all.wall / count, all.processor / count};
}

/// The stages of a render, which frames pass through one stage at a time.
class Stages {
 public:
  Stages(const scene::Scene& scene, const timeline::ClipMotion& motion, const SpeedOptions& options,
         const fs::path& folder)
      : drawer_(scene, motion, options.device, options.textures),
        exposures_(kBatch, drawer_.makeExposure()),
        pictures_(kBatch, drawer_.makePicture()),
        checksums_(folder),
        png_(checksums_, scene::isTransparent(scene)),
        video_(video::VideoFormat::Mp4, folder / "stages.mp4", store::videoSettings(scene, "")) {
    drawer_.draw(0, pictures_[0]);  // The first picture compiles the shaders.
  }

  /// Passes frames `first` to below `end`, at most kBatch, through all stages.
  void pass(std::int64_t first, std::int64_t end) {
    const auto each = [&](const auto& work) {
      return timed([&] {
        for (std::int64_t frame = first; frame < end; ++frame) {
          work(frame, static_cast<std::size_t>(frame - first));
        }
      });
    };
    sums_.book +=
        each([&](std::int64_t frame, std::size_t i) { drawer_.expose(frame, exposures_[i]); });
    sums_.compose +=
        each([&](std::int64_t, std::size_t i) { drawer_.compose(exposures_[i], pictures_[i]); });
    sums_.png +=
        each([&](std::int64_t frame, std::size_t i) { png_.write(frame, pictures_[i].view()); });
    sums_.video +=
        each([&](std::int64_t frame, std::size_t i) { video_.write(frame, pictures_[i].view()); });
  }

  picture::FramePainter& painter() { return drawer_; }

  /// Finishes the outputs after all `frames`; returns the times a frame.
  StageTimes finish(std::int64_t frames) {
    sums_.png += timed([&] { png_.finish(); });
    sums_.video += timed([&] { video_.finish(); });
    StageTimes times;
    times.book = perFrame(sums_.book, frames);
    times.compose = perFrame(sums_.compose, frames);
    times.png = perFrame(sums_.png, frames);
    times.video = perFrame(sums_.video, frames);
    return times;
  }

 private:
  picture::FrameDrawer drawer_;
  std::vector<picture::Exposure> exposures_;
  std::vector<image::Image> pictures_;
  store::FrameChecksums checksums_;
  PngSequenceSink png_;
  VideoSink video_;
  StageTimes sums_;
};

using Progress = std::function<void(std::int64_t)>;

/// Measures drawing and composing on their threads, as in a render, with a sink that takes no time.
/// Returns false if it was stopped.
bool measureDrawing(picture::FramePainter& painter, const SpeedOptions& options,
                    const Progress& progress, Speed& speed) {
  NullSink sink;
  const Stopwatch watch;
  const auto drawn = drawFrames(painter, {{0, speed.frames}, nullptr, options.stop}, {{sink}},
                                [&](RenderProgress now) { progress(now.done); });
  speed.drawing = perFrame(watch.elapsed(), speed.frames);
  return drawn.total() == speed.frames;
}

/// Measures each stage by itself, then drawing. Returns false if it was stopped.
bool measureStages(const scene::Scene& scene, const timeline::ClipMotion& motion,
                   const SpeedOptions& options, const Progress& progress, Speed& speed) {
  const TemporaryFolder folder;
  const std::int64_t frames = speed.frames;
  Stages stages(scene, motion, options, folder.path());
  for (std::int64_t first = 0; first < frames; first += kBatch) {
    if (options.stop != nullptr && *options.stop) return false;
    stages.pass(first, std::min(first + kBatch, frames));
    progress(std::min(first + kBatch, frames));
  }
  const WorkTime simulate = speed.stages.simulate;
  speed.stages = stages.finish(frames);
  speed.stages.simulate = simulate;
  const auto goOn = [&](std::int64_t done) { progress(frames + done); };
  return measureDrawing(stages.painter(), options, goOn, speed);
}

/// Measures a render as `rotatebook render` does it. Returns false if it was stopped.
bool measureWhole(const scene::Scene& scene, const timeline::ClipMotion& motion,
                  const SpeedOptions& options, const Progress& progress, Speed& speed) {
  const TemporaryFolder folder;
  std::optional<Stopwatch> watch;
  RenderListener listener;
  listener.started = [&](const RenderStart& begun) {
    speed.renderer = begun.renderer;
    speed.encoder = begun.encoders;
  };
  const Stopwatch start;
  listener.progress = [&](RenderProgress now) {
    if (!watch) {
      speed.startUp = start.elapsed().wall / 1000;
      watch.emplace();
    }
    progress(now.done);
  };
  const RenderOptions render{.folder = folder.path(),
                             .outputs = outputsOf(true, {video::VideoFormat::Mp4}),
                             .stop = options.stop,
                             .device = options.device};
  if (renderClip(scene, motion, render, listener, options.textures).interrupted) return false;
  speed.whole = perFrame(watch->elapsed(), speed.frames);
  return true;
}

}  // namespace

std::optional<Speed> measureSpeed(const scene::Scene& scene, const SpeedOptions& options) {
  scene::Scene part = scene;
  part.clip.duration = static_cast<double>(options.frames) * scene.clip.frameRate.period();
  Speed speed;
  speed.cores = system::coreCount();
  const Stopwatch watch;
  const timeline::ClipMotion motion = timeline::simulateScene(part, options.stop);
  const WorkTime simulated = watch.elapsed();
  if (options.stop != nullptr && *options.stop) return std::nullopt;
  speed.frames = motion.frameCount();
  speed.stages.simulate = perFrame(simulated, speed.frames);
  const auto progressAfter = [&](std::int64_t before) {
    return [&options, &speed, before](std::int64_t done) {
      if (options.progress) options.progress(before + done, 3 * speed.frames);
    };
  };
  if (!measureStages(part, motion, options, progressAfter(0), speed)) return std::nullopt;
  if (!measureWhole(part, motion, options, progressAfter(2 * speed.frames), speed))
    return std::nullopt;
  return speed;
}

}  // namespace rotatebook::pipeline
