#include "farm/plan_texts.h"

#include <algorithm>
#include <iterator>

#include "base/error.h"
#include "base/json.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "farm/job_script.h"

namespace rotatebook::farm {
namespace {

constexpr PlanFormat kFormats[] = {
    {"list", listText}, {"parallel", parallelText}, {"openjd", openJobText}};

std::string linesOf(const Plan& plan, const std::vector<Task>& tasks) {
  std::string text;
  for (const Task& task : tasks) text += shellLine(plan, commandOf(plan, task)) + '\n';
  return text;
}

/// Returns the line that joins the results; empty if there is none.
std::string joinLine(const Plan& plan) {
  const std::vector<std::string> join = joinCommandOf(plan);
  return join.empty() ? "" : shellLine(plan, join) + '\n';
}

/// Longest names of jobs and steps. [letters]
constexpr std::size_t kMaxStepName = 64;

/// Returns a name that no other step has: in a template, they must differ and be short.
std::string stepName(const Plan& plan, std::size_t scene) {
  const std::string end = ' ' + std::to_string(scene + 1);
  return std::string(firstCharacters(plan.scenes[scene].name, kMaxStepName - end.size())) + end;
}

/// Returns a word as a format string without references: these begin with two braces.
std::string literal(std::string word) {
  for (std::size_t at = 0; (at = word.find("{{", at)) != std::string::npos; ++at) {
    throw InputError(quotedText(word) +
                     " can't be part of a job template, in which {{ has a "
                     "meaning; rename the file or folder");
  }
  return word;
}

std::string actionOf(const std::vector<std::string>& command, const std::string& part) {
  std::vector<std::string> arguments;
  for (std::size_t i = 1; i < command.size(); ++i) {
    const bool isPart = !part.empty() && command[i - 1] == "--part";
    arguments.push_back(isPart ? part : literal(command[i]));
  }
  const std::string run = JsonObject()
                              .addString("command", literal(command.front()))
                              .add("args", jsonArrayOf(arguments, jsonString))
                              .text();
  return JsonObject().add("actions", JsonObject().add("onRun", run).text()).text();
}

/// Returns the environment that a step's commands want; empty if they want none.
std::string environmentsOf(const Plan& plan) {
  JsonObject variables;
  for (const std::string& variable : environmentOf(plan)) {
    const std::size_t equals = variable.find('=');
    variables.addString(variable.substr(0, equals), variable.substr(equals + 1));
  }
  if (environmentOf(plan).empty()) return "";
  return jsonArray(
      {JsonObject().addString("name", "Threads").add("variables", variables.text()).text()});
}

std::string parameterSpace(const std::vector<std::int64_t>& parts) {
  const std::string parameter = JsonObject()
                                    .addString("name", "Part")
                                    .addString("type", "INT")
                                    .addString("range", rangesText(parts))
                                    .text();
  return JsonObject().add("taskParameterDefinitions", jsonArray({parameter})).text();
}

/// Returns the step of a scene's tasks; empty if there are none.
std::string sceneStep(const Plan& plan, const std::vector<Task>& tasks, std::size_t scene) {
  std::vector<std::int64_t> parts;
  const Task* any = nullptr;
  for (const Task& task : tasks) {
    if (task.scene != scene) continue;
    parts.push_back(task.part.number);
    any = &task;
  }
  if (any == nullptr) return "";
  JsonObject step;
  step.addString("name", stepName(plan, scene));
  if (plan.work != Work::Study) step.add("parameterSpace", parameterSpace(parts));
  const std::string environments = environmentsOf(plan);
  if (!environments.empty()) step.add("stepEnvironments", environments);
  const std::string part = "{{Task.Param.Part}}/" + std::to_string(any->part.count);
  return step.add("script", actionOf(commandOf(plan, *any), part)).text();
}

std::string joinStep(const Plan& plan, const std::vector<std::string>& after) {
  JsonObject step;
  step.addString("name", "join");
  if (!after.empty()) {
    step.add("dependencies", jsonArrayOf(after, [](const std::string& name) {
               return JsonObject().addString("dependsOn", name).text();
             }));
  }
  const std::string environments = environmentsOf(plan);
  if (!environments.empty()) step.add("stepEnvironments", environments);
  return step.add("script", actionOf(joinCommandOf(plan), "")).text();
}

}  // namespace

const PlanFormat& planFormat(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &PlanFormat::name);
  if (found != std::end(kFormats)) return *found;
  std::vector<std::string_view> names;
  for (const PlanFormat& format : kFormats) names.emplace_back(format.name);
  throw InputError("--plan " + std::string(name) + ": unknown; there are " +
                   quotedList(names, "and") + didYouMean(name, names));
}

std::string listText(const Plan& plan, const std::vector<Task>& tasks) {
  const std::string join = joinLine(plan);
  if (join.empty()) return linesOf(plan, tasks);
  return linesOf(plan, tasks) + "# Once all of these have ended:\n" + join;
}

std::string parallelText(const Plan& plan, const std::vector<Task>& tasks) {
  std::string text =
      "#!/bin/sh\n# Options are passed on to GNU parallel: --jobs 8, --sshloginfile machines.txt\n";
  if (!tasks.empty()) {
    text += "parallel --retries 3 \"$@\" <<'TASKS' || [ $? -le 101 ] || exit\n" +
            linesOf(plan, tasks) + "TASKS\n";
  }
  return text + joinLine(plan);
}

std::string openJobText(const Plan& plan, const std::vector<Task>& tasks) {
  std::vector<std::string> steps, names;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    const std::string step = sceneStep(plan, tasks, scene);
    if (step.empty()) continue;
    steps.push_back(step);
    names.push_back(stepName(plan, scene));
  }
  if (plan.work != Work::Study) steps.push_back(joinStep(plan, names));
  return JsonObject()
             .addString("specificationVersion", "jobtemplate-2023-09")
             .addString("name", std::string("rotatebook ") + nameOf(plan.work))
             .add("steps", jsonArray(steps))
             .text() +
         '\n';
}

}  // namespace rotatebook::farm
