#include "system/parallel_runs.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "system/first_error.h"
#include "system/machine.h"

namespace rotatebook::system {
namespace {

// Longest interval between reports of progress, during long runs too.
constexpr auto kWatchInterval = std::chrono::milliseconds(50);

class Runs {
 public:
  Runs(std::span<const std::size_t> indices, const std::function<void(std::size_t)>& run,
       const RunOptions& options)
      : indices_(indices), run_(run), options_(options) {}

  bool finishAll() {
    std::vector<std::jthread> threads;
    running_ = threadCount();
    for (int i = running_; i > 0; --i) threads.emplace_back([this] { work(); });
    watch();
    threads.clear();
    error_.rethrow();
    return done_ == indices_.size();
  }

 private:
  int threadCount() const {
    const int wanted = options_.threads > 0 ? options_.threads : coreCount();
    return std::min(wanted, static_cast<int>(indices_.size()));
  }

  bool stopped() { return (options_.stop != nullptr && *options_.stop) || error_.isSet(); }

  void work() {
    for (std::size_t n = next_++; n < indices_.size() && !stopped(); n = next_++) {
      try {
        run_(indices_[n]);
        const std::lock_guard lock(mutex_);
        ++done_;
      } catch (...) {
        error_.set(std::current_exception());
      }
      changed_.notify_one();
    }
    const std::lock_guard lock(mutex_);
    --running_;
    changed_.notify_one();
  }

  // Reports progress, on the caller's thread, until the others are done.
  void watch() {
    std::unique_lock lock(mutex_);
    while (true) {
      const std::size_t done = done_;
      const bool over = running_ == 0;
      lock.unlock();
      if (options_.progress) options_.progress(done, indices_.size());
      if (over) return;
      lock.lock();
      changed_.wait_for(lock, kWatchInterval, [&] { return done_ != done || running_ == 0; });
    }
  }

  std::span<const std::size_t> indices_;
  const std::function<void(std::size_t)>& run_;
  const RunOptions& options_;
  FirstError error_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t done_ = 0;  // done_ and running_ are guarded by mutex_
  int running_ = 0;
};

}  // namespace

bool runParallel(std::span<const std::size_t> indices, const std::function<void(std::size_t)>& run,
                 const RunOptions& options) {
  return Runs(indices, run, options).finishAll();
}

}  // namespace rotatebook::system
