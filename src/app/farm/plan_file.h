// Files of a plan: DIR/farm/COMMAND/ holds the plan, its tasks, job scripts, and the ends of tasks.
// All are text. Inside the room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "farm/plan.h"

namespace rotatebook::farm {

/// The jobs of a batch system that a plan was sent as. Empty if it was sent to none.
struct Jobs {
  std::vector<std::string> arrays{};  ///< Each of some of the tasks.
  std::string join{};

  /// Returns them all, the join last.
  std::vector<std::string> all() const {
    std::vector<std::string> jobs = arrays;
    if (!join.empty()) jobs.push_back(join);
    return jobs;
  }
};

/// A plan as it is on the disk.
struct StoredPlan {
  Plan plan;
  Jobs jobs{};
};

/// Returns the name of a task in those of its files: "join" of 0, else the number.
std::string nameOfTask(std::int64_t task);
/// Returns the task with that name; nothing for other text.
std::optional<std::int64_t> taskNamed(const std::string& name);

/// Paths of a plan's files.
struct PlanFiles {
  std::filesystem::path folder;      ///< DIR/farm/COMMAND/
  std::filesystem::path plan;        ///< plan.json
  std::filesystem::path tasks;       ///< tasks.txt, a command a line
  std::filesystem::path join;        ///< join.txt, a command
  std::filesystem::path partScript;  ///< part.sh
  std::filesystem::path joinScript;  ///< join.sh
  std::filesystem::path log;         ///< log/, with what each task printed
  std::filesystem::path ends;        ///< ends/, with how each task ended last

  /// Returns the file with what a task printed; 0 is the join.
  std::filesystem::path logOf(std::int64_t task) const;
};
PlanFiles planFiles(const std::filesystem::path& results, Work work);

/// Returns the text that parsePlan() reads. Throws InputError if a path has more than one line, or
/// parsePlan() would refuse it.
std::string planText(const StoredPlan& stored);
/// Throws InputError, which names `file`, if the text is no plan, or one of another version, of
/// more than kMaxTasks tasks, or of more units than a scene has.
StoredPlan parsePlan(std::string_view text, const std::string& file);
/// Returns the plan on the disk; nothing if there is none. Throws like parsePlan(), and for a file
/// that can't be read.
std::optional<StoredPlan> readPlan(const PlanFiles& files);
/// Writes the plan alone.
void writePlan(const PlanFiles& files, const StoredPlan& stored);

/// The end of a task's last try.
struct TaskEnd {
  int status = 0;
  std::string node;
  double seconds = 0;
};
/// Returns how tasks ended, by their numbers, 0 being the join; those that haven't are missing.
std::map<std::int64_t, TaskEnd> readEnds(const PlanFiles& files);

}  // namespace rotatebook::farm
