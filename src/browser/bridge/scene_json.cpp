#include "bridge/scene_json.h"

#include <array>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/number_text.h"
#include "base/version.h"
#include "physics/motion_start.h"
#include "scene/names.h"
#include "timeline/notes.h"

namespace rotatebook::bridge {
namespace {

std::string modelJson(const scene::Named<physics::Model>& model) {
  return JsonObject()
      .addString("name", model.name)
      .add("integrators", jsonArrayOf(scene::integratorNames(model.value), jsonString))
      .addBool("normalize", physics::takesSteps(model.value))
      .addBool("damping", model.value == physics::Model::Particles)
      .text();
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
      .addString("integrator", scene::nameOf(scene::kIntegrators, simulation.integrator))
      .addInteger("substeps", simulation.substeps)
      .addInteger("normalize_every", simulation.normalizeEvery)
      .addNumber("damping", simulation.damping)
      .addNumber("stiffness", simulation.stiffness)
      .add("body", vectorJson(panel.body.size))
      .addNumber("mass", panel.body.mass)
      .add("moments", vectorJson(physics::modelInertia(panel.motion()).moments))
      .add("angular_velocity", vectorJson(physics::initialAngularVelocity(panel.motion())));
  // A page draws springs between the corners of the cage.
  const bool areCorners = simulation.particles.arrangement == physics::Arrangement::Corners;
  if (simulation.model == physics::Model::Particles && areCorners)
    object.add("springs", springsJson(panel.body));
  return object.text();
}

std::string cameraJson(const scene::CameraSettings& camera) {
  return JsonObject()
      .add("position", vectorJson(camera.position))
      .add("target", vectorJson(camera.target))
      .add("up", vectorJson(camera.up))
      .addNumber("field_of_view", camera.fieldOfViewDeg)
      .addString("frame", scene::nameOf(scene::kFrames, camera.frame))
      .text();
}

}  // namespace

std::string wordsJson() {
  // No recording is read in a page.
  std::vector<scene::Named<physics::Model>> models(scene::kModels.begin(), scene::kModels.end());
  std::erase_if(models, [](const auto& one) { return one.value == physics::Model::Recorded; });
  return JsonObject()
      .addString("version", kVersion)
      .add("models", jsonArrayOf(models, modelJson))
      .text();
}

std::string sceneJson(const scene::Scene& scene) {
  const std::vector<scene::Panel> motions = scene::motionsOf(scene);
  const FrameRate rate = scene.clip.frameRate;
  return JsonObject()
      .addString("title", scene.title)
      .addString("caption", scene.caption)
      .addInteger("frames", scene.clip.frameCount())
      .add("rate", jsonArray({std::to_string(rate.numerator), std::to_string(rate.denominator)}))
      .addNumber("interval", motions.front().simulation.timePerFrame)
      .add("size", jsonArray({std::to_string(scene.clip.width), std::to_string(scene.clip.height)}))
      .add("motions", jsonArrayOf(motions, motionJson))
      .add("camera", cameraJson(scene.camera))
      .add("notes", jsonArrayOf(timeline::notesOn(scene), jsonString))
      .text();
}

}  // namespace rotatebook::bridge
