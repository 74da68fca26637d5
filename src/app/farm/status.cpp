#include "farm/status.h"

#include <algorithm>
#include <map>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "farm/progress.h"
#include "farm/slurm.h"
#include "system/read_file.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;
using Kind = TaskState::Kind;

/// The jobs of a plan's tasks that the cluster knows, by task.
using Queue = std::map<std::int64_t, QueuedJob>;
constexpr std::int64_t kJoin = 0;
/// The rest of an array that was cancelled, tasks that hadn't begun: one job without a number.
constexpr std::int64_t kRest = -1;

std::int64_t taskOf(const QueuedJob& job, const Jobs& jobs) {
  if (job.job == jobs.join) return kJoin;
  return job.task > 0 ? job.task : kRest;
}

/// Returns the job of a task; null if the cluster knows none.
const QueuedJob* jobOf(std::int64_t task, const Queue& queue) {
  auto found = queue.find(task);
  if (found == queue.end() && task != kJoin) found = queue.find(kRest);
  return found != queue.end() ? &found->second : nullptr;
}

Queue queueOf(const Jobs& jobs, std::string& problem) {
  Queue queue;
  try {
    for (const QueuedJob& job : readQueue(jobs.all())) {
      QueuedJob& known = queue[taskOf(job, jobs)];
      // Of a task that was submitted again, the try that is yet to end counts
      if (known.job.empty() || job.isActive() || !known.isActive()) known = job;
    }
  } catch (const Error& error) {
    problem = error.what();
  }
  return queue;
}

/// Returns the last line that a task printed; empty if it printed none.
std::string lastLine(const fs::path& log) {
  const std::string text = system::readFileOrEmpty(log);
  const std::string_view all = trimmed(text);
  return oneLine(trimmed(all.substr(all.rfind('\n') + 1)), 300);
}

std::string failureOf(const std::optional<TaskEnd>& end, const QueuedJob* job,
                      const fs::path& log) {
  const std::string last = lastLine(log);
  const std::string says = last.empty() ? "" : ": " + last;
  if (job != nullptr && job->isHeld())
    return fmt::format("held by the cluster ({}), submit again{}", job->reason, says);
  // A job that was cancelled or ran out of time ends with some status, too
  if (job != nullptr && job->state != "COMPLETED" && job->state != "FAILED")
    return job->state + says;
  if (end && end->status == 1) return "something expected isn't met" + says;
  if (end && end->status > 0) return fmt::format("exit status {}{}", end->status, says);
  return "its results aren't there" + says;
}

/// The knowledge of a plan's tasks beside their results.
struct Known {
  const Jobs& jobs;
  const PlanFiles& files;
  std::map<std::int64_t, TaskEnd> ends{};
  std::string queueProblem{};
  Queue queue{};

  std::optional<TaskEnd> endOf(std::int64_t task) const {
    const auto found = ends.find(task);
    return found != ends.end() ? std::optional(found->second) : std::nullopt;
  }

  /// Returns whether a task that isn't in the queue, and whose results are missing, has failed.
  bool hasFailed(std::int64_t task, const std::optional<TaskEnd>& end) const {
    const bool wasSent = task == kJoin ? !jobs.join.empty() : !jobs.arrays.empty();
    // All that are missing were sent, and a cluster forgets a job minutes after its end.
    return (queueProblem.empty() && wasSent) || (end && end->status != 0);
  }
};

/// Returns the state of a task, or of the join.
TaskState stateOfTask(std::int64_t number, bool isDone, const Known& known) {
  TaskState state;
  const QueuedJob* job = jobOf(number, known.queue);
  const auto end = known.endOf(number);
  const bool isActive = job != nullptr && job->isActive();
  if (isActive && job->isRunning()) {
    state.kind = Kind::Running;
    state.node = job->node;
    state.seconds = job->seconds;
    state.log = known.files.logOf(number);
  } else if (isDone && !(end && end->status == 1)) {
    state.kind = Kind::Done;
  } else if (isActive) {
    state.reason = job->reason;
  } else if (isDone || known.hasFailed(number, end)) {
    state.kind = Kind::Failed;
    state.node = end ? end->node : job != nullptr ? job->node : "";
    state.log = known.files.logOf(number);
    state.reason = failureOf(end, job, state.log);
  }
  return state;
}

/// Returns how long it takes until all is done, at the rate so far of those that run. Nothing while
/// that isn't known.
std::optional<double> remainingOf(const PlanState& state, const Known& known) {
  double spent = 0, running = 0;
  for (std::size_t i = 0; i < state.tasks.size(); ++i) {
    const bool runs = state.tasks[i].kind == Kind::Running;
    if (runs) spent += static_cast<double>(state.tasks[i].seconds), ++running;
    const auto end = known.endOf(static_cast<std::int64_t>(i) + 1);
    if (end && !runs) spent += end->seconds;
  }
  double done = 0, all = 0;
  for (const SceneState& scene : state.scenes) {
    done += static_cast<double>(scene.done);
    all += static_cast<double>(scene.units);
  }
  if (running == 0 || done == 0 || spent == 0) return std::nullopt;
  return (all - done) * (spent / done) / running;
}

/// A plan's results and tasks name its folder, wherever `results` with the plan is now.
void requireSameFolder(const Plan& plan, const fs::path& results) {
  std::error_code missing;
  if (fs::equivalent(plan.folder, results, missing)) return;
  throw InputError(
      fmt::format("{} holds the plan of {}, which is another folder or none; move it back there, "
                  "or submit again",
                  (results / "farm").string(), plan.folder.string()));
}

}  // namespace

const char* nameOf(Kind kind) {
  constexpr const char* kNames[] = {"done", "running", "waiting", "failed"};
  return kNames[static_cast<int>(kind)];
}

std::int64_t PlanState::count(Kind kind) const {
  return std::ranges::count(tasks, kind, &TaskState::kind);
}

bool PlanState::isWhole() const {
  return std::ranges::all_of(scenes, &SceneState::isWhole);
}

bool PlanState::hasFailed() const {
  return count(Kind::Failed) > 0 || (join && join->kind == Kind::Failed);
}

PlanState stateOf(const StoredPlan& stored, const PlanFiles& files) {
  const Plan& plan = stored.plan;
  PlanState state{plan, stored.jobs};
  const std::vector<SceneProgress> progress = progressOf(plan, files);
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    state.scenes.push_back(
        {plan.scenes[i].name, progress[i].count(), plan.scenes[i].units, progress[i].isWhole});
  }
  Known known{stored.jobs, files, readEnds(files)};
  known.queue = queueOf(stored.jobs, known.queueProblem);
  state.queueProblem = known.queueProblem;
  for (const Task& task : tasksOf(plan)) {
    state.tasks.push_back(stateOfTask(task.number, isDone(plan, task, progress), known));
    state.tasks.back().name = describe(plan, task);
  }
  if (!joinedScenesOf(plan).empty()) {
    state.join = stateOfTask(kJoin, areJoined(plan, progress), known);
    state.join->name = "join";
  }
  state.remaining = remainingOf(state, known);
  return state;
}

std::vector<PlanState> statesBelow(const fs::path& results) {
  std::vector<PlanState> states;
  for (const Work work : {Work::Render, Work::Map, Work::Study}) {
    const PlanFiles files = planFiles(results, work);
    const auto stored = readPlan(files);
    if (!stored) continue;
    requireSameFolder(stored->plan, results);
    states.push_back(stateOf(*stored, files));
  }
  if (!states.empty()) return states;
  throw InputError((results / "farm").string() +
                   " holds no plan; name the folder that was submit's -o");
}

}  // namespace rotatebook::farm
