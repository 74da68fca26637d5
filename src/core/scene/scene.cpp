#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/elementary.h"

namespace rotatebook::scene {

const std::size_t kSceneSize = sizeof(Scene);

namespace {

const std::optional<PlaybackSpeed>& playbackOf(const Scene& scene) {
  return scene.schedule ? scene.schedule : scene.clip.speed;
}

}  // namespace

bool hasEvenTimes(const Scene& scene) {
  const std::optional<PlaybackSpeed>& speed = playbackOf(scene);
  return !speed || speed->stretches.empty();
}

double timeAt(const Scene& scene, double frame) {
  if (hasEvenTimes(scene)) return frame * scene.timePerFrame();
  return playbackOf(scene)->timeAt(frame * scene.clip.frameRate.period(), scene.clip.duration);
}

double speedAt(const Scene& scene, double frame) {
  const double period = scene.clip.frameRate.period();
  const std::optional<PlaybackSpeed>& speed = playbackOf(scene);
  return speed ? speed->at(frame * period) : scene.timePerFrame() / period;
}

std::vector<double> speedsOf(const Scene& scene) {
  const std::optional<PlaybackSpeed>& speed = playbackOf(scene);
  if (!speed) return {speedAt(scene, 0)};
  std::vector<double> speeds{speed->constant};
  for (const SpeedStretch& stretch : speed->stretches) speeds.push_back(stretch.value);
  return speeds;
}

const std::string& captionAt(const Scene& scene, std::int64_t frame) {
  const std::string* caption = &scene.caption;
  for (const ShownCue& shown : scene.shownCues) {
    const std::optional<std::string>& text = scene.cues[shown.cue].text;
    if (shown.frame <= frame && text) caption = &*text;
  }
  return *caption;
}

void sampleAsAsked(const StudySettings& study, physics::MotionSettings& motion) {
  if (!study.interval) return;
  if (!motion.simulation.substepped) motion.simulation.substepped = motion.simulation.timePerFrame;
  motion.simulation.timePerFrame = *study.interval;
}

std::int64_t studiedSamples(const Scene& scene, const StudySettings& study,
                            const physics::MotionSettings& motion) {
  const std::int64_t frames = scene.clip.frameCount();
  if (!study.duration && !study.interval) return frames;
  const double clip = static_cast<double>(frames - 1) * scene.timePerFrame();
  const double intervals = study.duration.value_or(clip) / motion.simulation.timePerFrame;
  constexpr double kRounding = 1e-9;  // 0.3 / 0.1 is less than 3
  constexpr double kMany = 1e15;
  return 1 + static_cast<std::int64_t>(std::min(intervals * (1 + kRounding), kMany));
}

std::int64_t studiedSteps(const physics::MotionSettings& motion, std::int64_t samples) {
  const double length = static_cast<double>(samples - 1) * motion.simulation.timePerFrame;
  return std::max<std::int64_t>(std::llround(length / motion.simulation.steps().length()), 1);
}

Scene withMotion(Scene scene, Panel motion) {
  scene.grid.reset();
  motion.label.clear();
  scene.motions = {std::move(motion)};
  return scene;
}

bool isTransparent(const Spec& scene) {
  return scene.look.background == Background::Transparent;
}

namespace {

/// Returns the sine of half the angle of view over the picture's shorter side.
double sineOfView(double fieldOfViewDeg, int width, int height) {
  const double halfAngle = fieldOfViewDeg / 2 * std::numbers::pi / 180;
  const double halfHeight = sine(halfAngle) / cosine(halfAngle);
  const double halfWidth = halfHeight * width / height;
  return sine(arcTangent(std::min(halfHeight, halfWidth)));
}

}  // namespace

double radiusInView(const Scene& scene, int width, int height) {
  return (scene.cameraPosition - scene.camera.target).norm() *
         sineOfView(scene.camera.fieldOfViewDeg, width, height);
}

Eigen::Vector3d defaultCameraPosition(const body::Cuboid& body, double fieldOfViewDeg, int width,
                                      int height) {
  // From the right and a little above: all three kinds of sides are visible, the cover most.
  const Eigen::Vector3d direction = Eigen::Vector3d(0.42, 0.30, 1).normalized();
  // The sphere that the corners never leave touches the narrower pair of the view frustum's sides.
  return direction *
         (kRoomAround * body.size.norm() / 2 / sineOfView(fieldOfViewDeg, width, height));
}

std::vector<MotionFrame> referenceFramesOf(const Scene& scene) {
  std::vector<MotionFrame> frames;
  for (const Panel& panel : scene.motions) {
    frames.emplace_back(panel.frame.value_or(scene.camera.frame), panel);
  }
  return frames;
}

bool shows(const Scene& scene, Overlay overlay) {
  if (scene.textless && !onTheBody(overlay)) return false;
  return std::ranges::count(scene.overlay.show, overlay) > 0;
}

}  // namespace rotatebook::scene
