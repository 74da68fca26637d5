#include "farm/farm_report.h"

#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/core.h>

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
  out << "  " << nameOf(task.kind) << ": " << oneLine(task.name);
  if (!task.node.empty()) out << " on " << oneLine(task.node);
  if (task.kind == Kind::Running) out << " for " << timeText(static_cast<double>(task.seconds));
  if (!task.reason.empty()) out << ", " << oneLine(task.reason);
  if (task.kind == Kind::Failed) out << " (" << oneLine(task.log.string()) << ')';
  out << '\n';
}

void printTasks(const PlanState& state, Kind kind, std::ostream& out) {
  int listed = 0;
  for (const TaskState& task : state.tasks) {
    if (task.kind == kind && ++listed <= kMaxListed) printTask(task, out);
  }
  if (listed > kMaxListed) out << "  " << nameOf(kind) << ": " << listed - kMaxListed << " more\n";
}

void printWaiting(const PlanState& state, std::ostream& out) {
  const std::int64_t waiting = state.count(Kind::Waiting);
  if (waiting == 0) return;
  std::string reason;
  for (const TaskState& task : state.tasks)
    if (task.kind == Kind::Waiting && reason.empty()) reason = task.reason;
  out << "  waiting: " << countText(waiting, "task") << (reason.empty() ? "" : " (" + reason + ")")
      << '\n';
}

void printState(const PlanState& state, std::ostream& out) {
  for (const SceneState& scene : state.scenes) {
    out << nameOf(state.plan.work) << " of " << oneLine(scene.name) << ": ";
    if (scene.isWhole) {
      out << "done\n";
    } else {
      out << scene.done << " of " << scene.units << ' ' << unitsOf(state.plan.work)
          << " are there\n";
    }
  }
  out << "  done: " << state.count(Kind::Done) << " of "
      << countText(std::ssize(state.tasks), "task") << '\n';
  printTasks(state, Kind::Running, out);
  printWaiting(state, out);
  printTasks(state, Kind::Failed, out);
  if (state.join && state.join->kind != Kind::Done) printTask(*state.join, out);
  if (state.remaining) out << "  the tasks end in about " << timeText(*state.remaining) << '\n';
  if (!state.queueProblem.empty())
    out << "  who runs what isn't known: " << state.queueProblem << '\n';
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

Json sceneJson(const SceneState& scene) {
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
          {"scenes", arrayOf(state.scenes, sceneJson)},
          {"tasks", arrayOf(state.tasks, taskJson)},
          {"join", state.join ? taskJson(*state.join) : Json()}};
}

}  // namespace

void reportSubmission(const Plan& plan, const Submission& submission, std::ostream& out) {
  if (submission.isWhole) {
    out << "all results are in " << oneLine(plan.folder.string()) << "; nothing was sent\n";
    return;
  }
  if (submission.done > 0) {
    out << countText(submission.done, "task") << " of " << submission.tasks
        << (submission.done == 1 ? " was" : " were") << " done before\n";
  }
  if (submission.queued > 0) {
    out << countText(submission.queued, "task") << (submission.queued == 1 ? " is" : " are")
        << " in the queue already\n";
  }
  if (!submission.array.empty()) {
    out << "sent " << countText(std::ssize(submission.sent), "task") << " as job "
        << submission.array << '\n';
  }
  if (!submission.join.empty())
    out << "sent job " << submission.join << ", which joins the results after them\n";
  if (submission.array.empty() && submission.join.empty()) out << "nothing was sent\n";
  out << "see rotatebook status " << oneLine(shellWord(plan.folder.string())) << '\n';
}

void reportStates(const std::vector<PlanState>& states, std::ostream& out) {
  for (const PlanState& state : states) printState(state, out);
}

void reportStatesAsJson(const std::vector<PlanState>& states, std::ostream& out) {
  out << jsonText({{"plans", arrayOf(states, stateJson)}}) << '\n';
}

}  // namespace rotatebook::farm
