// The commands of Slurm: limits of a cluster, its queue, sending and cancelling of jobs. Inside the
// room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::farm {

/// The limits of a cluster.
struct ClusterLimits {
  std::int64_t arraySize = 1001;  ///< MaxArraySize: a task's number is below it.
  std::int64_t arrayTasks = 0;    ///< max_array_tasks of SchedulerParameters; 0 if there is none.
  std::int64_t jobs = 10'000;     ///< MaxJobCount
  bool requeues75 = false;        ///< RequeueExit has the exit status 75 tried again.

  /// Returns the most tasks of an array that, with its join, may be sent at once.
  std::int64_t maxTasks() const;
};

/// A job, or a task of an array, that the cluster knows.
struct QueuedJob {
  std::string job;           ///< Of the whole array.
  std::int64_t task = 0;     ///< 0 if it isn't one of an array.
  std::string state;         ///< "PENDING", "RUNNING", "COMPLETED" ...
  std::int64_t seconds = 0;  ///< Since it began.
  std::string node;          ///< The one that runs it, or ran it.
  std::string reason;        ///< Why it waits.

  /// Returns whether it is yet to end, and goes on by itself.
  bool isActive() const;
  /// Returns whether the cluster has given it up: it waits until somebody releases or cancels it.
  bool isHeld() const;
  /// Returns what scancel calls it.
  std::string name() const;
  /// Returns whether it has begun, and not ended.
  bool isRunning() const;
};

// Readers of what Slurm prints.

/// Returns the limits in what `scontrol show config` prints.
ClusterLimits parseLimits(std::string_view config);
/// Returns the jobs in what squeue prints with kQueueFormat.
std::vector<QueuedJob> parseQueue(std::string_view lines);
inline constexpr const char* kQueueFormat = "%F|%K|%T|%M|%N|%r";
/// Returns the processors of nodes that aren't down, in what `sinfo -o "%P|%C"` prints, of the
/// partition or, if that is empty, of the default one. Throws InputError for one that isn't there.
std::int64_t parseProcessors(std::string_view lines, const std::string& partition);

// Slurm's commands. Each throws MachineError if there is no Slurm here or its controller doesn't
// answer, and InputError, with what Slurm says, for what it refuses.

ClusterLimits readLimits();
/// Returns the processors of a partition, or of the default one; refuses one that isn't there.
std::int64_t countProcessors(const std::string& partition);
/// Sends the script; returns the job's number. It begins once all tasks of the jobs `after` have
/// ended, in whatever way.
std::string sendJob(const std::filesystem::path& script, const std::vector<std::string>& after);
/// Returns what the cluster knows of these jobs: nothing once it has forgotten them.
std::vector<QueuedJob> readQueue(const std::vector<std::string>& jobs);
/// Cancels jobs; returns why that failed, or nothing.
std::optional<std::string> cancelJobs(const std::vector<std::string>& jobs);

}  // namespace rotatebook::farm
