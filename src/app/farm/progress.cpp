#include "farm/progress.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/error.h"
#include "store/frame_checksums.h"
#include "store/manifest.h"
#include "store/map_files.h"
#include "store/map_tiles.h"
#include "system/read_file.h"

namespace rotatebook::farm {
namespace {

namespace fs = std::filesystem;

bool areThere(const std::vector<fs::path>& files) {
  std::error_code missing;
  return std::ranges::all_of(
      files, [&](const fs::path& file) { return fs::is_regular_file(file, missing); });
}

bool isOf(const Plan& plan, const PlannedScene& scene, const store::Manifest& manifest) {
  const auto& made = manifest.own.made;
  const auto build = made.find("build"), checksum = made.find("scene");
  return build != made.end() && build->second == plan.build && checksum != made.end() &&
         checksum->second == scene.checksum;
}

SceneProgress clipProgress(const Plan& plan, const PlannedScene& scene) {
  SceneProgress progress{std::vector<bool>(static_cast<std::size_t>(scene.units))};
  const fs::path folder = store::clipFiles(plan.folder, scene.name).frameFolder;
  const auto manifest = store::readManifest(folder);
  if (!manifest || !isOf(plan, scene, *manifest)) return progress;
  const store::FrameChecksums checksums(folder);
  for (const std::int64_t frame : store::framesIn(folder)) {
    if (frame < scene.units && checksums.contains(frame))
      progress.units[static_cast<std::size_t>(frame)] = true;
  }
  const bool areDrawn = !leavesFrames(plan) || progress.count() == scene.units;
  const bool areListed = std::ranges::all_of(scene.outputs, [&](const fs::path& output) {
    return manifest->own.files.contains(output.filename().string());
  });
  progress.isWhole = manifest->finished && areListed && areThere(scene.outputs) && areDrawn;
  // Of a clip without PNGs, nothing is there before all is
  if (progress.isWhole) progress.units.assign(progress.units.size(), true);
  return progress;
}

SceneProgress mapProgress(const Plan& plan, const PlannedScene& scene) {
  SceneProgress progress{std::vector<bool>(static_cast<std::size_t>(scene.units))};
  const store::MapFiles files = store::mapFiles(plan.folder, scene.name);
  progress.isWhole = store::mapFingerprintIn(files) == scene.values && areThere(scene.outputs);
  const store::MapTiles tiles(files.tiles, scene.values);
  for (std::size_t i = 0; i < progress.units.size(); ++i)
    progress.units[i] = progress.isWhole || tiles.contains(i);
  return progress;
}

/// A study leaves no name of what it was made of: what is there counts if it is newer than the
/// plan's tasks, on the clock of the same file system.
SceneProgress studyProgress(const PlannedScene& scene, const PlanFiles& files) {
  SceneProgress progress{{false}};
  std::error_code error;
  const auto planned = fs::last_write_time(files.tasks, error);
  if (error) return progress;
  progress.isWhole = std::ranges::all_of(scene.outputs, [&](const fs::path& output) {
    std::error_code missing;
    return fs::last_write_time(output, missing) >= planned && !missing;
  });
  progress.units[0] = progress.isWhole;
  return progress;
}

}  // namespace

std::int64_t SceneProgress::count() const {
  return std::ranges::count(units, true);
}

bool SceneProgress::has(const store::ClipPart& part) const {
  if (isWhole) return true;
  const store::FrameRange range = store::framesOf(part, std::ssize(units));
  return std::all_of(units.begin() + range.first, units.begin() + range.end,
                     [](bool isThere) { return isThere; });
}

std::vector<SceneProgress> progressOf(const Plan& plan, const PlanFiles& files) {
  std::vector<SceneProgress> all;
  for (const PlannedScene& scene : plan.scenes) {
    all.push_back(plan.work == Work::Render ? clipProgress(plan, scene)
                  : plan.work == Work::Map  ? mapProgress(plan, scene)
                                            : studyProgress(scene, files));
  }
  return all;
}

bool isDone(const Plan& plan, const Task& task, const std::vector<SceneProgress>& progress) {
  return std::ranges::all_of(task.scenes, [&](std::size_t scene) {
    return isWholeClip(plan, plan.scenes[scene]) ? progress[scene].isWhole
                                                 : progress[scene].has(task.part);
  });
}

bool areJoined(const Plan& plan, const std::vector<SceneProgress>& progress) {
  return std::ranges::all_of(joinedScenesOf(plan),
                             [&](std::size_t scene) { return progress[scene].isWhole; });
}

namespace {

void refuseOtherFrames(const Plan& plan, const PlannedScene& scene) {
  const fs::path folder = store::clipFiles(plan.folder, scene.name).frameFolder;
  const auto manifest = store::readManifest(folder);
  if (!store::hasFrames(folder) && !(manifest && !manifest->finished)) return;
  if (manifest && isOf(plan, scene, *manifest)) return;
  throw InputError(folder.string() +
                   " holds frames of other settings, or of another build of this program; submit "
                   "into another folder with -o, or remove it");
}

void refuseOtherTiles(const Plan& plan, const PlannedScene& scene) {
  const store::MapFiles files = store::mapFiles(plan.folder, scene.name);
  if (store::MapTiles(files.tiles, scene.values).count().other > 0) {
    throw InputError(files.tiles.string() +
                     " holds tiles of other settings, or of another build of this program; submit "
                     "into another folder with -o, or remove it");
  }
  if (!fs::exists(files.npy) || store::mapFingerprintIn(files) == scene.values) return;
  throw InputError(files.npy.string() +
                   " holds the values of other settings, or of another build of this program; "
                   "submit into another folder with -o, or remove it");
}

}  // namespace

void requireSameResults(const Plan& plan) {
  for (const PlannedScene& scene : plan.scenes) {
    if (plan.work == Work::Render) refuseOtherFrames(plan, scene);
    if (plan.work == Work::Map) refuseOtherTiles(plan, scene);
  }
}

}  // namespace rotatebook::farm
