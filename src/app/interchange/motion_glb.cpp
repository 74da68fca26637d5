#include "interchange/motion_glb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "base/error.h"
#include "base/number_text.h"
#include "base/version.h"
#include "geometry/camera.h"
#include "interchange/glb_body.h"
#include "interchange/glb_file.h"
#include "scene/reference_frame.h"
#include "scene/scene_text.h"
#include "scene/source_locations.h"
#include "timeline/camera_distances.h"
#include "timeline/motion_checksum.h"
#include "timeline/scene_camera.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::interchange {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;

void append(const Eigen::Ref<const Eigen::VectorXd>& values, std::vector<float>& numbers) {
  for (const double value : values) numbers.push_back(static_cast<float>(value));
}

/// Returns [x, y, z, w].
Json quaternionJson(const Quaterniond& q) {
  return Json::array({q.x(), q.y(), q.z(), q.w()});
}

/// The channels of an animation.
struct Channels {
  Json samplers = Json::array(), channels = Json::array();

  void add(std::size_t times, std::size_t values, const char* interpolation, std::size_t node,
           const char* path) {
    channels.push_back(
        {{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers.push_back({{"input", times}, {"output", values}, {"interpolation", interpolation}});
  }
};

void addTurning(const Turning& turning, bool tangents, std::size_t node, Channels& channels,
                GlbFile& glb) {
  std::vector<float> times, values;
  for (const Key& key : turning.keys) {
    times.push_back(static_cast<float>(key.time));
    if (tangents) append(key.tangent.coeffs(), values);
    append(key.attitude.coeffs(), values);
    if (tangents) append(key.tangent.coeffs(), values);
  }
  const std::size_t input = glb.addFloats(times, 1, Numbers::Ranged);
  channels.add(input, glb.addFloats(values, 4, Numbers::OfKeys),
               tangents ? "CUBICSPLINE" : "LINEAR", node, "rotation");
}

/// A camera's place in the world.
struct CameraPlace {
  Eigen::Vector3d position;  // [m]
  Quaterniond attitude;      // World from camera: x right, y up, z toward the viewer.
};

/// The camera of a motion, from frame to frame.
class WorldCamera {
 public:
  /// `scene` has the motion alone; `distance` is a multiple of the camera's.
  WorldCamera(const scene::Scene& scene, double distance)
      : path_(scene, {scene.clip.width, scene.clip.height, 0}),
        frame_(scene::referenceFramesOf(scene).front()),
        distance_(distance) {}

  bool moves() const { return path_.moves() || frame_.kind() != scene::ReferenceFrame::World; }
  geometry::Camera at(std::int64_t frame) const {
    return geometry::movedAway(path_.at(frame), distance_);
  }
  CameraPlace placeAt(std::int64_t frame, const physics::Sample& sample) const {
    const geometry::Camera camera = at(frame);
    const Matrix3d worldFromFrame = frame_.fromWorld(sample).transpose();
    const Matrix3d viewFromFrame = geometry::viewFromWorld(camera).topLeftCorner<3, 3>();
    return {worldFromFrame * camera.position,
            Quaterniond(Matrix3d(worldFromFrame * viewFromFrame.transpose()))};
  }

 private:
  timeline::CameraPath path_;
  scene::MotionFrame frame_;
  double distance_;
};

std::size_t addCamera(const scene::Scene& scene, const WorldCamera& camera,
                      const physics::Sample& start, GlbFile& glb) {
  constexpr double kNear = 0.01;  // Share of the distance to the target.
  const geometry::Camera first = camera.at(0);
  const double aspect = static_cast<double>(scene.clip.width) / scene.clip.height;
  const std::size_t number =
      glb.add("cameras", {{"type", "perspective"},
                          {"perspective",
                           {{"aspectRatio", aspect},
                            {"yfov", first.fieldOfViewDeg * std::numbers::pi / 180},
                            {"znear", kNear * (first.position - first.target).norm()}}}});
  const CameraPlace place = camera.placeAt(0, start);
  return glb.add("nodes", {{"name", "camera"},
                           {"camera", number},
                           {"translation", vectorJson(place.position)},
                           {"rotation", quaternionJson(place.attitude)}});
}

/// Adds a key for each of the motion's frames.
void addCameraMoves(const scene::Scene& scene, const WorldCamera& camera,
                    const std::vector<physics::Sample>& samples, std::size_t node,
                    Channels& channels, GlbFile& glb) {
  std::vector<float> times, places, attitudes;
  Quaterniond last = Quaterniond::Identity();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto frame = static_cast<std::int64_t>(i);
    CameraPlace place = camera.placeAt(frame, samples[i]);
    if (i > 0 && place.attitude.dot(last) < 0) place.attitude.coeffs() *= -1;
    last = place.attitude;
    times.push_back(static_cast<float>(static_cast<double>(i) * scene.clip.frameRate.period()));
    append(place.position, places);
    append(place.attitude.coeffs(), attitudes);
  }
  const std::size_t input = glb.addFloats(times, 1, Numbers::Ranged);
  channels.add(input, glb.addFloats(places, 3, Numbers::OfKeys), "LINEAR", node, "translation");
  channels.add(input, glb.addFloats(attitudes, 4, Numbers::OfKeys), "LINEAR", node, "rotation");
}

void refuseOthers(const scene::Scene& scene, const scene::Panel& motion) {
  const auto refuse = [&](const char* key, const std::string& why) {
    throw InputError(locationOf(scene, key) + ": " + why);
  };
  if (scene.grid) refuse("grid", "a GLB has one motion, but a grid has many; leave [grid] out");
  if (scene.map) refuse("map", "a GLB has one motion, but a map has many; leave [map] out");
  if (motion.simulation.model == physics::Model::Particles)
    refuse("simulation.model",
           "the model \"particles\" deforms the body, and a GLB has a rigid one; export the rigid "
           "motion, by the model \"quaternion\" or \"exact\", or another panel, with --panel");
}

/// Throws InputError for a motion whose steps stretch the body, as those of a matrix or a
/// quaternion that isn't normalised do.
void refuseStretched(const scene::Scene& scene, const std::vector<physics::Sample>& samples) {
  constexpr double kSeen = 0.01;
  double most = 0;
  for (const physics::Sample& sample : samples)
    most = std::max({most, sample.stretchMax - 1, 1 - sample.stretchMin});
  if (!(most > kSeen)) return;
  throw InputError(fmt::format(
      "{}: the motion's errors stretch or shrink the body by up to {:.0f} %, and a GLB has "
      "a rigid one; set "
      "simulation.normalize, or export another model or panel",
      locationOf(scene, "simulation.model"), std::ceil(100 * most)));
}

std::vector<std::string> notesOn(const scene::Scene& scene, const physics::Trajectory& motion,
                                 const Turning& turning) {
  constexpr double kCoarseDeg = 1;
  std::vector<std::string> notes;
  if (motion.divergedAt)
    notes.push_back(fmt::format("the motion diverges at {} s, before which the animation ends",
                                roundedText(*motion.divergedAt, 6)));
  if (turning.errorDeg > kCoarseDeg)
    notes.push_back(fmt::format(
        "between its keys the animation is up to {} degrees off the motion; take more keys a "
        "second with --keys, or --tangents",
        roundedText(turning.errorDeg, 2)));
  if (std::ranges::any_of(scene.cues,
                          [](const auto& cue) { return cue.move && cue.move->fieldOfViewDeg; }))
    notes.push_back("the camera's angle of view stays as it is at the start: glTF can't change it");
  return notes;
}

}  // namespace

MotionGlb motionGlb(const scene::Scene& scene, std::size_t motion, const GlbOptions& options) {
  const scene::Panel& panel = scene.motions.at(motion);
  refuseOthers(scene, panel);
  const scene::Scene alone = scene::withMotion(scene, panel);
  const timeline::ClipMotion clip = timeline::simulateScene(scene);
  const physics::Trajectory& trajectory = clip.trajectories()[motion];
  const std::vector<physics::Sample>& samples = trajectory.samples;
  refuseStretched(scene, samples);
  const Turning turning = turningOf(alone, std::ssize(samples), options);

  Json extras{{"scene", scene::sceneText(scene)}};
  if (!panel.label.empty()) extras["panel"] = panel.label;
  extras["motion_xxh128"] = timeline::motionChecksum(clip);
  GlbFile glb(Json{{"generator", std::string("rotatebook ") + kVersion},
                   {"version", "2.0"},
                   {"extras", std::move(extras)}});
  const std::size_t joint = glb.add(
      "nodes", {{"name", "turning"}, {"rotation", quaternionJson(turning.keys.front().attitude)}});
  const std::size_t skin = glb.add("skins", {{"joints", {joint}}});
  const std::size_t body =
      glb.add("nodes", {{"name", "body"}, {"mesh", addBody(alone, glb)}, {"skin", skin}});
  const WorldCamera camera(alone, timeline::distanceAtRest(scene, motion));
  const std::size_t view = addCamera(alone, camera, samples.front(), glb);
  glb.add("scenes", {{"nodes", {joint, body, view}}});
  glb.set("scene", 0);
  Channels channels;
  addTurning(turning, options.tangents, joint, channels, glb);
  if (camera.moves()) addCameraMoves(alone, camera, samples, view, channels, glb);
  glb.add("animations",
          {{"name", scene.name}, {"samplers", channels.samplers}, {"channels", channels.channels}});
  return {glb.bytes(), turning.keys.size(), turning.keys.back().time, turning.errorDeg,
          notesOn(scene, trajectory, turning)};
}

}  // namespace rotatebook::interchange
