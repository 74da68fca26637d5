// Threads that feed frames to a sink. Inside the room only.
#pragma once

#include <cstdint>
#include <memory>

#include "image/image.h"
#include "pipeline/frame_sink.h"
#include "system/workers.h"

namespace rotatebook::pipeline {

/// A finished frame, shared by the sinks.
struct Frame {
  std::int64_t index = 0;
  std::shared_ptr<const image::Image> picture;
};

/// Feeds frames to one sink.
class FrameWorkers : public system::Workers<Frame> {
 public:
  /// `threadCount` may exceed 1 only if `sink` allows concurrent writes. `sink` must outlive this.
  FrameWorkers(FrameSink& sink, int threadCount, system::FirstError& error)
      : Workers([&sink](const Frame& frame) { sink.write(frame.index, frame.picture->view()); },
                threadCount, error) {}
};

}  // namespace rotatebook::pipeline
