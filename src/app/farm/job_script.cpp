#include "farm/job_script.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::farm {
namespace {

/// Returns a line that sbatch reads; a value that it might read otherwise is put into quotation
/// marks.
std::string directive(const std::string& option) {
  if (!isOneLine(option) || option.find('"') != std::string::npos) {
    throw InputError(quotedText(option) +
                     " can't be an option of sbatch: it has quotation marks or several lines");
  }
  const std::size_t equals = option.find('=');
  const bool isPlain = std::ranges::none_of(option, [](char c) {
    return std::string_view(" '#\\;&|$`(){}*?<>!~").find(c) != std::string_view::npos;
  });
  if (isPlain || equals == std::string::npos) return fmt::format("#SBATCH {}\n", option);
  std::string value = option.substr(equals + 1);
  for (std::size_t at = 0; (at = value.find('\\', at)) != std::string::npos; at += 2)
    value.insert(at, "\\");
  return fmt::format("#SBATCH {}\"{}\"\n", option.substr(0, equals + 1), value);
}

/// Returns the option that submit sets itself which sbatch would read in `option`; empty if none.
/// sbatch takes names that are cut short, and several letters after one hyphen.
std::string ownOptionIn(const std::string& option) {
  constexpr std::string_view kLong[] = {
      "--array",   "--dependency", "--output",    "--chdir", "--ntasks",  "--cpus-per-task",
      "--requeue", "--no-requeue", "--open-mode", "--wrap",  "--parsable"};
  constexpr std::string_view kShort = "adoDnc";
  constexpr std::string_view kWithoutValue = "hHIkOQsvVW";
  if (option.starts_with("--")) {
    const std::string name = option.substr(0, option.find('='));
    for (const std::string_view own : kLong)
      if (own.starts_with(name)) return std::string(own);
    return "";
  }
  const std::size_t at = std::min(option.find_first_not_of(kWithoutValue, 1), option.size());
  const bool isOwn = at < option.size() && kShort.find(option[at]) != std::string_view::npos;
  return isOwn ? std::string("-") + option[at] : "";
}

/// Throws InputError for what isn't an option, and for one on which submit's jobs depend.
void requirePassable(const std::string& option) {
  const auto fail = [&](const std::string& problem) {
    throw InputError(fmt::format("--sbatch={}: {}", oneLine(option, 200), problem));
  };
  if (!option.starts_with('-')) fail("not an option of sbatch; write it whole, such as --qos=low");
  if (option.substr(0, option.find('=')).find_first_of(" \t") != std::string::npos)
    fail("several words; write its value after =, such as --qos=low");
  const std::string own = ownOptionIn(option);
  if (!own.empty())
    fail("submit sets " + own + " itself; --cores, --chunk and -o are its own options for that");
}

/// Returns a path for Slurm's patterns of file names, in which % has a meaning.
std::string escapedPattern(std::string path) {
  for (std::size_t at = 0; (at = path.find('%', at)) != std::string::npos; at += 2)
    path.insert(at, "%");
  return path;
}

std::string directives(const Plan& plan, const PlanFiles& files,
                       const std::vector<std::int64_t>& tasks, const JobOptions& options) {
  const std::string log = escapedPattern(files.log.string()) + (tasks.empty() ? "/join" : "/%a");
  std::string text = directive(
      fmt::format("--job-name=rotatebook-{}{}", nameOf(plan.work), tasks.empty() ? "-join" : ""));
  if (!tasks.empty()) text += directive("--array=" + rangesText(tasks));
  text += directive("--ntasks=1") + directive(fmt::format("--cpus-per-task={}", plan.cores)) +
          directive("--requeue") + directive("--open-mode=append") +
          directive(fmt::format("--output={}.txt", log)) +
          directive("--chdir=" + plan.folder.string());
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += directive(fmt::format("--{}={}", name, value));
  };
  add("partition", options.partition);
  add("account", options.account);
  add("time", options.time);
  add("constraint", options.constraint);
  for (const std::string& other : options.others) {
    requirePassable(other);
    text += directive(other);
  }
  return text;
}

// Both scripts' treatment of their command. Its exit status 1 says that an expectation isn't met, 2
// that the input is wrong: no second try helps.
constexpr const char* kRun = R"(
trap : TERM INT HUP  # The command gets the signal, too: it keeps what is done, and ends by itself.
if [ -n "$command" ]; then
  eval "$command"
  status=$?
else
  echo "the command of task $task is missing in $farm; submit again, which writes it" >&2
  status=2
fi

echo "$status ${SLURMD_NODENAME:-$(hostname)} $SECONDS" > "$farm/ends/.$task.$$"
mv -f "$farm/ends/.$task.$$" "$farm/ends/$task"
if [ "$status" = 75 ] || [ "$status" -gt 128 ]; then
  if [ "${SLURM_RESTART_COUNT:-0}" -lt )";

constexpr const char* kRequeue75 = "exit 75  # RequeueExit in slurm.conf has the task tried again.";
constexpr const char* kRequeueByCommand =
    "scontrol requeue \"$SLURM_JOB_ID\" && sleep 600  # Until that ends this try.";

}  // namespace

std::string rangesText(const std::vector<std::int64_t>& numbers) {
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    ranges.push_back(end - i == 1 ? std::to_string(numbers[i])
                                  : fmt::format("{}-{}", numbers[i], numbers[end - 1]));
    i = end;
  }
  return joined(ranges, ",");
}

std::string jobScript(const Plan& plan, const PlanFiles& files,
                      const std::vector<std::int64_t>& tasks, const JobOptions& options,
                      bool requeues75) {
  const bool isJoin = tasks.empty();
  std::string text = "#!/bin/bash\n" + directives(plan, files, tasks, options);
  text += isJoin ? "# Joins the results of all tasks, and makes what they have left out.\n"
                 : "# Runs line N of tasks.txt as the array's task N. It may run twice, at once.\n";
  text += fmt::format("farm={}\n", shellWord(files.folder.string()));
  text += isJoin ? "task=join\ncommand=$(cat \"$farm/join.txt\")\n"
                 : "task=$SLURM_ARRAY_TASK_ID\ncommand=$(sed -n \"${task}p\" "
                   "\"$farm/tasks.txt\")\n";
  return fmt::format("{}{}{} ]; then\n    {}\n  fi\n  status=3\nfi\nexit \"$status\"\n", text, kRun,
                     kMaxRestarts, requeues75 ? kRequeue75 : kRequeueByCommand);
}

}  // namespace rotatebook::farm
