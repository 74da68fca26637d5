#include "pipeline/picture_pool.h"

namespace rotatebook::pipeline {

PicturePool::PicturePool(const image::Image& pattern, int count) {
  for (int i = 0; i < count; ++i) {
    pictures_.push_back(std::make_unique<image::Image>(pattern));
    free_.push_back(pictures_.back().get());
  }
}

std::shared_ptr<image::Image> PicturePool::take() {
  std::unique_lock lock(mutex_);
  freed_.wait(lock, [this] { return !free_.empty(); });
  image::Image* picture = free_.back();
  free_.pop_back();
  return {picture, [this](image::Image* returned) { giveBack(returned); }};
}

void PicturePool::giveBack(image::Image* picture) {
  // Woken under the lock: whoever waits may destroy this pool as soon as it is let go.
  const std::lock_guard lock(mutex_);
  free_.push_back(picture);
  freed_.notify_one();
}

}  // namespace rotatebook::pipeline
