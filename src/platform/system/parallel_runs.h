// Independent runs, shared out among threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>

namespace rotatebook::system {

/// How runs are made, and who hears of them.
struct RunOptions {
  int threads = 0;  ///< 0 for as many as the machine has cores.
  /// Set from outside, e.g. by a signal handler, to begin no more runs. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Told on the caller's thread, before the first run and after some of them.
  std::function<void(std::size_t done, std::size_t total)> progress{};
};

/// Calls `run` once with each of `indices`, taken in their order; several calls go on at a time.
/// Returns whether all were made: not after a stop. Throws the first error that a run threw, and
/// then makes no more.
bool runParallel(std::span<const std::size_t> indices, const std::function<void(std::size_t)>& run,
                 const RunOptions& options);

}  // namespace rotatebook::system
