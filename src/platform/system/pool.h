// A fixed set of things that go round, so that memory doesn't grow with the clip.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace rotatebook::system {

/// Lends things and takes them back when their last owner lets go. It must outlive what it lends.
template <typename Thing>
class Pool {
 public:
  /// `count` > 0 copies of `pattern`.
  Pool(const Thing& pattern, int count) {
    for (int i = 0; i < count; ++i) {
      things_.push_back(std::make_unique<Thing>(pattern));
      free_.push_back(things_.back().get());
    }
  }

  /// A thing with any content; waits until one is free. This is what slows a stage down to the pace
  /// of those after it.
  std::shared_ptr<Thing> take() {
    Thing* thing = waitForOne();
    return {thing, [this](Thing* returned) { giveBack(returned); }};
  }

 private:
  Thing* waitForOne() {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [this] { return !free_.empty(); });
    Thing* thing = free_.back();
    free_.pop_back();
    return thing;
  }

  void giveBack(Thing* thing) {
    // Woken under the lock: whoever waits may destroy this pool as soon as it is let go.
    const std::lock_guard lock(mutex_);
    free_.push_back(thing);
    freed_.notify_one();
  }

  std::vector<std::unique_ptr<Thing>> things_;
  std::mutex mutex_;
  std::condition_variable freed_;
  std::vector<Thing*> free_;
};

}  // namespace rotatebook::system
