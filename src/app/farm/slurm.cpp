#include "farm/slurm.h"

#include <algorithm>
#include <chrono>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/core.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "system/captured_command.h"

namespace rotatebook::farm {
namespace {

constexpr std::chrono::seconds kPatience{90};  ///< Slurm's own commands give up earlier.

/// Returns what follows `KEY =` on a line of its own; empty if there is none.
std::string valueIn(std::string_view config, std::string_view key) {
  for (const std::string& line : itemsOf(config, '\n')) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || trimmed(line.substr(0, equals)) != key) continue;
    return std::string(trimmed(line.substr(equals + 1)));
  }
  return "";
}

std::int64_t numberOr(const std::string& text, std::int64_t other) {
  std::int64_t number = 0;
  return std::istringstream(text) >> number ? number : other;
}

/// Returns whether a list like "1,70-80" has `number`.
bool holds(const std::string& list, std::int64_t number) {
  for (const std::string& range : itemsOf(list, ',')) {
    const std::size_t dash = range.find('-');
    const std::int64_t first = numberOr(range, -1);
    const std::int64_t last =
        dash == std::string::npos ? first : numberOr(range.substr(dash + 1), -1);
    if (first >= 0 && first <= number && number <= last) return true;
  }
  return false;
}

/// Returns "1-02:03:04" or "2:03" as seconds.
std::int64_t secondsIn(const std::string& text) {
  const std::size_t dash = text.find('-');
  std::int64_t seconds = 0;
  const std::string clock = dash == std::string::npos ? text : text.substr(dash + 1);
  for (const std::string& part : itemsOf(clock, ':')) seconds = seconds * 60 + numberOr(part, 0);
  return seconds + (dash == std::string::npos ? 0 : numberOr(text, 0) * 86'400);
}

/// Returns Slurm's message without the lines' beginnings, on one line.
std::string wordsOf(const std::string& problems) {
  std::vector<std::string> words;
  for (std::string line : itemsOf(problems, '\n')) {
    line = std::regex_replace(line, std::regex("^[a-z]+: (error: )?"), "");
    if (std::ranges::count(words, line) == 0) words.push_back(line);
  }
  return oneLine(joined(words, "; "), 500);
}

bool isUnreachable(const std::string& problems) {
  static const std::regex kReasons(
      "Unable to contact|ommunication|imed out|onnection|Transport|munge|DNS|zero_bytes",
      std::regex::icase);
  return std::regex_search(problems, kReasons);
}

[[noreturn]] void refuse(const std::string& command, const std::string& problems) {
  if (isUnreachable(problems)) {
    throw MachineError(
        fmt::format("{} can't reach the cluster: {}; try again when its controller runs", command,
                    wordsOf(problems)),
        ErrorKind::Transient);
  }
  const std::string words = wordsOf(problems);
  throw InputError(fmt::format("the cluster refuses ({}): {}", command,
                               words.empty() ? "it says nothing" : words));
}

std::string outputOf(const std::vector<std::string>& command) {
  const auto captured = system::capture(command, kPatience);
  if (!captured) {
    throw MachineError("there is no " + command.front() +
                       " here: submit on a machine that has Slurm, a cluster's login node; "
                       "elsewhere, --plan list or --plan parallel prints the same tasks");
  }
  if (captured->status != 0) refuse(command.front(), captured->problems);
  return captured->output;
}

[[noreturn]] void refusePartition(const std::string& partition,
                                  const std::set<std::string>& there) {
  const std::vector<std::string_view> names(there.begin(), there.end());
  throw InputError(fmt::format("--partition {}: the cluster has no such partition; it has {}{}",
                               partition, quotedList(names, "and"), didYouMean(partition, names)));
}

}  // namespace

std::int64_t ClusterLimits::maxTasks() const {
  const std::int64_t most = std::min(arraySize - 1, jobs - 1);
  return std::max<std::int64_t>(1, arrayTasks > 0 ? std::min(most, arrayTasks) : most);
}

bool QueuedJob::isActive() const {
  static const std::set<std::string> kOver{"COMPLETED", "CANCELLED",     "FAILED",   "TIMEOUT",
                                           "NODE_FAIL", "OUT_OF_MEMORY", "DEADLINE", "BOOT_FAIL",
                                           "REVOKED",   "PREEMPTED"};
  return !kOver.contains(state) && !isHeld();
}

bool QueuedJob::isHeld() const {
  if (state == "REQUEUE_HOLD" || state == "SPECIAL_EXIT") return true;
  // "launch failed requeued held", "job requeued in held state"; JobHeldUser is as the user wants
  return state == "PENDING" &&
         (reason == "JobHoldMaxRequeue" || reason.find("requeued") != std::string::npos);
}

std::string QueuedJob::name() const {
  return task > 0 ? fmt::format("{}_{}", job, task) : job;
}

bool QueuedJob::isRunning() const {
  return state == "RUNNING" || state == "COMPLETING" || state == "SUSPENDED" || state == "STOPPED";
}

ClusterLimits parseLimits(std::string_view config) {
  ClusterLimits limits;
  limits.arraySize = numberOr(valueIn(config, "MaxArraySize"), limits.arraySize);
  limits.jobs = numberOr(valueIn(config, "MaxJobCount"), limits.jobs);
  limits.requeues75 = holds(valueIn(config, "RequeueExit"), 75);
  for (const std::string& word : itemsOf(valueIn(config, "SchedulerParameters"), ',')) {
    constexpr std::string_view kKey = "max_array_tasks=";
    if (word.starts_with(kKey)) limits.arrayTasks = numberOr(word.substr(kKey.size()), 0);
  }
  return limits;
}

std::vector<QueuedJob> parseQueue(std::string_view lines) {
  std::vector<QueuedJob> jobs;
  for (const std::string& line : itemsOf(lines, '\n')) {
    std::vector<std::string> words = itemsOf(line, '|');
    if (words.size() < 5) continue;
    words.resize(6);
    jobs.push_back(
        {words[0], numberOr(words[1], 0), words[2], secondsIn(words[3]), words[4], words[5]});
  }
  return jobs;
}

std::int64_t parseProcessors(std::string_view lines, const std::string& partition) {
  const std::vector<std::string> wanted = itemsOf(partition, ',');
  std::set<std::string> there;
  std::int64_t sum = 0;
  for (const std::string& line : itemsOf(lines, '\n')) {
    const std::vector<std::string> words = itemsOf(line, '|');
    if (words.size() != 2 || words[0].empty()) continue;
    const bool isDefault = words[0].ends_with('*');
    const std::string name = words[0].substr(0, words[0].size() - (isDefault ? 1 : 0));
    there.insert(name);
    if (partition.empty() ? !isDefault : std::ranges::count(wanted, name) == 0) continue;
    const std::vector<std::string> states = itemsOf(words[1], '/');  // allocated, idle, other, all
    if (states.size() == 4) sum += numberOr(states[0], 0) + numberOr(states[1], 0);
  }
  for (const std::string& name : wanted)
    if (!name.empty() && !there.contains(name)) refusePartition(name, there);
  return sum;
}

ClusterLimits readLimits() {
  return parseLimits(outputOf({"scontrol", "show", "config"}));
}

std::int64_t countProcessors(const std::string& partition) {
  return parseProcessors(outputOf({"sinfo", "-h", "-a", "-o", "%P|%C"}), partition);
}

std::string sendJob(const std::filesystem::path& script, const std::vector<std::string>& after) {
  std::vector<std::string> command{"sbatch", "--parsable"};
  if (!after.empty()) command.push_back("--dependency=afterany:" + joined(after, ":"));
  command.push_back(script.string());
  const std::string output = outputOf(command);
  return std::string(trimmed(output.substr(0, output.find(';'))));
}

std::vector<QueuedJob> readQueue(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return {};
  const std::vector<std::string> command{
      "squeue", "-h", "-r", "-t", "all", "-o", kQueueFormat, "-j", joined(jobs, ",")};
  const auto captured = system::capture(command, kPatience);
  if (captured && captured->problems.find("Invalid job id") != std::string::npos) return {};
  return parseQueue(outputOf(command));
}

std::optional<std::string> cancelJobs(const std::vector<std::string>& jobs) {
  std::vector<std::string> command{"scancel"};
  command.insert(command.end(), jobs.begin(), jobs.end());
  try {
    outputOf(command);
    return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace rotatebook::farm
