#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/version.h"
#include "picture/interchange/exported_body.h"
#include "picture/interchange/exported_motion.h"
#include "picture/interchange/glb_body.h"
#include "picture/interchange/glb_file.h"
#include "picture/interchange/motion_file.h"

namespace rotatebook::interchange {
namespace {

void append(const Eigen::Ref<const Eigen::VectorXd>& values, std::vector<float>& numbers) {
  for (const double value : values) numbers.push_back(static_cast<float>(value));
}

/// Returns [x, y, z, w].
Json quaternionJson(const Eigen::Quaterniond& q) {
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

/// Returns the weights of the morph targets at a key, from 0 to 1.
std::vector<float> weightsOf(const Key& key, double reach) {
  std::vector<float> weights;
  append(((key.displacements / reach).array() / 2 + 0.5).matrix().reshaped(), weights);
  return weights;
}

/// Adds the turning of the joint, and the morphs of the body if it deforms.
void addTurning(const Turning& turning, bool tangents, std::size_t joint, std::size_t body,
                Channels& channels, GlbFile& glb) {
  std::vector<float> times, values, weights;
  for (const Key& key : turning.keys) {
    times.push_back(static_cast<float>(key.time));
    if (tangents) append(key.tangent.coeffs(), values);
    append(key.attitude.coeffs(), values);
    if (tangents) append(key.tangent.coeffs(), values);
    if (!turning.reach) continue;
    const std::vector<float> more = weightsOf(key, *turning.reach);
    weights.insert(weights.end(), more.begin(), more.end());
  }
  const std::size_t input = glb.addFloats(times, 1, Numbers::Ranged);
  channels.add(input, glb.addFloats(values, 4, Numbers::OfKeys),
               tangents ? "CUBICSPLINE" : "LINEAR", joint, "rotation");
  if (turning.reach)
    channels.add(input, glb.addFloats(weights, 1, Numbers::OfKeys), "LINEAR", body, "weights");
}

std::size_t addCamera(const ExportedMotion& motion, GlbFile& glb) {
  const std::size_t number = glb.add("cameras", {{"type", "perspective"},
                                                 {"perspective",
                                                  {{"aspectRatio", motion.aspect},
                                                   {"yfov", motion.fieldOfView},
                                                   {"znear", motion.nearest}}}});
  const CameraPlace& place = motion.cameraKeys.front().place;
  return glb.add("nodes", {{"name", "camera"},
                           {"camera", number},
                           {"translation", vectorJson(place.position)},
                           {"rotation", quaternionJson(place.attitude)}});
}

void addCameraMoves(const std::vector<CameraKey>& keys, std::size_t node, Channels& channels,
                    GlbFile& glb) {
  std::vector<float> times, places, attitudes;
  for (const CameraKey& key : keys) {
    times.push_back(static_cast<float>(key.time));
    append(key.place.position, places);
    append(key.place.attitude.coeffs(), attitudes);
  }
  const std::size_t input = glb.addFloats(times, 1, Numbers::Ranged);
  channels.add(input, glb.addFloats(places, 3, Numbers::OfKeys), "LINEAR", node, "translation");
  channels.add(input, glb.addFloats(attitudes, 4, Numbers::OfKeys), "LINEAR", node, "rotation");
}

Json assetOf(const ExportedMotion& motion) {
  Json extras{{"scene", motion.text}};
  if (!motion.panel.empty()) extras["panel"] = motion.panel;
  extras["motion_xxh128"] = motion.checksum;
  return {{"generator", std::string(kMaker) + kVersion},
          {"version", "2.0"},
          {"extras", std::move(extras)}};
}

}  // namespace

MotionFile motionGlb(const scene::Scene& scene, std::size_t motion, const KeyOptions& options) {
  const ExportedMotion exported = exportedMotion(scene, motion, options);
  const Turning& turning = exported.turning;
  const Key& first = turning.keys.front();
  GlbFile glb(assetOf(exported));
  const std::size_t joint =
      glb.add("nodes", {{"name", "turning"}, {"rotation", quaternionJson(first.attitude)}});
  const std::size_t skin = glb.add("skins", {{"joints", {joint}}});
  const std::size_t mesh = addBody(exportedBody(exported.scene), turning.reach, glb);
  Json bodyNode{{"name", "body"}, {"mesh", mesh}, {"skin", skin}};
  if (turning.reach) bodyNode["weights"] = weightsOf(first, *turning.reach);
  const std::size_t body = glb.add("nodes", std::move(bodyNode));
  const std::size_t view = addCamera(exported, glb);
  glb.add("scenes", {{"nodes", {joint, body, view}}});
  glb.set("scene", 0);
  Channels channels;
  addTurning(turning, options.tangents, joint, body, channels, glb);
  if (exported.cameraKeys.size() > 1) addCameraMoves(exported.cameraKeys, view, channels, glb);
  glb.add("animations",
          {{"name", scene.name}, {"samplers", channels.samplers}, {"channels", channels.channels}});
  return motionFile(glb.bytes(), exported);
}

}  // namespace rotatebook::interchange
