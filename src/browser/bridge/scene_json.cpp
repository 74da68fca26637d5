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
#include "scene/key_rows.h"
#include "scene/names.h"
#include "scene/overlays.h"
#include "timeline/why_numbers.h"

namespace rotatebook::bridge {
namespace {

Json modelJson(const scene::Named<physics::Model>& model) {
  return Json{
      {"name", model.name},
      {"integrators", scene::integratorNames(model.value)},
      {"integrator", orNull(takesSteps(model.value)
                                ? scene::nameOf(scene::kIntegrators, defaultIntegrator(model.value))
                                : "")}};
}

/// Returns the JSON of a key: its limits, if it has any, its unit, and the models that it is of.
Json keyJson(const scene::KeyRow& key) {
  using Type = scene::ValueForm::Type;
  constexpr std::array<std::string_view, 6> kTypes{"own",    "integer", "number",
                                                   "vector", "text",    "choice"};
  Json models = Json::array();
  for (const auto& [name, model] : scene::kModels) {
    if (key.models.have(model)) models.push_back(name);
  }
  Json object{{"type", kTypes[static_cast<std::size_t>(key.form.type)]},
              {"unit", key.unit},
              {"models", models}};
  if (key.form.type == Type::Choice)
    object["choices"] = key.form.choices;
  else if (key.form.type != Type::Own)
    object.update({{"min", key.form.min}, {"max", key.form.max}});
  return object;
}

Json keysJson() {
  Json object;
  for (const scene::KeyRow& key : scene::allKeys()) object[key.name] = keyJson(key);
  return object;
}

/// Returns the models that each overlay is of.
Json overlaysJson() {
  Json object;
  for (const scene::OverlayRow& row : scene::kOverlayRows) {
    Json models = Json::array();
    for (const auto& [name, model] : scene::kModels) {
      if (scene::isFor({.model = model}, row.overlay)) models.push_back(name);
    }
    object[std::string(row.name)] = models;
  }
  return object;
}

/// Returns [[i, j, length]] for the springs between all pairs of corners. [m]
Json springsJson(const body::Cuboid& body) {
  const body::Cage corners = body.corners();
  Json springs = Json::array();
  for (int i = 0; i < 8; ++i) {
    for (int j = i + 1; j < 8; ++j) {
      const double length = (corners.col(i) - corners.col(j)).norm();
      springs.push_back(Json::array({i, j, length}));
    }
  }
  return springs;
}

Json motionJson(const scene::Panel& panel) {
  const physics::SimulationSettings& simulation = panel.simulation;
  Json object;
  object["label"] = panel.label;
  object["model"] = scene::nameOf(scene::kModels, simulation.model);
  object["body"] = vectorJson(panel.body.size);
  object["moments"] = vectorJson(timeline::momentsOf(panel));
  // A page draws springs between the corners of the cage.
  const bool areCorners = simulation.particles.arrangement == physics::Arrangement::Corners;
  if (simulation.model == physics::Model::Particles && areCorners)
    object["springs"] = springsJson(panel.body);
  return object;
}

/// Returns [[frame, text]] of the captions in time.
Json captionsJson(const scene::Scene& scene) {
  Json captions = Json::array();
  for (const scene::ShownCue& shown : scene.shownCues) {
    const std::optional<std::string>& text = scene.cues[shown.cue].text;
    if (text) captions.push_back(Json::array({shown.frame, *text}));
  }
  return captions;
}

}  // namespace

Json wordsJson() {
  // No recording is read in a page.
  std::vector<scene::Named<physics::Model>> models(scene::kModels.begin(), scene::kModels.end());
  std::erase_if(models, [](const auto& one) { return one.value == physics::Model::Recorded; });
  return {{"version", kVersion},
          {"models", arrayOf(models, modelJson)},
          {"keys", keysJson()},
          {"overlays", overlaysJson()},
          {"longestScene", document::kLongestToml},
          {"maxNudges", scene::kMaxNudges}};
}

Json sceneJson(const scene::Scene& scene) {
  const std::vector<scene::Panel>& motions = scene.motions;
  const FrameRate rate = scene.clip.frameRate;
  return {{"rate", Json::array({rate.numerator, rate.denominator})},
          {"interval", motions.front().simulation.timePerFrame},
          {"motions", arrayOf(motions, motionJson)},
          {"captions", captionsJson(scene)}};
}

}  // namespace rotatebook::bridge
