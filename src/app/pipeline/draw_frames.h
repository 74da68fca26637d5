// Drawing of frames into sinks that run on threads of their own. Inside the room only.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "picture/frame_painter.h"
#include "pipeline/frame_sink.h"
#include "store/clip_files.h"
#include "store/frame_checksums.h"

namespace rotatebook::pipeline {

/// Progress, reported before the first frame and after each one. [frames]
struct RenderProgress {
  std::int64_t done = 0;
  std::int64_t total = 0;
};

/// The frames to draw, except for those that an earlier run left.
struct FramesToDraw {
  store::FrameRange range;
  /// Frames that are intact in its folder aren't drawn again. May be null.
  const store::FrameChecksums* kept = nullptr;
  /// Set by others, such as a signal handler, to stop after the current frame. May be null.
  const std::atomic<bool>* stop = nullptr;
};

/// A sink and the number of threads that write to it.
struct SinkThreads {
  FrameSink& sink;
  int threads = 1;
  bool wantsKept = true;  ///< True if it also takes frames that aren't drawn again.
};

/// Numbers of frames that were drawn, and kept from an earlier run.
struct DrawnCount {
  std::int64_t drawn = 0;
  std::int64_t kept = 0;

  std::int64_t total() const { return drawn + kept; }
};

/// Draws frames into each of `sinks`, which run on threads of their own, and returns how many it
/// handled before `stop` was set. Doesn't finish the sinks. Throws the first error of the painter
/// or a sink.
DrawnCount drawFrames(picture::FramePainter& painter, const FramesToDraw& frames,
                      const std::vector<SinkThreads>& sinks,
                      const std::function<void(RenderProgress)>& progress);

}  // namespace rotatebook::pipeline
