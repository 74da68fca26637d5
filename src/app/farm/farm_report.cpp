#include "farm/farm_report.h"

#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/ostream.h>

#include "base/json.h"
#include "base/text.h"

namespace rotatebook::farm {
namespace {

using Kind = TaskState::Kind;

/// The most tasks of a kind that are listed one by one.
constexpr int kMaxListed = 20;

/// Returns "45 s", "12 min" or "3 h 5 min".
std::string timeText(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 120) return fmt::format("{} s", whole);
  const std::int64_t minutes = (whole + 59) / 60;
  if (minutes < 120) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

void printTask(const TaskState& task, std::ostream& out) {
  fmt::print(out, "  {}: {}", nameOf(task.kind), oneLine(task.name));
  if (!task.node.empty()) fmt::print(out, " on {}", oneLine(task.node));
  if (task.kind == Kind::Running)
    fmt::print(out, " for {}", timeText(static_cast<double>(task.seconds)));
  if (!task.reason.empty()) fmt::print(out, ", {}", oneLine(task.reason));
  if (task.kind == Kind::Failed) fmt::print(out, " ({})", oneLine(task.log.string()));
  out << '\n';
}

void printTasks(const PlanState& state, Kind kind, std::ostream& out) {
  int listed = 0;
  for (const TaskState& task : state.tasks) {
    if (task.kind == kind && ++listed <= kMaxListed) printTask(task, out);
  }
  if (listed > kMaxListed) fmt::print(out, "  {}: {} more\n", nameOf(kind), listed - kMaxListed);
}

void printWaiting(const PlanState& state, std::ostream& out) {
  const std::int64_t waiting = state.count(Kind::Waiting);
  if (waiting == 0) return;
  std::string reason;
  for (const TaskState& task : state.tasks)
    if (task.kind == Kind::Waiting && reason.empty()) reason = task.reason;
  fmt::print(out, "  waiting: {}{}\n", countText(waiting, "task"),
             reason.empty() ? "" : fmt::format(" ({})", reason));
}

void printState(const PlanState& state, std::ostream& out) {
  for (const SceneState& scene : state.scenes) {
    fmt::print(out, "{} of {}: {}\n", nameOf(state.plan.work), oneLine(scene.name),
               scene.isWhole ? "done"
                             : fmt::format("{} of {} {} are there", scene.done, scene.units,
                                           unitsOf(state.plan.work)));
  }
  fmt::print(out, "  done: {} of {}\n", state.count(Kind::Done),
             countText(std::ssize(state.tasks), "task"));
  printTasks(state, Kind::Running, out);
  printWaiting(state, out);
  printTasks(state, Kind::Failed, out);
  if (state.join && state.join->kind != Kind::Done) printTask(*state.join, out);
  if (state.remaining) fmt::print(out, "  the tasks end in about {}\n", timeText(*state.remaining));
  if (!state.queueProblem.empty())
    fmt::print(out, "  who runs what isn't known: {}\n", state.queueProblem);
  if (state.hasFailed()) out << "  the same 'rotatebook submit' sends what is missing once more\n";
}

Json taskJson(const TaskState& task) {
  Json object;
  object["name"] = task.name;
  object["state"] = nameOf(task.kind);
  object["node"] = orNull(task.node);
  object["reason"] = orNull(task.reason);
  if (task.kind == Kind::Running) object["seconds"] = task.seconds;
  object["log"] = orNull(task.log.string());
  return object;
}

Json sceneStateJson(const SceneState& scene) {
  return Json{
      {"name", scene.name}, {"done", scene.done}, {"units", scene.units}, {"whole", scene.isWhole}};
}

Json stateJson(const PlanState& state) {
  return {{"command", nameOf(state.plan.work)},
          {"folder", state.plan.folder.string()},
          {"whole", state.isWhole()},
          {"failed", state.hasFailed()},
          {"remaining_s", orNull(state.remaining)},
          {"queue_problem", orNull(state.queueProblem)},
          {"jobs", state.jobs.arrays},
          {"join_job", orNull(state.jobs.join)},
          {"scenes", arrayOf(state.scenes, sceneStateJson)},
          {"tasks", arrayOf(state.tasks, taskJson)},
          {"join", state.join ? taskJson(*state.join) : Json()}};
}

}  // namespace

void reportSubmission(const Plan& plan, const Submission& submission, std::ostream& out) {
  if (submission.isWhole) {
    fmt::print(out, "all results are in {}; nothing was sent\n", oneLine(plan.folder.string()));
    return;
  }
  if (submission.done > 0) {
    fmt::print(out, "{} of {} {} done before\n", countText(submission.done, "task"),
               submission.tasks, submission.done == 1 ? "was" : "were");
  }
  if (submission.queued > 0) {
    fmt::print(out, "{} {} in the queue already\n", countText(submission.queued, "task"),
               submission.queued == 1 ? "is" : "are");
  }
  if (!submission.array.empty()) {
    fmt::print(out, "sent {} as job {}\n", countText(std::ssize(submission.sent), "task"),
               submission.array);
  }
  if (!submission.join.empty())
    fmt::print(out, "sent job {}, which joins the results after them\n", submission.join);
  if (submission.array.empty() && submission.join.empty()) out << "nothing was sent\n";
  fmt::print(out, "see rotatebook status {}\n", oneLine(shellWord(plan.folder.string())));
}

void reportStates(const std::vector<PlanState>& states, std::ostream& out) {
  for (const PlanState& state : states) printState(state, out);
}

void reportStatesAsJson(const std::vector<PlanState>& states, std::ostream& out) {
  out << jsonLine({{"plans", arrayOf(states, stateJson)}});
}

}  // namespace rotatebook::farm
