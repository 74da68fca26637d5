#include "farm/plan_file.h"

#include <charconv>
#include <sstream>
#include <system_error>

#include "base/error.h"
#include "base/text.h"
#include "system/atomic_file.h"
#include "system/read_file.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "rotatebook plan 1";

constexpr std::int64_t kMaxUnits = 1'000'000;          ///< Of a scene; a clip has at most so many.
constexpr std::int64_t kMaxUnitsOfPlan = 100'000'000;  ///< Of all scenes.
constexpr std::uintmax_t kLongestPlan = 16 << 20;      ///< A scene takes some 500. [bytes]

void addLine(std::string& text, std::string_view key, const std::string& value) {
  if (!isOneLine(value)) {
    throw InputError(quotedText(value) +
                     " can't be part of a plan, which is lines of text; rename the file or folder");
  }
  text += std::string(key) + ' ' + value + '\n';
}

std::string sceneText(const PlannedScene& scene) {
  std::string text;
  addLine(text, "scene", scene.file.string());
  addLine(text, "name", scene.name);
  addLine(text, "checksum", scene.checksum);
  if (!scene.values.empty()) addLine(text, "values", scene.values);
  addLine(text, "units", std::to_string(scene.units));
  addLine(text, "parts", std::to_string(scene.parts));
  for (const fs::path& output : scene.outputs) addLine(text, "output", output.string());
  return text;
}

std::int64_t numberIn(const std::string& text, std::int64_t most, const std::string& file) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool isNumber = error == std::errc() && end == text.data() + text.size();
  if (isNumber && number >= 1 && number <= most) return number;
  throw InputError(file + ": " + quotedText(text) + " isn't a number from 1 to " +
                   std::to_string(most) + "; was it edited?");
}

/// Puts a line of a scene into it; returns false if it is none.
bool take(const std::string& key, const std::string& value, const std::string& file,
          PlannedScene& scene) {
  if (key == "name")
    scene.name = value;
  else if (key == "checksum")
    scene.checksum = value;
  else if (key == "values")
    scene.values = value;
  else if (key == "units")
    scene.units = numberIn(value, kMaxUnits, file);
  else if (key == "parts")
    scene.parts = numberIn(value, kMaxUnits, file);
  else if (key == "output")
    scene.outputs.emplace_back(value);
  else
    return false;
  return true;
}

/// Puts a line of the plan itself into it; returns false if it is none.
bool take(const std::string& key, const std::string& value, const std::string& file,
          StoredPlan& stored) {
  Plan& plan = stored.plan;
  const auto work = parseWork(value);
  if (key == "work" && work)
    plan.work = *work;
  else if (key == "program")
    plan.program = value;
  else if (key == "build")
    plan.build = value;
  else if (key == "folder")
    plan.folder = value;
  else if (key == "cores")
    plan.cores = static_cast<int>(numberIn(value, kMaxCores, file));
  else if (key == "argument")
    plan.arguments.push_back(value);
  else if (key == "join-argument")
    plan.joinArguments.push_back(value);
  else if (key == "scene")
    plan.scenes.push_back({.file = value});
  else if (key == "array-job")
    stored.jobs.arrays.push_back(value);
  else if (key == "join-job")
    stored.jobs.join = value;
  else
    return false;
  return true;
}

/// Throws InputError for a plan larger than any that submit makes: a few words must not take all
/// memory.
void requireSound(const Plan& plan, const std::string& file) {
  const auto fail = [&](const std::string& problem) { throw InputError(file + ": " + problem); };
  std::int64_t units = 0, tasks = 0;
  for (const PlannedScene& scene : plan.scenes) {
    if (scene.parts > scene.units) {
      fail("the scene " + quotedText(scene.name) + " has " + std::to_string(scene.parts) +
           " parts of " + std::to_string(scene.units) + " " + unitsOf(plan.work));
    }
    units += scene.units;
    tasks += scene.parts;
    if (units > kMaxUnitsOfPlan) {
      fail("more than " + std::to_string(kMaxUnitsOfPlan) + " " + unitsOf(plan.work) +
           " in one plan; submit some of the scenes at a time");
    }
    if (tasks > kMaxTasks)
      fail("more than " + std::to_string(kMaxTasks) + " tasks in one plan; take a larger --chunk");
  }
}

}  // namespace

std::string nameOfTask(std::int64_t task) {
  return task == 0 ? "join" : std::to_string(task);
}

std::optional<std::int64_t> taskNamed(const std::string& name) {
  if (name == nameOfTask(0)) return 0;
  std::int64_t task = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), task);
  if (error != std::errc() || task < 1 || name != nameOfTask(task)) return std::nullopt;
  return task;
}

fs::path PlanFiles::logOf(std::int64_t task) const {
  return log / (nameOfTask(task) + ".txt");
}

PlanFiles planFiles(const fs::path& results, Work work) {
  const fs::path folder = results / "farm" / nameOf(work);
  return {folder,
          folder / "plan.txt",
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
  std::string text = std::string(kHead) + '\n';
  addLine(text, "work", nameOf(plan.work));
  addLine(text, "program", plan.program.string());
  addLine(text, "build", plan.build);
  addLine(text, "folder", plan.folder.string());
  addLine(text, "cores", std::to_string(plan.cores));
  for (const std::string& argument : plan.arguments) addLine(text, "argument", argument);
  for (const std::string& argument : plan.joinArguments) addLine(text, "join-argument", argument);
  for (const std::string& array : stored.jobs.arrays) addLine(text, "array-job", array);
  if (!stored.jobs.join.empty()) addLine(text, "join-job", stored.jobs.join);
  for (const PlannedScene& scene : plan.scenes) text += sceneText(scene);
  return text;
}

StoredPlan parsePlan(std::string_view text, const std::string& file) {
  std::istringstream lines{std::string(text)};
  std::string line;
  if (!std::getline(lines, line) || line != kHead) {
    throw InputError(file + " isn't a plan of this program; remove it if nothing needs it");
  }
  StoredPlan stored;
  while (std::getline(lines, line)) {
    const std::size_t space = std::min(line.find(' '), line.size());
    const std::string key = line.substr(0, space);
    const std::string value = space < line.size() ? line.substr(space + 1) : "";
    const bool isOfScene =
        !stored.plan.scenes.empty() && take(key, value, file, stored.plan.scenes.back());
    if (isOfScene || take(key, value, file, stored)) continue;
    throw InputError(file + ": " + quotedText(line) + " has no meaning in a plan; was it edited?");
  }
  requireSound(stored.plan, file);
  return stored;
}

std::optional<StoredPlan> readPlan(const PlanFiles& files) {
  std::error_code missing;
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
