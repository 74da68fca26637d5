#include "farm/plan.h"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "base/text.h"
#include "system/machine.h"

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

bool isWholeClip(const Plan& plan, const PlannedScene& scene) {
  return plan.work == Work::Render && scene.parts == 1;
}

bool makesWholeClips(const Plan& plan, const Task& task) {
  return isWholeClip(plan, plan.scenes[task.scenes.front()]);
}

bool leavesFrames(const Plan& plan) {
  return std::ranges::count(plan.joinArguments, kNoPng) == 0;
}

std::int64_t countTasks(const Plan& plan) {
  return std::ssize(tasksOf(plan));
}

std::vector<Task> tasksOf(const Plan& plan) {
  std::vector<Task> tasks;
  std::optional<std::size_t> ofWholes;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    const PlannedScene& planned = plan.scenes[scene];
    const bool isWhole = isWholeClip(plan, planned);
    if (isWhole && !planned.startsTask && ofWholes) {
      tasks[*ofWholes].scenes.push_back(scene);
      continue;
    }
    if (isWhole) ofWholes = tasks.size();
    for (std::int64_t part = 1; part <= planned.parts; ++part)
      tasks.push_back({std::ssize(tasks) + 1, {scene}, {part, planned.parts}});
  }
  return tasks;
}

std::string describe(const Plan& plan, const Task& task) {
  const std::string& name = plan.scenes[task.scenes.front()].name;
  if (task.scenes.size() > 1) return fmt::format("{} and {} more", name, task.scenes.size() - 1);
  if (task.part.count == 1) return name;
  return fmt::format("part {}/{} of {}", task.part.number, task.part.count, name);
}

namespace {

/// Returns the words of the command that makes whole results of these scenes.
std::vector<std::string> wholeCommandOf(const Plan& plan, const std::vector<std::size_t>& scenes) {
  std::vector<std::string> words{plan.program.string(), nameOf(plan.work)};
  std::vector<std::string> checksums;
  for (const std::size_t scene : scenes) {
    words.push_back(plan.scenes[scene].file.string());
    checksums.push_back(plan.scenes[scene].checksum);
  }
  append(words, {"--resume"});
  append(words, commonWords(plan, joined(checksums, ",")));
  append(words, plan.joinArguments);
  return words;
}

/// Returns how many clips a task renders at a time.
int clipsAtATime(const Plan& plan, const Task& task) {
  return std::min(system::rendersFor(plan.cores), static_cast<int>(task.scenes.size()));
}

/// Returns a command as a line of a shell; software draws with so many threads.
std::string shellLine(const Plan& plan, const std::vector<std::string>& command, int threads) {
  std::vector<std::string> words;
  if (plan.work == Work::Render) words.push_back(fmt::format("LP_NUM_THREADS={}", threads));
  for (const std::string& word : command) words.push_back(shellWord(word));
  return joined(words, " ");
}

}  // namespace

std::vector<std::string> commandOf(const Plan& plan, const Task& task) {
  if (makesWholeClips(plan, task)) {
    std::vector<std::string> words = wholeCommandOf(plan, task.scenes);
    append(words, {"--jobs", std::to_string(clipsAtATime(plan, task))});
    return words;
  }
  const PlannedScene& scene = plan.scenes[task.scenes.front()];
  std::vector<std::string> words{plan.program.string(), nameOf(plan.work), scene.file.string()};
  if (plan.work != Work::Study) {
    append(words, {"--part", fmt::format("{}/{}", task.part.number, task.part.count)});
    append(words, {"--resume"});
  }
  append(words, commonWords(plan, scene.checksum));
  return words;
}

std::vector<std::size_t> joinedScenesOf(const Plan& plan) {
  std::vector<std::size_t> scenes;
  if (plan.work == Work::Study) return scenes;
  for (std::size_t i = 0; i < plan.scenes.size(); ++i)
    if (!isWholeClip(plan, plan.scenes[i])) scenes.push_back(i);
  return scenes;
}

std::vector<std::string> joinCommandOf(const Plan& plan) {
  const std::vector<std::size_t> scenes = joinedScenesOf(plan);
  return scenes.empty() ? std::vector<std::string>{} : wholeCommandOf(plan, scenes);
}

std::string lineOf(const Plan& plan, const Task& task) {
  const int atATime = makesWholeClips(plan, task) ? clipsAtATime(plan, task) : 1;
  return shellLine(plan, commandOf(plan, task), std::max(1, plan.cores / atATime));
}

std::string joinLineOf(const Plan& plan) {
  const std::vector<std::string> command = joinCommandOf(plan);
  return command.empty() ? "" : shellLine(plan, command, plan.cores);
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
