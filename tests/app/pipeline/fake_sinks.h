// Sinks that tell what they were given, are slow, or fail.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "image/image.h"
#include "pipeline/frame_sink.h"

namespace rotatebook::pipeline::testing {

/// Exception that a fake sink throws.
struct SinkFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes down what it is given; takes `pause` for each frame and fails at frame `failAt`.
class FakeSink : public FrameSink {
 public:
  explicit FakeSink(std::string name = "sink", std::int64_t failAt = -1,
                    std::chrono::milliseconds pause = {})
      : name_(std::move(name)), failAt_(failAt), pause_(pause) {}

  void write(std::int64_t index, image::ImageView picture) override {
    std::this_thread::sleep_for(pause_);
    if (index == failAt_) throw SinkFailure(name_ + " fails at " + std::to_string(index));
    const std::lock_guard lock(mutex_);
    indices_.push_back(index);
    firstBytes_.push_back(picture.row(0)[0]);
    pictures_.insert(picture.topRow);
    ++written_;
  }
  void finish() override { finished_ = true; }

  /// Frames so far; may be asked from any thread.
  std::int64_t written() const { return written_; }
  bool finished() const { return finished_; }
  // To be asked once the writers are done.
  const std::vector<std::int64_t>& indices() const { return indices_; }
  const std::vector<std::uint8_t>& firstBytes() const { return firstBytes_; }
  const std::set<const std::uint8_t*>& pictures() const { return pictures_; }

 private:
  std::string name_;
  std::int64_t failAt_;
  std::chrono::milliseconds pause_;
  std::mutex mutex_;
  std::vector<std::int64_t> indices_;
  std::vector<std::uint8_t> firstBytes_;
  std::set<const std::uint8_t*> pictures_;
  std::atomic<std::int64_t> written_ = 0;
  bool finished_ = false;
};

/// first, first + 1, ... end - 1
inline std::vector<std::int64_t> numbers(std::int64_t first, std::int64_t end) {
  std::vector<std::int64_t> result;
  for (std::int64_t i = first; i < end; ++i) result.push_back(i);
  return result;
}

}  // namespace rotatebook::pipeline::testing
