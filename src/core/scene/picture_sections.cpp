// The sections [clip], [video], [[cue]], [camera], [book], [look] and [overlay]: how the motion is
// shown.
#include <algorithm>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "base/document/problems.h"
#include "base/number_text.h"
#include "scene/keys/keys.h"
#include "scene/names.h"
#include "scene/sections.h"
#include "scene/source_locations.h"

namespace rotatebook::scene {
namespace {

constexpr double kMinDistance = 1e-9;  // [m]
constexpr double kMinSine = 1e-6;      // Below this sine of their angle, directions are parallel.

/// Returns the reason why no motion of `scene` has `overlay`.
std::string reasonForAbsence(Overlay overlay, const Scene& scene) {
  const std::string name(nameOf(kOverlays, overlay));
  if (rowOf(overlay).models == OverlayModels::Particles) {
    const auto isOfParticles = [](const Panel& panel) {
      return panel.simulation.model == physics::Model::Particles;
    };
    if (std::ranges::any_of(scene.motions, isOfParticles))
      return name + " are drawn between eight particles; set simulation.particles to \"corners\" " +
             "or \"equimomental\"";
    return name + " exist only in the particles model; " +
           (scene.hasPanels()
                ? "no panel of this scene has it"
                : "this scene's is " +
                      std::string(nameOf(kModels, scene.motions[0].simulation.model)));
  }
  if (rowOf(overlay).models == OverlayModels::Rigid)
    return name +
           " is for rigid bodies; set simulation.model to \"exact\", \"quaternion\" or \"matrix\"";
  return name + " shows how far a motion is from the exact one, and this scene's is the exact one";
}

void checkFrames(const ValueReader& section, ClipSettings& clip) {
  // framesIn() counts in 64 bits, which an absurd duration would overflow. The default duration is
  // valid at any rate, so an invalid one is in the file.
  const bool tooMany = clip.duration / clip.frameRate.period() > kMaxFrames;
  if (tooMany || clip.frameCount() < 1) {
    const std::string rate = clip.frameRate.text();
    section.find("duration")
        ->mismatch("long enough for 1 frame and short enough for " + std::to_string(kMaxFrames) +
                   " at " + rate + (rate == "1" ? " frame" : " frames") + " a second");
  }
}

/// Throws InputError for a poster after the end that the section states; it is the last frame then,
/// but says with a wrong duration what was meant.
void refusePosterAfterEnd(const ValueReader& section) {
  const auto poster = section.find("poster"), duration = section.find("duration");
  if (!poster || !duration) return;
  constexpr NumberRange kTime{document::kNumber.expected, document::kNumber.min,
                              document::kNumber.max, Dimension::Time};
  const double at = poster->number(kTime), end = duration->number(kTime);
  if (at <= end) return;
  poster->fail(poster->name() + " is at " + shortestText(at) +
               " s, after the end of the clip, which is to last " + shortestText(end) + " s");
}

/// Returns [clip], of which all is said that is wrong.
Section<Spec> clipSection() {
  auto clip = section<Spec>("clip", &Spec::clip, clipKeys(), checkFrames);
  clip.read = [read = clip.read](const ValueReader& value, Spec& spec) {
    document::Problems problems;
    problems.note([&] { read(value, spec); });
    if (!problems.all().empty()) problems.note([&] { refusePosterAfterEnd(value); });
    problems.throwIfAny();
  };
  return clip;
}

/// The ways in which a camera may see.
enum class View { Whole, Nowhere, AlongUp };

View viewOf(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
            const Eigen::Vector3d& up) {
  const Eigen::Vector3d view = target - position;
  if (view.norm() < kMinDistance) return View::Nowhere;
  const double sine = view.stableNormalized().cross(up.stableNormalized()).norm();
  return sine < kMinSine ? View::AlongUp : View::Whole;
}

}  // namespace

std::span<const Section<Spec>> pictureSections() {
  static const std::vector<Section<Spec>> sections{
      clipSection(),
      section<Spec>("video", &Spec::video, videoKeys()),
      cueSection(),
      section<Spec>("camera", &Spec::camera, cameraKeys()),
      section<Spec>("book", &Spec::book, bookKeys()),
      section<Spec>("look", &Spec::look, lookKeys()),
      section<Spec>("overlay", &Spec::overlay, overlayKeys()),
  };
  return sections;
}

void checkOverlays(const Scene& scene) {
  const std::vector<Overlay>& show = scene.overlay.show;
  for (std::size_t i = 0; i < show.size(); ++i) {
    const auto hasIt = [&](const Panel& panel) { return isFor(panel.simulation, show[i]); };
    if (std::ranges::any_of(scene.motions, hasIt)) continue;
    document::failAt(scene.locations.of({"overlay.show." + std::to_string(i)}),
                     "overlay.show: " + reasonForAbsence(show[i], scene));
  }
}

void checkCamera(const Scene& scene) {
  // The defaults make a valid camera, so one of the keys that are present is at fault
  switch (viewOf(scene.cameraPosition, scene.camera.target, scene.camera.up)) {
    case View::Nowhere:
      document::failAt(scene.locations.of({"camera.position", "camera.target", "camera"}),
                       "camera.position and camera.target must be different points");
    case View::AlongUp:
      document::failAt(
          scene.locations.of({"camera.up", "camera.position", "camera.target", "camera"}),
          "camera.up must not be parallel to the direction from camera.position to camera.target");
    case View::Whole:
      break;
  }
}

void checkMoves(const Scene& scene) {
  Eigen::Vector3d position = scene.cameraPosition, target = scene.camera.target;
  for (std::size_t i = 0; i < scene.cues.size(); ++i) {
    if (!scene.cues[i].move) continue;
    const CameraMove& move = *scene.cues[i].move;
    const Eigen::Vector3d before = position - target;
    target = move.target.value_or(target);
    position = move.position.value_or(target + before);
    const View view = viewOf(position, target, scene.camera.up);
    if (view == View::Whole) continue;
    document::failAt(locationOf(scene, cueKey(i)),
                     view == View::Nowhere
                         ? "the camera's position and target must be different points, also after "
                           "this cue"
                         : "the camera's direction of view must not be parallel to camera.up, "
                           "also after this cue");
  }
}

}  // namespace rotatebook::scene
