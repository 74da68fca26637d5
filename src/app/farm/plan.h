// Plans of work for many machines: what is run, in how many parts, by which commands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "store/clip_files.h"

namespace rotatebook::farm {

/// The option of plans, and of `render`, by which clips have no PNGs.
inline constexpr const char* kNoPng = "--no-png";

/// The command whose work is divided.
enum class Work { Render, Map, Study };

/// Returns "render", "map" or "study", the command's name.
const char* nameOf(Work work);
/// Returns the work with that name; nothing for other text.
std::optional<Work> parseWork(std::string_view name);
/// Returns what the work is counted in: "frames", "tiles" or "studies".
const char* unitsOf(Work work);

/// A scene of a plan.
struct PlannedScene {
  std::filesystem::path file{};  ///< Absolute.
  std::string name{};
  std::string checksum{};  ///< store::sceneChecksum()
  std::string values{};    ///< Of a map: store::mapFingerprint().
  std::int64_t units = 1;  ///< Frames of a clip, tiles of a map; a study is one.
  std::int64_t parts = 1;  ///< 1 to `units`
  bool startsTask = true;  ///< False of a whole clip that the task of the one before takes, too.
  std::vector<std::filesystem::path> outputs{};  ///< Files that are there once all is done.

  friend bool operator==(const PlannedScene&, const PlannedScene&) = default;
};

/// Work, and the tasks into which it is divided: a value that depends on the scenes and options
/// alone, but for the number of parts.
struct Plan {
  Work work = Work::Render;
  std::filesystem::path program;             ///< Absolute.
  std::string build;                         ///< system::buildId()
  std::filesystem::path folder;              ///< Of the results; absolute.
  int cores = 1;                             ///< Of each task.
  std::vector<std::string> arguments{};      ///< Of all commands: --set and so on.
  std::vector<std::string> joinArguments{};  ///< Of those that make whole clips: --format.
  std::vector<PlannedScene> scenes{};

  friend bool operator==(const Plan&, const Plan&) = default;
};

/// A part of a scene's work, or the whole of one or several scenes, which one process does.
struct Task {
  std::int64_t number = 1;             ///< Counted through all scenes, from 1.
  std::vector<std::size_t> scenes{0};  ///< Several are whole clips.
  store::ClipPart part{};
};

/// Most tasks of a plan, and most cores of a task.
inline constexpr std::int64_t kMaxTasks = 1'000'000;
inline constexpr int kMaxCores = 1024;

/// Returns whether a task makes the whole clip of that scene.
bool isWholeClip(const Plan& plan, const PlannedScene& scene);
/// Returns whether it makes whole clips, of which there is nothing to join.
bool makesWholeClips(const Plan& plan, const Task& task);
/// Returns whether the clips have PNGs.
bool leavesFrames(const Plan& plan);
/// Returns the number of tasks.
std::int64_t countTasks(const Plan& plan);
/// Returns all tasks, scene by scene. Short clips share one, also where long ones lie between them.
std::vector<Task> tasksOf(const Plan& plan);
/// Returns "part 3/16 of NAME", or "NAME" if it has a single part; "NAME and 3 more" of scenes.
std::string describe(const Plan& plan, const Task& task);

/// Returns the words of a task's command. Any number of them may run at once, anywhere, also twice.
std::vector<std::string> commandOf(const Plan& plan, const Task& task);
/// Returns the scenes whose parts are joined after the tasks; none of studies and whole clips.
std::vector<std::size_t> joinedScenesOf(const Plan& plan);
/// Returns the words of the command that joins them; none if there is nothing to join.
std::vector<std::string> joinCommandOf(const Plan& plan);
/// Returns these commands as lines of a shell, with their environment; "" if there is no join.
std::string lineOf(const Plan& plan, const Task& task);
std::string joinLineOf(const Plan& plan);

/// Returns whether two plans do the same, in whatever parts.
bool isSameWork(const Plan& one, const Plan& other);

}  // namespace rotatebook::farm
