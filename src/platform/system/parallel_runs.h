// Independent runs, distributed over threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>

namespace rotatebook::system {

/// Threads, stop and progress of runParallel().
struct RunOptions {
  int threads = 0;  ///< Number of threads; 0 for one per core of the machine.
  /// Once set, for example by a signal handler, no more runs begin. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called on the caller's thread: at the start, at intervals, and at the end.
  std::function<void(std::size_t done, std::size_t total)> progress{};
};

/// Calls `run` once with each of `indices`, begun in their order, several at a time. Returns
/// whether all runs were made, false after a stop. Throws the first error that a run threw; no more
/// runs begin after it.
bool runParallel(std::span<const std::size_t> indices, const std::function<void(std::size_t)>& run,
                 const RunOptions& options);

}  // namespace rotatebook::system
