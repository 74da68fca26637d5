// A fixed set of items to be reused, so that memory doesn't grow with the clip.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace rotatebook::system {

/// Lends items and takes each back when its last owner releases it. Must outlive what it lends.
template <typename T>
class Pool {
 public:
  /// Holds `count` > 0 items that `make` returns.
  template <typename Make>
  Pool(const Make& make, int count) {
    for (int i = 0; i < count; ++i) {
      items_.push_back(std::make_unique<T>(make()));
      free_.push_back(items_.back().get());
    }
  }

  /// Returns an item with arbitrary content; waits until one is free, which slows a stage down to
  /// the pace of the stages after it.
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
    // Notified under the lock: the waiting thread may destroy this pool once the lock is free.
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
