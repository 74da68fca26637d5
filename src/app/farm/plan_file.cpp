#include "farm/plan_file.h"

#include <sstream>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/json.h"
#include "base/parsed_number.h"
#include "base/text.h"
#include "system/atomic_file.h"
#include "system/read_file.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;

constexpr int kPlanVersion = 3;

constexpr std::int64_t kMaxUnits = 1'000'000;          ///< Of a scene; a clip has at most so many.
constexpr std::int64_t kMaxUnitsOfPlan = 100'000'000;  ///< Of all scenes.
constexpr std::uintmax_t kLongestPlan = 16 << 20;      ///< A scene takes some 500. [bytes]

Json sceneJson(const PlannedScene& scene) {
  return {{"file", scene.file},
          {"name", scene.name},
          {"checksum", scene.checksum},
          {"values", scene.values},
          {"units", scene.units},
          {"parts", scene.parts},
          {"starts_task", scene.startsTask},
          {"outputs", scene.outputs}};
}

std::int64_t numberIn(const Json& object, const char* key, std::int64_t most) {
  const Json& value = object.at(key);
  const std::int64_t number = value.is_number_integer() ? value.get<std::int64_t>() : 0;
  if (number >= 1 && number <= most) return number;
  throw InputError(fmt::format("{} {} isn't a number from 1 to {}", key, value.dump(), most));
}

PlannedScene sceneFrom(const Json& json) {
  return {.file = json.at("file"),
          .name = json.at("name"),
          .checksum = json.at("checksum"),
          .values = json.at("values"),
          .units = numberIn(json, "units", kMaxUnits),
          .parts = numberIn(json, "parts", kMaxUnits),
          .startsTask = json.at("starts_task"),
          .outputs = json.at("outputs")};
}

Work workIn(const Json& json) {
  const std::string name = json.at("work");
  if (const auto work = parseWork(name)) return *work;
  throw InputError(fmt::format("work {} is unknown", quotedText(name)));
}

StoredPlan planFrom(const Json& json) {
  StoredPlan stored{.plan = {.work = workIn(json),
                             .program = json.at("program"),
                             .build = json.at("build"),
                             .folder = json.at("folder"),
                             .cores = static_cast<int>(numberIn(json, "cores", kMaxCores)),
                             .arguments = json.at("arguments"),
                             .joinArguments = json.at("join_arguments")},
                    .jobs = {json.at("array_jobs"), json.at("join_job")}};
  for (const Json& scene : json.at("scenes")) stored.plan.scenes.push_back(sceneFrom(scene));
  return stored;
}

/// Throws InputError for a text that would not be one line of the tasks' commands.
void requireLines(const Json& json) {
  const Json values = json.flatten();
  for (const Json& value : values) {
    if (!value.is_string() || isOneLine(value.get<std::string>())) continue;
    throw InputError(quotedText(value.get<std::string>()) +
                     " can't be part of a plan, whose commands are lines of text; rename the file "
                     "or folder");
  }
}

[[noreturn]] void refuseEdited(const std::string& file, const std::string& problem) {
  throw InputError(fmt::format("{}: {}; was it edited?", file, problem));
}

[[noreturn]] void refuseVersion(const std::string& file, const std::string& version) {
  throw InputError(
      fmt::format("{} is a plan of version {}, and this program's have version {}; submit into "
                  "another folder with -o, or remove it once its tasks have ended",
                  file, version, kPlanVersion));
}

/// Throws InputError for a plan larger than any that submit makes: a few words must not take all
/// memory.
void requireSound(const Plan& plan, const std::string& file) {
  const auto fail = [&](const std::string& problem) { throw InputError(file + ": " + problem); };
  std::int64_t units = 0, tasks = 0;
  for (const PlannedScene& scene : plan.scenes) {
    if (scene.parts > scene.units) {
      fail(fmt::format("the scene {} has {} parts of {} {}", quotedText(scene.name), scene.parts,
                       scene.units, unitsOf(plan.work)));
    }
    if (!scene.startsTask && !isWholeClip(plan, scene))
      fail(fmt::format("the scene {} has no task", quotedText(scene.name)));
    units += scene.units;
    tasks += scene.parts;
    if (units > kMaxUnitsOfPlan) {
      fail(fmt::format("more than {} {} in one plan; submit some of the scenes at a time",
                       kMaxUnitsOfPlan, unitsOf(plan.work)));
    }
    if (tasks > kMaxTasks)
      fail(fmt::format("more than {} tasks in one plan; take a larger --chunk", kMaxTasks));
  }
}

}  // namespace

std::string nameOfTask(std::int64_t task) {
  return task == 0 ? "join" : std::to_string(task);
}

std::optional<std::int64_t> taskNamed(const std::string& name) {
  if (name == nameOfTask(0)) return 0;
  const auto task = parsedNumber<std::int64_t>(name);
  return task >= 1 && name == nameOfTask(*task) ? task : std::nullopt;
}

fs::path PlanFiles::logOf(std::int64_t task) const {
  return log / (nameOfTask(task) + ".txt");
}

PlanFiles planFiles(const fs::path& results, Work work) {
  const fs::path folder = results / "farm" / nameOf(work);
  return {folder,
          folder / "plan.json",
          folder / "tasks.txt",
          folder / "join.txt",
          folder / "part.sh",
          folder / "join.sh",
          folder / "log",
          folder / "ends"};
}

std::string planText(const StoredPlan& stored) {
  const Plan& plan = stored.plan;
  requireSound(plan, "the plan");
  Json json{{"rotatebook_plan", kPlanVersion},
            {"work", nameOf(plan.work)},
            {"program", plan.program},
            {"build", plan.build},
            {"folder", plan.folder},
            {"cores", plan.cores},
            {"arguments", plan.arguments},
            {"join_arguments", plan.joinArguments},
            {"array_jobs", stored.jobs.arrays},
            {"join_job", stored.jobs.join},
            {"scenes", Json::array()}};
  for (const PlannedScene& scene : plan.scenes) json["scenes"].push_back(sceneJson(scene));
  requireLines(json);
  return json.dump(1) + '\n';
}

StoredPlan parsePlan(std::string_view text, const std::string& file) {
  // Nothing that is nested deeper than in any plan is kept: megabytes of brackets take gigabytes.
  const auto isKept = [](int depth, Json::parse_event_t, const Json&) { return depth < 8; };
  const Json json = Json::parse(text, isKept, /*allow_exceptions=*/false);
  if (!json.is_object() || !json.contains("rotatebook_plan"))
    throw InputError(file + " isn't a plan of this program; remove it if nothing needs it");
  if (json["rotatebook_plan"] != kPlanVersion) refuseVersion(file, json["rotatebook_plan"].dump());
  StoredPlan stored;
  try {
    requireLines(json);
    stored = planFrom(json);
  } catch (const Json::exception& error) {
    const std::string_view problem = error.what();  // After "[json.exception.type_error.302] "
    refuseEdited(file, std::string(problem.substr(problem.find("] ") + 2)));
  } catch (const InputError& error) {
    refuseEdited(file, error.what());
  }
  requireSound(stored.plan, file);
  return stored;
}

std::optional<StoredPlan> readPlan(const PlanFiles& files) {
  std::error_code missing;
  const fs::path earlier = files.folder / "plan.txt";
  if (fs::exists(earlier, missing)) refuseVersion(earlier.string(), "1");
  if (!fs::exists(files.plan, missing)) return std::nullopt;
  return parsePlan(system::readInput(files.plan, kLongestPlan), files.plan.string());
}

void writePlan(const PlanFiles& files, const StoredPlan& stored) {
  system::writeFileAtomically(files.plan, planText(stored));
}

std::map<std::int64_t, TaskEnd> readEnds(const PlanFiles& files) {
  std::map<std::int64_t, TaskEnd> ends;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(files.ends, missing)) {
    const auto task = taskNamed(entry.path().filename().string());
    std::istringstream text(task ? system::readFileOrEmpty(entry.path()) : "");
    TaskEnd end;
    if (text >> end.status >> end.node >> end.seconds) ends[*task] = end;
  }
  return ends;
}

}  // namespace rotatebook::farm
