#include "farm/plan_texts.h"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/text.h"

namespace rotatebook::farm {
namespace {

constexpr PlanFormat kFormats[] = {{"list", listText}, {"parallel", parallelText}};

std::string linesOf(const Plan& plan, const std::vector<Task>& tasks) {
  std::string text;
  for (const Task& task : tasks) text += lineOf(plan, task) + '\n';
  return text;
}

}  // namespace

const PlanFormat& planFormat(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &PlanFormat::name);
  if (found != std::end(kFormats)) return *found;
  std::vector<std::string_view> names;
  for (const PlanFormat& format : kFormats) names.emplace_back(format.name);
  throw InputError(fmt::format("--plan {}: unknown; there are {}{}", name, quotedList(names, "and"),
                               didYouMean(name, names)));
}

std::string listText(const Plan& plan, const std::vector<Task>& tasks) {
  const std::string join = joinLineOf(plan);
  if (join.empty()) return linesOf(plan, tasks);
  return fmt::format("{}# Once all of these have ended:\n{}\n", linesOf(plan, tasks), join);
}

std::string parallelText(const Plan& plan, const std::vector<Task>& tasks) {
  std::string text =
      "#!/bin/sh\n# Options are passed on to GNU parallel: --jobs 8, --sshloginfile machines.txt\n";
  if (!tasks.empty()) {
    text += "parallel --retries 3 \"$@\" <<'TASKS' || [ $? -le 101 ] || exit\n" +
            linesOf(plan, tasks) + "TASKS\n";
  }
  const std::string join = joinLineOf(plan);
  return join.empty() ? text : text + join + '\n';
}

}  // namespace rotatebook::farm
