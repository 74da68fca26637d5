#include "bridge/scene_json.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/document/toml_tree.h"
#include "base/json.h"
#include "base/number_text.h"
#include "base/version.h"
#include "physics/motion_start.h"
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
