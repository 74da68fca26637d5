#include "bridge/scene_json.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/document/toml_tree.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/version.h"
#include "physics/motion_start.h"
#include "recording/read_recording.h"
#include "scene/key_rows.h"
#include "scene/names.h"

namespace rotatebook::bridge {
namespace {

std::string modelJson(const scene::Named<physics::Model>& model) {
  return JsonObject()
      .addString("name", model.name)
      .add("integrators", jsonArrayOf(scene::integratorNames(model.value), jsonString))
      .addStringOrNull("integrator",
                       takesSteps(model.value)
                           ? scene::nameOf(scene::kIntegrators, defaultIntegrator(model.value))
                           : "")
      .text();
}

/// Returns the JSON of a key: its limits, if it has any, its unit, and the models that it is of.
std::string keyJson(const scene::KeyRow& key) {
  using Type = scene::ValueForm::Type;
  constexpr std::array<std::string_view, 6> kTypes{"own",    "integer", "number",
                                                   "vector", "text",    "choice"};
  std::vector<std::string> models;
  for (const auto& [name, model] : scene::kModels) {
    if (key.models.have(model)) models.push_back(jsonString(name));
  }
  JsonObject object;
  object.addString("type", kTypes[static_cast<std::size_t>(key.form.type)])
      .addString("unit", key.unit)
      .add("models", jsonArray(models));
  if (key.form.type == Type::Choice)
    return object.add("choices", jsonArrayOf(key.form.choices, jsonString)).text();
  if (key.form.type == Type::Own) return object.text();
  return object.addNumber("min", key.form.min).addNumber("max", key.form.max).text();
}

std::string keysJson() {
  JsonObject object;
  for (const scene::KeyRow& key : scene::allKeys()) object.add(key.name, keyJson(key));
  return object.text();
}

/// Returns [[i, j, length]] for the springs between all pairs of corners. [m]
std::string springsJson(const physics::Cuboid& body) {
  const physics::Cage corners = body.corners();
  std::vector<std::string> springs;
  for (int i = 0; i < 8; ++i) {
    for (int j = i + 1; j < 8; ++j) {
      const double length = (corners.col(i) - corners.col(j)).norm();
      springs.push_back(jsonArray({std::to_string(i), std::to_string(j), shortestText(length)}));
    }
  }
  return jsonArray(springs);
}

std::string motionJson(const scene::Panel& panel) {
  const physics::SimulationSettings& simulation = panel.simulation;
  JsonObject object;
  object.addString("label", panel.label)
      .addString("model", scene::nameOf(scene::kModels, simulation.model))
      .add("body", vectorJson(panel.body.size))
      .add("moments", vectorJson(physics::modelInertia(panel.motion()).moments));
  // A page draws springs between the corners of the cage.
  const bool areCorners = simulation.particles.arrangement == physics::Arrangement::Corners;
  if (simulation.model == physics::Model::Particles && areCorners)
    object.add("springs", springsJson(panel.body));
  return object.text();
}

/// Returns [[frame, text]] of the captions in time.
std::string captionsJson(const scene::Scene& scene) {
  std::vector<std::string> captions;
  for (const scene::ShownCue& shown : scene.shownCues) {
    const std::optional<std::string>& text = scene.cues[shown.cue].text;
    if (text) captions.push_back(jsonArray({std::to_string(shown.frame), jsonString(*text)}));
  }
  return jsonArray(captions);
}

/// Returns the longest stretch, of the file's times, in which a body turns at least half as fast as
/// it mostly does while it turns; null of one that rests.
std::string turningJson(std::string_view bytes, const std::string& name) {
  const recording::InertialRecording recording = recording::readInertial(bytes, name, {});
  std::vector<double> speeds, fast;
  for (const recording::InertialReading& reading : recording.readings) {
    speeds.push_back(reading.rate.angularVelocity.norm());
    if (speeds.back() > recording::kSlowestThrow) fast.push_back(speeds.back());
  }
  if (fast.empty()) return "null";
  const auto middle = fast.begin() + std::ssize(fast) / 2;
  std::nth_element(fast.begin(), middle, fast.end());
  std::size_t first = 0, count = 0, begin = 0;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (speeds[i] < *middle / 2) begin = i + 1;
    if (i + 1 > begin + count) std::tie(first, count) = std::pair(begin, i + 1 - begin);
  }
  const auto time = [&](std::size_t i) {
    return shortestText(recording.zero + recording.readings[i].rate.time);
  };
  return jsonArray({time(first), time(first + count - 1)});
}

}  // namespace

std::string wordsJson() {
  // No recording is read in a page.
  std::vector<scene::Named<physics::Model>> models(scene::kModels.begin(), scene::kModels.end());
  std::erase_if(models, [](const auto& one) { return one.value == physics::Model::Recorded; });
  return JsonObject()
      .addString("version", kVersion)
      .add("models", jsonArrayOf(models, modelJson))
      .add("keys", keysJson())
      .addInteger("longestScene", document::kLongestToml)
      .addInteger("maxNudges", scene::kMaxNudges)
      .text();
}

std::string recordingJson(std::string_view bytes, const std::string& name) {
  return JsonObject()
      .addNumber("duration", recording::readRecording(bytes, name, {}).duration())
      .add("turning", turningJson(bytes, name))
      .text();
}

std::string sceneJson(const scene::Scene& scene) {
  const std::vector<scene::Panel>& motions = scene.motions;
  const FrameRate rate = scene.clip.frameRate;
  return JsonObject()
      .add("rate", jsonArray({std::to_string(rate.numerator), std::to_string(rate.denominator)}))
      .addNumber("interval", motions.front().simulation.timePerFrame)
      .add("motions", jsonArrayOf(motions, motionJson))
      .add("captions", captionsJson(scene))
      .text();
}

}  // namespace rotatebook::bridge
