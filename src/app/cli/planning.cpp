#include "cli/planning.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>

#include "picture/frame_drawer.h"
#include "store/fingerprint.h"
#include "store/map_files.h"
#include "store/study_files.h"
#include "study/map_runs.h"
#include "system/build_id.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kStartOfClip = 0.6;     ///< Of a task, without its simulation: measured. [s]
constexpr double kStartOfMap = 0.2;      ///< [s]
constexpr double kWithPng = 1.4;         ///< Drawing and compression over drawing: measured 1.44.
constexpr double kShortest = 1e-4;       ///< Of a frame or tile; shorter is taken for it. [s]
constexpr double kLongEnough = 1;        ///< Of a measurement. [s]
constexpr std::size_t kMaxMeasured = 8;  ///< Clips.

/// The time that a task's cores would take: the processors' time shared between them, or the
/// clock's, where another device draws.
class TaskTime {
 public:
  explicit TaskTime(int cores) : cores_(cores) {}
  double seconds() const {
    const std::chrono::duration<double> wall = Clock::now() - began_;
    const double processor = static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC;
    return std::max(processor, wall.count()) / (processor > wall.count() / 2 ? cores_ : 1);
  }

 private:
  using Clock = std::chrono::steady_clock;
  double cores_;
  Clock::time_point began_ = Clock::now();
  std::clock_t processor_ = std::clock();
};

std::vector<fs::path> outputsOf(const scene::Scene& scene, const PlanWishes& wishes) {
  const fs::path& folder = wishes.folder;
  if (wishes.work == farm::Work::Render)
    return outputFiles(store::clipFiles(folder, scene.name), scene, wishes.formats);
  if (wishes.work == farm::Work::Map) {
    const store::MapFiles files = store::mapFiles(folder, scene.name);
    return {files.png(), files.plain, files.npy, files.json};
  }
  const store::StudyFiles files = store::studyFiles(folder, scene.name);
  return {files.csv, files.json};  // It comes last.
}

std::int64_t unitsOf(const scene::Scene& scene, farm::Work work) {
  if (work == farm::Work::Render) return timeline::simulateScene(scene).frameCount();
  if (work == farm::Work::Study) return 1;
  return std::ssize(study::MapRuns(scene).tiles());
}

farm::PlannedScene plannedOf(const SceneOfFile& one, const PlanWishes& wishes) {
  const scene::Scene& scene = one.scene;
  farm::PlannedScene planned{.file = fs::absolute(one.file).lexically_normal(), .name = scene.name};
  planned.checksum = store::sceneChecksum(scene);
  if (wishes.work == farm::Work::Map) planned.values = store::mapFingerprint(scene);
  planned.units = unitsOf(scene, wishes.work);
  planned.outputs = outputsOf(scene, wishes);
  return planned;
}

farm::Effort effortOfClip(const SceneOfFile& one, int cores, const picture::DeviceChoice& device) {
  const TaskTime simulation(cores);
  const timeline::ClipMotion motion = timeline::simulateScene(one.scene);
  const std::int64_t frames = motion.frameCount();
  farm::Effort effort{one.scene.name, frames, kShortest, kStartOfClip + simulation.seconds()};

  // The first frame of a renderer takes longer
  picture::FrameDrawer drawer(one.scene, motion, device);
  image::Image picture = drawer.makePicture();
  drawer.draw(frames / 2, picture);
  const TaskTime drawing(cores);
  int drawn = 0;
  for (const std::int64_t frame : {frames / 4, frames / 2, frames * 3 / 4}) {
    drawer.draw(frame, picture);
    ++drawn;
    if (drawing.seconds() > kLongEnough) break;
  }
  effort.unit = std::max(kWithPng * drawing.seconds() / drawn, kShortest);
  return effort;
}

double pixelsOf(const scene::Scene& scene) {
  return 1.0 * scene.clip.width * scene.clip.height;
}

farm::Effort effortOfMap(const scene::Scene& scene, int cores) {
  constexpr std::size_t kTries = 8;
  const study::MapRuns runs(scene);
  const std::vector<study::MapTile> tiles = runs.tiles();
  const TaskTime time(cores);
  std::size_t done = 0;
  // Tiles differ: take some from all over the map
  for (std::size_t i = 0; i < std::min(kTries, tiles.size()); ++i) {
    runs.valuesOf(tiles[(2 * i + 1) * tiles.size() / (2 * std::min(kTries, tiles.size()))]);
    ++done;
    if (time.seconds() > kLongEnough) break;
  }
  const double unit = std::max(time.seconds() / static_cast<double>(done), kShortest);
  return {scene.name, std::ssize(tiles), unit, kStartOfMap};
}

}  // namespace

farm::Plan planOf(const std::vector<SceneOfFile>& scenes, const PlanWishes& wishes) {
  farm::Plan plan{.work = wishes.work,
                  .program = fs::read_symlink("/proc/self/exe"),
                  .build = system::buildId(),
                  .folder = wishes.folder,
                  .cores = wishes.cores,
                  .arguments = wishes.arguments,
                  .joinArguments = wishes.joinArguments};
  for (const SceneOfFile& one : scenes) plan.scenes.push_back(plannedOf(one, wishes));
  return plan;
}

std::vector<farm::Effort> measureEfforts(const farm::Plan& plan,
                                         const std::vector<SceneOfFile>& scenes,
                                         const picture::DeviceChoice& device) {
  if (plan.work == farm::Work::Study) return unmeasuredEfforts(plan);
  std::vector<farm::Effort> efforts;
  // Of many clips those between two that are measured count as the first of these
  const std::size_t step = (scenes.size() + kMaxMeasured - 1) / kMaxMeasured;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const SceneOfFile& one = scenes[i];
    if (plan.work == farm::Work::Map) {
      efforts.push_back(effortOfMap(one.scene, plan.cores));
    } else if (i % step == 0) {
      efforts.push_back(effortOfClip(one, plan.cores, device));
    } else {
      farm::Effort effort = efforts.back();
      effort.name = one.scene.name;
      effort.unit *= pixelsOf(one.scene) / pixelsOf(scenes[i - 1].scene);
      effort.units = plan.scenes[i].units;
      efforts.push_back(effort);
    }
  }
  return efforts;
}

std::vector<farm::Effort> unmeasuredEfforts(const farm::Plan& plan) {
  std::vector<farm::Effort> efforts;
  for (const farm::PlannedScene& scene : plan.scenes)
    efforts.push_back({scene.name, scene.units, 1, 0});
  return efforts;
}

}  // namespace rotatebook::cli
