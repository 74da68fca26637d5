#include "farm/plan.h"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "base/text.h"

namespace rotatebook::farm {
namespace {

constexpr Work kWorks[] = {Work::Render, Work::Map, Work::Study};

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// Returns the folder as a command takes it, which may not be there yet: a name with a dot in it
/// would be a video's.
std::string folderWord(const std::filesystem::path& folder) {
  return folder.string() + (folder.has_extension() ? "/" : "");
}

/// Returns the end of every command: where it writes, how it ends, and which scenes it takes.
std::vector<std::string> commonWords(const Plan& plan, const std::string& checksums) {
  std::vector<std::string> words{"-o", folderWord(plan.folder), "--retry-status",
                                 "--scene-checksum", checksums};
  if (plan.work == Work::Map) append(words, {"--threads", std::to_string(plan.cores)});
  append(words, plan.arguments);
  return words;
}

}  // namespace

const char* nameOf(Work work) {
  constexpr const char* kNames[] = {"render", "map", "study"};
  return kNames[static_cast<int>(work)];
}

std::optional<Work> parseWork(std::string_view name) {
  const auto found = std::ranges::find(kWorks, name, nameOf);
  return found != std::end(kWorks) ? std::optional(*found) : std::nullopt;
}

const char* unitsOf(Work work) {
  constexpr const char* kUnits[] = {"frames", "tiles", "studies"};
  return kUnits[static_cast<int>(work)];
}

bool makesWholeClips(const Plan& plan) {
  return plan.work == Work::Render &&
         std::ranges::all_of(plan.scenes, [](const auto& scene) { return scene.parts == 1; });
}

bool leavesFrames(const Plan& plan) {
  return std::ranges::count(plan.joinArguments, kNoPng) == 0;
}

std::int64_t countTasks(const Plan& plan) {
  return std::ssize(tasksOf(plan));
}

std::vector<Task> tasksOf(const Plan& plan) {
  std::vector<Task> tasks;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    const std::int64_t parts = plan.scenes[scene].parts;
    if (!plan.scenes[scene].startsTask && !tasks.empty()) {
      ++tasks.back().scenes;
      continue;
    }
    for (std::int64_t part = 1; part <= parts; ++part)
      tasks.push_back({std::ssize(tasks) + 1, scene, {part, parts}});
  }
  return tasks;
}

std::string describe(const Plan& plan, const Task& task) {
  const std::string& name = plan.scenes[task.scene].name;
  if (task.scenes > 1) return fmt::format("{} and {} more", name, task.scenes - 1);
  if (task.part.count == 1) return name;
  return fmt::format("part {}/{} of {}", task.part.number, task.part.count, name);
}

namespace {

/// Returns the words of the command that makes whole results of so many scenes from `first` on.
std::vector<std::string> wholeCommandOf(const Plan& plan, std::size_t first, std::size_t count) {
  std::vector<std::string> words{plan.program.string(), nameOf(plan.work)};
  std::vector<std::string> checksums;
  for (std::size_t i = first; i < first + count; ++i) {
    words.push_back(plan.scenes[i].file.string());
    checksums.push_back(plan.scenes[i].checksum);
  }
  append(words, {"--resume"});
  append(words, commonWords(plan, joined(checksums, ",")));
  append(words, plan.joinArguments);
  return words;
}

}  // namespace

std::vector<std::string> commandOf(const Plan& plan, const Task& task) {
  if (makesWholeClips(plan)) {
    std::vector<std::string> words = wholeCommandOf(plan, task.scene, task.scenes);
    // As many as render takes by default on so many cores
    const int atATime = plan.cores == 1 ? 1 : std::max(2, plan.cores / 3);
    append(words, {"--jobs", std::to_string(atATime)});
    return words;
  }
  const PlannedScene& scene = plan.scenes[task.scene];
  std::vector<std::string> words{plan.program.string(), nameOf(plan.work), scene.file.string()};
  if (plan.work != Work::Study) {
    append(words, {"--part", fmt::format("{}/{}", task.part.number, task.part.count)});
    append(words, {"--resume"});
  }
  append(words, commonWords(plan, scene.checksum));
  return words;
}

std::vector<std::string> joinCommandOf(const Plan& plan) {
  if (plan.work == Work::Study || makesWholeClips(plan)) return {};
  return wholeCommandOf(plan, 0, plan.scenes.size());
}

std::vector<std::string> environmentOf(const Plan& plan) {
  if (plan.work != Work::Render) return {};
  return {fmt::format("LP_NUM_THREADS={}", plan.cores)};
}

std::string shellLine(const Plan& plan, const std::vector<std::string>& command) {
  std::vector<std::string> words = environmentOf(plan);
  for (const std::string& word : command) words.push_back(shellWord(word));
  return joined(words, " ");
}

bool isSameWork(const Plan& one, const Plan& other) {
  Plan undivided = other;
  if (one.scenes.size() != other.scenes.size()) return false;
  for (std::size_t i = 0; i < one.scenes.size(); ++i) {
    undivided.scenes[i].parts = one.scenes[i].parts;
    undivided.scenes[i].startsTask = one.scenes[i].startsTask;
  }
  return undivided == one;
}

}  // namespace rotatebook::farm
