// From a scene to its files.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/clip_files.h"
#include "pipeline/clip_motion.h"
#include "pipeline/frame_drawer.h"
#include "pipeline/frame_sink.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// What to write, and where.
struct RenderOptions {
  std::filesystem::path folder = "out";  ///< Made if it isn't there.
  bool png = true;
  std::vector<video::VideoFormat> formats{video::VideoFormat::Mp4};  ///< Each at most once.
  std::optional<FrameRange> frames{};  ///< Only these; all by default.
  image::PngOptions pngOptions{};
  int pngThreads = 0;  ///< 0: pngThreads() of the machine's cores. The files are the same.
  /// Set from outside, e.g. by a signal handler, to stop after the frame in hand. May be null.
  const std::atomic<bool>* stop = nullptr;
};

/// Told before the first frame and after each one.
struct RenderProgress {
  std::int64_t done = 0;
  std::int64_t total = 0;
};

/// How many threads pack PNGs where a render has so many cores.
int pngThreads(int cores);

/// With what a render begins.
struct RenderStart {
  std::string renderer;
  std::string encoders;  ///< "libx264, gif"
  int pngThreads = 0;    ///< 0 if there are no PNGs.
};

/// Hears of a render while it goes on; called on the caller's thread.
struct RenderListener {
  std::function<void(const RenderStart&)> started;
  std::function<void(RenderProgress)> progress;
};

/// What a render left.
struct RenderResult {
  ClipFiles files;
  std::vector<std::filesystem::path> csvs;  ///< The tables; none are written if interrupted.
  std::int64_t framesWritten = 0;
  /// Stopped from outside: frames are in NAME.partial/ (those of a part in NAME/), videos are
  /// NAME.partial.mp4 and so on, and the files of an earlier render are as they were.
  bool interrupted = false;
};

/// The frames of the clip that `wanted` means; all of them by default. Throws InputError,
/// naming the frames that exist.
FrameRange framesToRender(const ClipMotion& motion, std::optional<FrameRange> wanted);

/// Draws `motion`, that of `scene`, and writes CSV, PNGs, videos and, of a whole clip,
/// poster. The frames of a whole clip are written to NAME.partial/ and, once the clip is complete,
/// take the place of an earlier one's in NAME/, so that files of two renders never mix. Only some
/// frames (RenderOptions::frames) go straight to NAME/, beside others of the same resolved scene.
/// Throws Error; files under a final name are whole then, too.
RenderResult renderClip(const scene::Scene& scene, const ClipMotion& motion,
                        const RenderOptions& options, const RenderListener& listener);

/// Draws the frames of `range` into each of `sinks` on threads of their own; returns how many were
/// drawn before `stop`. Sinks are not finished. Throws the first error that drawing or any sink ran
/// into.
struct SinkThreads {
  FrameSink& sink;
  int threads = 1;
};
std::int64_t drawFrames(FrameDrawer& drawer, FrameRange range,
                        const std::vector<SinkThreads>& sinks, const std::atomic<bool>* stop,
                        const std::function<void(RenderProgress)>& progress);

}  // namespace rotatebook::pipeline
