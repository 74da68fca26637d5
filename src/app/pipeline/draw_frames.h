// Frames, drawn and handed to sinks that run beside the drawing.
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

/// Told before the first frame and after each one.
struct RenderProgress {
  std::int64_t done = 0;
  std::int64_t total = 0;
};

struct FramesToDraw {
  store::FrameRange range;
  /// Frames that are intact there aren't drawn again. May be null.
  const store::FrameChecksums* kept = nullptr;
  /// Set from outside, e.g. by a signal handler, to stop after the frame in hand. May be null.
  const std::atomic<bool>* stop = nullptr;
};

struct SinkThreads {
  FrameSink& sink;
  int threads = 1;
  bool wantsKept = true;  ///< Whether it takes frames that aren't drawn again, too.
};

struct DrawnCount {
  std::int64_t drawn = 0;
  std::int64_t kept = 0;

  std::int64_t total() const { return drawn + kept; }
};

/// Draws frames into each of `sinks` on threads of their own; returns how many there were before
/// `stop`. Sinks are not finished. Throws the first error that drawing or any sink ran into.
DrawnCount drawFrames(picture::FramePainter& painter, const FramesToDraw& frames,
                      const std::vector<SinkThreads>& sinks,
                      const std::function<void(RenderProgress)>& progress);

}  // namespace rotatebook::pipeline
