// A stage of the pipeline on threads of its own.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "system/first_error.h"

namespace rotatebook::system {

/// Works through a queue of items. The pool that the items come from limits its length.
template <typename Item>
class Workers {
 public:
  /// Starts the threads. Once any thread has set `error`, items are released without work.
  Workers(std::function<void(const Item&)> work, int threadCount, FirstError& error)
      : work_(std::move(work)), error_(error) {
    try {
      for (int i = 0; i < threadCount; ++i) threads_.emplace_back([this] { run(); });
    } catch (...) {
      drain();
      throw;
    }
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  /// Waits for the threads, which first work through the queue.
  ~Workers() { drain(); }

  /// Queues an item. Items are taken in the order of these calls.
  void submit(Item item) {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(item));
    changed_.notify_one();
  }

  /// Waits until all items are worked on, or released after an error, and ends the threads.
  void drain() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
      changed_.notify_all();
    }
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

 private:
  /// Waits for the next item; returns false once the queue is closed and empty.
  bool next(Item& item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || !queue_.empty(); });
    if (queue_.empty()) return false;
    item = std::move(queue_.front());
    queue_.pop_front();
    return true;
  }

  void run() {
    for (Item item; next(item); item = Item()) {
      if (error_.isSet()) continue;
      try {
        work_(item);
      } catch (...) {
        error_.set(std::current_exception());
      }
    }
  }

  std::function<void(const Item&)> work_;
  FirstError& error_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> queue_;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace rotatebook::system
