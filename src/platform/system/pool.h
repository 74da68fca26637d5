// A fixed set of things that go round, so that memory doesn't grow with the clip.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace rotatebook::system {

/// Lends things and takes them back when their last owner lets go. It must outlive what it lends.
template <typename T>
class Pool {
 public:
  /// `count` > 0 copies of `pattern`.
  Pool(const T& pattern, int count) {
    for (int i = 0; i < count; ++i) {
      items_.push_back(std::make_unique<T>(pattern));
      free_.push_back(items_.back().get());
    }
  }

  /// A item with any content; waits until one is free. This is what slows a stage down to the pace
  /// of those after it.
  std::shared_ptr<T> take() {
    T* item = waitForOne();
    return {item, [this](T* returned) { giveBack(returned); }};
  }

 private:
  T* waitForOne() {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [this] { return !free_.empty(); });
    T* item = free_.back();
    free_.pop_back();
    return item;
  }

  void giveBack(T* item) {
    // Woken under the lock: whoever waits may destroy this pool as soon as it is let go.
    const std::lock_guard lock(mutex_);
    free_.push_back(item);
    freed_.notify_one();
  }

  std::vector<std::unique_ptr<T>> items_;
  std::mutex mutex_;
  std::condition_variable freed_;
  std::vector<T*> free_;
};

}  // namespace rotatebook::system
