#include "farm/submission.h"

#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "farm/plan_folder.h"
#include "farm/progress.h"
#include "system/atomic_file.h"

namespace rotatebook::farm {
namespace {

/// Returns the jobs of which something is still in the queue.
std::vector<std::string> queuedOf(const std::vector<QueuedJob>& queue) {
  std::set<std::string> queued;
  for (const QueuedJob& job : queue)
    if (job.isActive() || job.isHeld()) queued.insert(job.job);
  return {queued.begin(), queued.end()};
}

/// Returns how two plans differ that don't do the same.
std::string differenceOf(const Plan& earlier, const Plan& plan) {
  if (earlier.build != plan.build) return "this program has changed since";
  for (const PlannedScene& scene : plan.scenes) {
    const auto same = std::ranges::find(earlier.scenes, scene.file, &PlannedScene::file);
    if (same == earlier.scenes.end()) continue;
    if (same->checksum != scene.checksum) return scene.file.string() + " has changed since";
  }
  return isSameWork(earlier, plan) ? "it has other parts" : "it has other scenes or options";
}

/// Cancels jobs after an error; rethrows it, with what is left in the queue.
[[noreturn]] void failAndCancel(const Error& error, const std::vector<std::string>& jobs) {
  const auto problem = cancelJobs(jobs);
  const std::string all = joined(jobs, " ");
  std::string left = "; what was sent already is cancelled";
  if (problem)
    left = fmt::format(
        "; job {0} was sent already and can't be cancelled ({1}): cancel it with scancel {0}", all,
        *problem);
  if (error.kind() == ErrorKind::Input) throw InputError(error.what() + left);
  throw MachineError(error.what() + left, error.kind());
}

/// The jobs that are left of earlier submissions.
struct EarlierJobs {
  std::vector<std::string> arrays{};  ///< Arrays with tasks that are yet to end.
  std::set<std::int64_t> tasks{};     ///< The tasks of these.
  std::vector<std::string> held{};  ///< Tasks that the cluster has given up, and a join waits for.
  bool hasJoin = false;             ///< The join is yet to end,
  bool joins = false;               ///< and has begun: it makes what is missing.
};

EarlierJobs earlierJobs(const Jobs& jobs) {
  EarlierJobs earlier;
  for (const QueuedJob& job : readQueue(jobs.all())) {
    if (job.isHeld()) earlier.held.push_back(job.name());
    if (!job.isActive()) continue;
    if (job.job == jobs.join) {
      earlier.hasJoin = true;
      earlier.joins = job.isRunning();
      continue;
    }
    earlier.tasks.insert(job.task);
    if (std::ranges::count(earlier.arrays, job.job) == 0) earlier.arrays.push_back(job.job);
  }
  return earlier;
}

/// Cancels earlier jobs that the new ones, or those in the queue, replace.
void cancelEarlier(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return;
  const auto problem = cancelJobs(jobs);
  if (!problem) return;
  const std::string all = joined(jobs, " ");
  throw MachineError(
      fmt::format("can't cancel job {0} of an earlier submission: {1}; cancel it with scancel {0}",
                  all, *problem));
}

/// Sends the array of `sent` and the join after it; returns their numbers. The plan on the disk
/// knows each as soon as it is sent.
void sendAll(StoredPlan& stored, const PlanFiles& files, const EarlierJobs& earlier, bool sendsJoin,
             Submission& submission) {
  const std::string oldJoin = earlier.hasJoin ? stored.jobs.join : "";
  stored.jobs = {earlier.arrays, oldJoin};
  if (!submission.sent.empty()) {
    submission.array = sendJob(files.partScript, {});
    stored.jobs.arrays.push_back(submission.array);
  }
  try {
    writePlan(files, stored);
    if (sendsJoin) {
      submission.join = sendJob(files.joinScript, stored.jobs.arrays);
      stored.jobs.join = submission.join;
      writePlan(files, stored);
    }
  } catch (const Error& error) {
    std::vector<std::string> sent{submission.array, submission.join};
    std::erase(sent, "");
    if (sent.empty()) throw;
    failAndCancel(error, sent);
  }
  std::vector<std::string> replaced = earlier.held;
  // First the join, which would begin where it waits for those that are held
  if (sendsJoin && !oldJoin.empty()) replaced.insert(replaced.begin(), oldJoin);
  cancelEarlier(replaced);
}

}  // namespace

std::optional<StoredPlan> continued(const Plan& plan, const PlanFiles& files) {
  const auto earlier = readPlan(files);
  if (earlier && isSameWork(earlier->plan, plan)) return earlier;
  if (earlier) requireNoneQueued(*earlier, plan);
  requireSameResults(plan);
  return std::nullopt;
}

void requireNoneQueued(const StoredPlan& earlier, const Plan& plan) {
  const std::vector<std::string> queued = queuedOf(readQueue(earlier.jobs.all()));
  if (queued.empty()) return;
  throw InputError(
      fmt::format("an earlier submission into {} is still in the queue, and {}; cancel it (scancel "
                  "{}), or submit into another folder with -o",
                  plan.folder.string(), differenceOf(earlier.plan, plan), joined(queued, " ")));
}

namespace {

std::vector<Task> missingOf(const Plan& plan, const std::vector<SceneProgress>& progress) {
  std::vector<Task> missing;
  for (const Task& task : tasksOf(plan))
    if (!isDone(plan, task, progress)) missing.push_back(task);
  return missing;
}

/// Returns whether an earlier task makes what this one would, or a join that runs.
bool isQueued(const Plan& plan, const Task& task, const EarlierJobs& earlier) {
  const bool isJoined = !makesWholeClips(plan, task);
  return (earlier.joins && isJoined) || earlier.tasks.contains(task.number);
}

}  // namespace

std::vector<Task> missingTasks(const Plan& plan, const PlanFiles& files) {
  return missingOf(plan, progressOf(plan, files));
}

bool isMade(const Plan& plan, const PlanFiles& files) {
  return std::ranges::all_of(progressOf(plan, files), &SceneProgress::isWhole);
}

Submission submit(StoredPlan stored, const PlanFiles& files, const JobOptions& options,
                  const ClusterLimits& limits) {
  const Plan& plan = stored.plan;
  system::createFolders(files.folder);
  const system::AdvisoryLock lock(files.plan, system::Lock::Exclusive);
  const auto there = readPlan(files);
  if (there && there->plan == plan) stored.jobs = there->jobs;
  storePlan(files, stored);

  // Find out what is there, and what is on its way
  Submission submission;
  submission.tasks = std::ssize(tasksOf(plan));
  const EarlierJobs earlier = earlierJobs(stored.jobs);
  const std::vector<SceneProgress> progress = progressOf(plan, files);
  const std::vector<Task> missing = missingOf(plan, progress);
  submission.done = submission.tasks - std::ssize(missing);
  for (const Task& task : missing)
    isQueued(plan, task, earlier) ? void(++submission.queued)
                                  : submission.sent.push_back(task.number);
  submission.isWhole = std::ranges::all_of(progress, &SceneProgress::isWhole);
  const bool wantsJoin = !areJoined(plan, progress);
  const bool isSent =
      submission.isWhole || (submission.sent.empty() && (earlier.hasJoin || !wantsJoin));

  // Send the rest
  if (isSent) {
    cancelEarlier(earlier.held);
    return submission;
  }
  if (!submission.sent.empty()) {
    system::writeFileAtomically(
        files.partScript, jobScript(plan, files, submission.sent, options, limits.requeues75));
  }
  system::writeFileAtomically(files.joinScript,
                              jobScript(plan, files, {}, options, limits.requeues75));
  sendAll(stored, files, earlier, wantsJoin && !earlier.joins, submission);
  return submission;
}

}  // namespace rotatebook::farm
