#include "pipeline/frame_workers.h"

#include <utility>

namespace rotatebook::pipeline {

void FirstError::set(std::exception_ptr error) {
  const std::lock_guard lock(mutex_);
  if (!error_) error_ = std::move(error);
}

bool FirstError::isSet() {
  const std::lock_guard lock(mutex_);
  return error_ != nullptr;
}

void FirstError::rethrow() {
  const std::lock_guard lock(mutex_);
  if (error_) std::rethrow_exception(error_);
}

FrameWorkers::FrameWorkers(FrameSink& sink, int threadCount, FirstError& error)
    : sink_(sink), error_(error) {
  for (int i = 0; i < threadCount; ++i) threads_.emplace_back([this] { work(); });
}

FrameWorkers::~FrameWorkers() {
  drain();
}

void FrameWorkers::submit(Frame frame) {
  const std::lock_guard lock(mutex_);
  queue_.push_back(std::move(frame));
  changed_.notify_one();
}

void FrameWorkers::drain() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

bool FrameWorkers::next(Frame& frame) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || !queue_.empty(); });
  if (queue_.empty()) return false;
  frame = std::move(queue_.front());
  queue_.pop_front();
  return true;
}

void FrameWorkers::work() {
  for (Frame frame; next(frame); frame.picture.reset()) {
    if (error_.isSet()) continue;
    try {
      sink_.write(frame.index, frame.picture->view());
    } catch (...) {
      error_.set(std::current_exception());
    }
  }
}

}  // namespace rotatebook::pipeline
