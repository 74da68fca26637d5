// A sink on threads of its own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "image/image.h"
#include "pipeline/frame_sink.h"

namespace rotatebook::pipeline {

/// A finished frame, shared by the sinks.
struct Frame {
  std::int64_t index = 0;
  std::shared_ptr<const image::Image> picture;
};

/// Keeps the first of the errors that threads run into.
class FirstError {
 public:
  /// Keeps `error` unless there is one already.
  void set(std::exception_ptr error);
  bool isSet();
  /// Throws the error that is kept, if any.
  void rethrow();

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
};

/// Feeds one sink from a queue. The queue is as long as there are pictures in the pool that the
/// frames come from.
class FrameWorkers {
 public:
  /// More than one thread only for a sink that allows concurrent writes. Once `error` is set, by
  /// whichever thread, frames are let go unwritten.
  FrameWorkers(FrameSink& sink, int threadCount, FirstError& error);
  FrameWorkers(const FrameWorkers&) = delete;
  FrameWorkers& operator=(const FrameWorkers&) = delete;
  /// Waits for the threads; what is queued is still written.
  ~FrameWorkers();

  /// Queues a frame; one thread's frames are written in the order of this call.
  void submit(Frame frame);
  /// Waits until all frames are written, or let go after an error.
  void drain();

 private:
  void work();
  /// False once the queue is closed and empty.
  bool next(Frame& frame);

  FrameSink& sink_;
  FirstError& error_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Frame> queue_;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace rotatebook::pipeline
