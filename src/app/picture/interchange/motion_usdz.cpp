#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "base/error.h"
#include "base/version.h"
#include "picture/interchange/aligned_zip.h"
#include "picture/interchange/exported_body.h"
#include "picture/interchange/exported_motion.h"
#include "picture/interchange/motion_file.h"
#include "picture/interchange/usd_body.h"
#include "picture/interchange/usd_layer.h"
#include "scene/source_locations.h"

namespace rotatebook::interchange {
namespace {

constexpr const char* kRoot = "motion";

/// Returns the beginning of a layer, of which the maker is a part.
std::string beginning() {
  return std::string(R"(#usda 1.0
(
    customLayerData = {
        string creator = ")") +
         kMaker;
}

/// Adds what the layer says of itself; its time codes are keys.
void addHead(const ExportedMotion& motion, UsdLayer& layer) {
  const Turning& turning = motion.turning;
  layer.open("", '(');
  layer.open("customLayerData =");
  layer.line(fmt::format("string creator = {}", usdQuoted(std::string(kMaker) + kVersion)));
  layer.line(fmt::format("string motion_xxh128 = {}", usdQuoted(motion.checksum)));
  if (!motion.panel.empty()) layer.line(fmt::format("string panel = {}", usdQuoted(motion.panel)));
  layer.line(fmt::format("string scene = {}", usdQuoted(motion.text)));
  layer.close();
  layer.line(fmt::format("defaultPrim = {}", usdQuoted(kRoot)));
  layer.line(fmt::format("endTimeCode = {}", turning.keys.size() - 1));
  layer.line(fmt::format("framesPerSecond = {}", turning.keysPerSecond));
  layer.line("metersPerUnit = 1");
  layer.line("startTimeCode = 0");
  layer.line(fmt::format("timeCodesPerSecond = {}", turning.keysPerSecond));
  layer.line("upAxis = \"Y\"");
  layer.close();
}

/// Adds an attribute with a value for each key, or one value for all times.
template <typename Keys, typename TimeOf, typename TextOf>
void addSamples(const char* name, const Keys& keys, const TimeOf& timeOf, const TextOf& textOf,
                UsdLayer& layer) {
  if (keys.size() == 1) {
    layer.line(fmt::format("{} = {}", name, textOf(keys.front())));
    return;
  }
  layer.open(fmt::format("{}.timeSamples =", name));
  for (const auto& key : keys) layer.line(fmt::format("{}: {},", timeOf(key), textOf(key)));
  layer.close();
}

void addTurningBody(const ExportedMotion& motion, const ExportedBody& body, UsdLayer& layer) {
  const int rate = motion.turning.keysPerSecond;
  layer.open("def Xform \"turning\"");
  addSamples(
      "quatf xformOp:orient", motion.turning.keys,
      [&](const Key& key) { return std::lround(key.time * rate); },
      [](const Key& key) { return usdText(key.attitude); }, layer);
  layer.line("uniform token[] xformOpOrder = [\"xformOp:orient\"]");
  addBody(body, fmt::format("/{}/turning", kRoot), layer);
  layer.close();
}

/// Adds the camera, with a lens of 50 mm, of which USD states tenths of metres.
void addCameraPrim(const ExportedMotion& motion, UsdLayer& layer) {
  constexpr double kLens = 0.5, kFarthest = 1e5;
  const int rate = motion.turning.keysPerSecond;
  const double high = 2 * kLens * std::tan(motion.fieldOfView / 2);
  const auto timeOf = [&](const CameraKey& key) { return key.time * rate; };
  layer.open("def Camera \"camera\"");
  layer.line(fmt::format("float2 clippingRange = ({}, {})", static_cast<float>(motion.nearest),
                         static_cast<float>(motion.nearest * kFarthest)));
  layer.line(fmt::format("float focalLength = {}", kLens));
  layer.line(
      fmt::format("float horizontalAperture = {}", static_cast<float>(high * motion.aspect)));
  layer.line(fmt::format("float verticalAperture = {}", static_cast<float>(high)));
  addSamples(
      "double3 xformOp:translate", motion.cameraKeys, timeOf,
      [](const CameraKey& key) {
        return usdText(Eigen::Vector3f(key.place.position.cast<float>()));
      },
      layer);
  addSamples(
      "quatf xformOp:orient", motion.cameraKeys, timeOf,
      [](const CameraKey& key) { return usdText(key.place.attitude); }, layer);
  layer.line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]");
  layer.close();
}

void requireRigid(const ExportedMotion& motion, const KeyOptions& options) {
  if (options.tangents)
    throw InputError("--tangents: USD has no tangents; leave it out, or name a .glb");
  if (motion.turning.reach)
    throw InputError(scene::locationOf(motion.scene, "simulation.model") +
                     ": this motion deforms the body, and a USDZ has a rigid one; name a .glb");
}

}  // namespace

MotionFile motionUsdz(const scene::Scene& scene, std::size_t motion, const KeyOptions& options) {
  const ExportedMotion exported = exportedMotion(scene, motion, options);
  requireRigid(exported, options);
  const ExportedBody body = exportedBody(exported.scene);
  UsdLayer layer;
  addHead(exported, layer);
  layer.open(fmt::format("def Xform \"{}\"", kRoot));
  addTurningBody(exported, body, layer);
  addCameraPrim(exported, layer);
  layer.close();
  std::vector<NamedBytes> files{{"motion.usda", layer.text()}};
  for (std::size_t i = 0; i < body.pictures.size(); ++i)
    files.push_back({pictureName(body, i), body.pictures[i].bytes});
  return motionFile(alignedZip(files), exported);
}

bool isMotionFile(std::string_view bytes) {
  constexpr std::size_t kGlbHeads = 20, kFirstFile = 64;
  const std::string glb = std::string(R"({"asset":{"generator":")") + kMaker;
  const auto begins = [&](std::size_t at, std::string_view text) {
    return bytes.size() > at && bytes.substr(at).starts_with(text);
  };
  return (bytes.starts_with("glTF") && begins(kGlbHeads, glb)) ||
         (bytes.starts_with("PK") && begins(kFirstFile, beginning()));
}

}  // namespace rotatebook::interchange
