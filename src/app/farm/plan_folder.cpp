#include "farm/plan_folder.h"

#include <algorithm>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "system/atomic_file.h"
#include "system/read_file.h"
#include "system/removal.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;

/// The tasks of two plans: those up to `earlier`, and the join, may have left files that are
/// removed; those up to `now` leave files of their own.
struct TaskCounts {
  std::int64_t earlier = -1;  ///< -1 if there was no plan.
  std::int64_t now = 0;
};

/// Returns the task that left the file at `path` in log/ or ends/. A job that was killed while it
/// noted an end leaves ends/.TASK.PID.
std::optional<std::int64_t> taskThatLeft(const fs::path& path, const PlanFiles& files) {
  const std::string name = path.filename().string();
  if (path.parent_path() == files.log)
    return name.ends_with(".txt") ? taskNamed(path.stem().string()) : std::nullopt;
  if (!name.starts_with('.')) return taskNamed(name);
  const std::size_t dot = name.find('.', 1);
  const bool hasProcess = dot != name.npos && taskNamed(name.substr(dot + 1)).value_or(0) > 0;
  return hasProcess ? taskNamed(name.substr(1, dot - 1)) : std::nullopt;
}

[[noreturn]] void failInTheWay(const fs::path& path, const std::string& problem) {
  throw InputError(fmt::format(
      "{} {}, and would be replaced; move it away, or submit into another folder with -o",
      path.string(), problem));
}

/// Throws InputError if one of the folders that lead from the results to `file` is a link.
void requireNoLink(const PlanFiles& files, const fs::path& file) {
  std::error_code ignored;
  for (const fs::path& folder : {files.folder.parent_path(), files.folder, file.parent_path()}) {
    if (!fs::is_symlink(folder, ignored)) continue;
    throw InputError(
        fmt::format("{} is of an earlier plan, and lies behind the link {}, through which nothing "
                    "is removed; remove the file, or the link",
                    file.string(), folder.string()));
  }
}

/// Returns what an earlier plan's tasks left, which a new plan removes.
std::vector<fs::path> remainsOf(const TaskCounts& tasks, const PlanFiles& files) {
  std::vector<fs::path> remains;
  for (const fs::path& folder : {files.log, files.ends}) {
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
      const fs::path& path = entry.path();
      const auto task = taskThatLeft(path, files);
      if (!task || *task > std::max(tasks.earlier, tasks.now)) continue;
      if (!system::isPlainFile(path)) failInTheWay(path, "is no file that a task left");
      if (*task > tasks.earlier) failInTheWay(path, "is of no plan that is known here");
      requireNoLink(files, path);
      remains.push_back(path);
    }
  }
  return remains;
}

struct TextFile {
  fs::path path;
  std::string text;
};

/// Returns the files with the commands of a plan.
std::vector<TextFile> commandFiles(const PlanFiles& files, const Plan& plan) {
  std::string tasks;
  for (const Task& task : tasksOf(plan)) tasks += lineOf(plan, task) + '\n';
  std::vector<TextFile> all{{files.tasks, tasks}};
  const std::string join = joinLineOf(plan);
  if (!join.empty()) all.push_back({files.join, join + '\n'});
  return all;
}

/// Throws InputError for a link or a folder in the place of a plan's file.
void requirePlain(const fs::path& path) {
  if (system::isOccupied(path) && !system::isPlainFile(path))
    failInTheWay(path, "is no file that submit wrote");
}

/// Throws InputError if something would be written over that isn't of a plan.
void requireOwn(const PlanFiles& files, const std::vector<TextFile>& commands, bool hasPlan) {
  requirePlain(files.plan);
  std::vector<TextFile> all = commands;
  for (const fs::path& script : {files.partScript, files.joinScript}) all.push_back({script, ""});
  for (const auto& [path, text] : all) {
    requirePlain(path);
    if (!hasPlan && system::isOccupied(path) && system::readFileOrEmpty(path) != text)
      failInTheWay(path, "is of no plan that is known here");
  }
}

}  // namespace

void addPlanTo(store::Footprint& footprint, const PlanFiles& files) {
  for (const fs::path& file :
       {files.plan, files.tasks, files.join, files.partScript, files.joinScript})
    footprint.addFile(file);
  for (const fs::path& folder : {files.log, files.ends}) footprint.addWholeFolder(folder);
}

void writeNewPlan(const PlanFiles& files, const StoredPlan& stored) {
  const std::string text = planText(stored);
  const std::vector<TextFile> commands = commandFiles(files, stored.plan);
  const auto earlier = readPlan(files);
  const TaskCounts tasks{earlier ? countTasks(earlier->plan) : -1, countTasks(stored.plan)};

  // Find what is in the way before anything is changed
  requireOwn(files, commands, earlier.has_value());
  const std::vector<fs::path> remains = remainsOf(tasks, files);

  for (const fs::path& folder : {files.log, files.ends}) system::createFolders(folder);
  for (const fs::path& file : remains) system::removeFile(file);
  if (commands.size() == 1 && earlier && system::isPlainFile(files.join))
    system::removeFile(files.join);
  // The plan comes first: if the process is killed, the next one knows the rest by it
  system::writeFileAtomically(files.plan, text);
  for (const TextFile& file : commands) system::writeFileAtomically(file.path, file.text);
}

void storePlan(const PlanFiles& files, const StoredPlan& stored) {
  const auto there = readPlan(files);
  if (!there || there->plan != stored.plan) return writeNewPlan(files, stored);
  for (const fs::path& folder : {files.log, files.ends}) system::createFolders(folder);
  for (const TextFile& file : commandFiles(files, stored.plan)) {
    requirePlain(file.path);
    if (system::readFileOrEmpty(file.path) == file.text) continue;
    system::writeFileAtomically(file.path, file.text);
    // A study that is newer than its task counts as done
    std::error_code ignored;
    const auto planned = fs::last_write_time(files.plan, ignored);
    if (!ignored) fs::last_write_time(file.path, planned, ignored);
  }
}

}  // namespace rotatebook::farm
