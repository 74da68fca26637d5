#include "picture/interchange/exported_motion.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/number_text.h"
#include "scene/scene_text.h"
#include "scene/source_locations.h"
#include "timeline/camera_distances.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::interchange {
namespace {

[[noreturn]] void refuse(const scene::Scene& scene, const char* key, const char* why) {
  throw InputError(scene::locationOf(scene, key) + ": " + why);
}

/// Returns the way of the camera, whose attitudes keep their sign.
std::vector<CameraKey> cameraKeysOf(const scene::Scene& scene, const WorldCamera& camera,
                                    const std::vector<physics::Sample>& samples) {
  std::vector<CameraKey> keys;
  const std::size_t count = camera.moves() ? samples.size() : 1;
  for (std::size_t i = 0; i < count; ++i) {
    CameraPlace place = camera.placeAt(static_cast<std::int64_t>(i), samples[i]);
    if (i > 0 && place.attitude.dot(keys.back().place.attitude) < 0) place.attitude.coeffs() *= -1;
    keys.push_back({static_cast<double>(i) * scene.clip.frameRate.period(), place});
  }
  return keys;
}

WorldCamera cameraOf(const scene::Scene& scene, std::size_t motion,
                     const timeline::ClipMotion& clip, const scene::Scene& alone) {
  const timeline::CameraDistances all(scene, clip);
  std::vector<double> distances;
  for (std::size_t i = 0; i < clip.trajectories()[motion].samples.size(); ++i)
    distances.push_back(all.at(motion, static_cast<std::int64_t>(i)));
  return {alone, std::move(distances)};
}

std::vector<std::string> notesOn(const scene::Scene& scene, const physics::Trajectory& motion,
                                 const Turning& turning) {
  constexpr double kCoarseDeg = 1;
  std::vector<std::string> notes;
  if (motion.divergedAt)
    notes.push_back(fmt::format("the motion diverges at {} s, before which the animation ends",
                                roundedText(*motion.divergedAt, 6)));
  if (turning.errorDeg > kCoarseDeg) {
    const std::string remedy = turning.keysPerSecond < kMostKeys
                                   ? fmt::format("take more keys a second with --keys{}",
                                                 turning.reach ? "" : ", or --tangents")
                                   : "it turns too fast for keys";
    notes.push_back(
        fmt::format("between its keys the animation is up to {} degrees off the motion; {}",
                    roundedText(turning.errorDeg, 2), remedy));
  }
  if (std::ranges::any_of(scene.cues,
                          [](const auto& cue) { return cue.move && cue.move->fieldOfViewDeg; }))
    notes.emplace_back("the camera's angle of view stays as it is at the start");
  return notes;
}

}  // namespace

ExportedMotion exportedMotion(const scene::Scene& scene, std::size_t motion,
                              const KeyOptions& options) {
  if (scene.grid)
    refuse(scene, "grid", "an export has one motion, but a grid has many; leave [grid] out");
  if (scene.map)
    refuse(scene, "map", "an export has one motion, but a map has many; leave [map] out");
  const scene::Panel& panel = scene.motions.at(motion);
  scene::Scene alone = scene::withMotion(scene, panel);
  const timeline::ClipMotion clip = timeline::simulateScene(scene);
  const physics::Trajectory& trajectory = clip.trajectories()[motion];
  Turning turning = turningOf(alone, std::ssize(trajectory.samples), options);
  if (turning.reach && options.tangents)
    refuse(alone, "simulation.model",
           "--tangents: this motion deforms the body, and its corners have no exact tangents; "
           "leave --tangents out");
  const WorldCamera camera = cameraOf(scene, motion, clip, alone);
  std::vector<CameraKey> cameraKeys = cameraKeysOf(alone, camera, trajectory.samples);
  std::vector<std::string> notes = notesOn(scene, trajectory, turning);
  return {.scene = std::move(alone),
          .text = scene::sceneText(scene),
          .panel = panel.label,
          .checksum = timeline::motionChecksum(clip),
          .turning = std::move(turning),
          .aspect = camera.aspect(),
          .fieldOfView = camera.fieldOfView(),
          .nearest = camera.near(),
          .cameraKeys = std::move(cameraKeys),
          .notes = std::move(notes)};
}

MotionFile motionFile(std::string bytes, const ExportedMotion& motion) {
  const Turning& turning = motion.turning;
  MotionFile file{std::move(bytes), turning.keys.size(), turning.keys.back().time,
                  turning.errorDeg, std::nullopt,        motion.notes};
  if (turning.reach) file.errorM = turning.errorM;
  return file;
}

}  // namespace rotatebook::interchange
