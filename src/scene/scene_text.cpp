// A Scene as TOML, every key in a fixed order.
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/names.h"
#include "scene/nearest_name.h"
#include "scene/scene_file.h"
#include "scene/toml_text.h"

namespace rotatebook::scene {
namespace {

using physics::Expectation;

std::string line(std::string_view key, const std::string& value, const std::string& comment = "") {
  const std::string start = std::string(key) + " = " + value;
  return comment.empty() ? start + "\n" : start + "  # " + comment + "\n";
}

std::string array(const Eigen::Vector3d& vector) {
  return "[" + tomlNumber(vector.x()) + ", " + tomlNumber(vector.y()) + ", " +
         tomlNumber(vector.z()) + "]";
}

std::string array(int first, int second) {
  return "[" + std::to_string(first) + ", " + std::to_string(second) + "]";
}

template <typename T, std::size_t N>
std::string word(const std::array<Named<T>, N>& choices, const T& value) {
  return tomlString(nameOf(choices, value));
}

template <typename T, std::size_t N>
std::string choicesIn(const std::array<Named<T>, N>& choices) {
  return quotedList(namesOf(choices), "or");
}

std::string bodyText(const physics::Cuboid& body) {
  return "\n[body]\n" +
         line("size", array(body.size),
              "m, along x (from the spine), y (to the top), z (to the cover)") +
         line("mass", tomlNumber(body.mass), "kg");
}

std::string simulationText(const physics::SimulationSettings& settings) {
  return "\n[simulation]\n" + line("model", word(kModels, settings.model), choicesIn(kModels)) +
         line("integrator", word(kIntegrators, settings.integrator), choicesIn(kIntegrators)) +
         line("normalize", settings.normalize ? "true" : "false",
              "undo the integrator's drift after each step") +
         line("damping", tomlNumber(settings.damping), "particles: fraction of critical damping") +
         line("stiffness", tomlNumber(settings.stiffness), "particles: N/m, of each spring") +
         line("time_per_frame", tomlNumber(settings.timePerFrame),
              "s simulated for each frame of video") +
         line("substeps", std::to_string(settings.substeps), "integration steps for each frame");
}

std::string initialText(const physics::InitialSpin& spin) {
  const bool isVelocity = spin.kind == physics::InitialSpin::Kind::AngularVelocity;
  std::string text = "\n[initial]\n" + line(nameOf(kSpinKinds, spin.kind), array(spin.value),
                                            isVelocity ? "rad/s" : "kg m^2/s");
  if (!spin.tilt) return text;
  return text + line("tilt",
                     "[" + tomlNumber(spin.tilt->angle) + ", " + word(kAxes, spin.tilt->axis) + "]",
                     "rad, and the axis toward which the spin is turned");
}

std::string clipText(const ClipSettings& clip) {
  const std::string rate = clip.frameRate.text();
  return "\n[clip]\n" +
         line("size", array(clip.width, clip.height), "pixels, width and height, even") +
         line("fps", clip.frameRate.denominator == 1 ? rate : tomlString(rate), "frames a second") +
         line("duration", tomlNumber(clip.duration), "s of video");
}

std::string videoText(const EncodingSettings& video) {
  return "\n[video]\n" +
         line("crf", std::to_string(video.crf), "0 to 51, smaller is better and larger to store") +
         line("preset", tomlString(video.preset), "x264's, \"ultrafast\" to \"placebo\"") +
         line("threads", std::to_string(video.threads),
              "of the encoder; another number gives other bytes");
}

std::string cameraText(const CameraSettings& camera) {
  return "\n[camera]\n" + line("position", array(camera.position), "m") +
         line("target", array(camera.target), "m, the point in the middle of the picture") +
         line("up", array(camera.up)) +
         line("field_of_view_deg", tomlNumber(camera.fieldOfViewDeg),
              "degrees, from bottom to top");
}

std::string bookText(const BookSettings& book) {
  return "\n[book]\n" +
         line("front", tomlString(book.front),
              "\"builtin\" or a picture's path from the scene's folder") +
         line("spine", tomlString(book.spine)) + line("back", tomlString(book.back));
}

std::string boundsText(const Expectation& expectation) {
  std::string text;
  const auto add = [&text](std::string_view key, double value) {
    text += (text.empty() ? "" : ", ") + std::string(key) + " = " + tomlNumber(value);
  };
  if (expectation.min) add("min", *expectation.min);
  if (expectation.max) add("max", *expectation.max);
  if (expectation.risesTo) add("rises_to", *expectation.risesTo);
  if (expectation.fallsTo) add("falls_to", *expectation.fallsTo);
  add("from", expectation.from);
  if (expectation.to < std::numeric_limits<double>::infinity()) add("to", expectation.to);
  return "{ " + text + " }";
}

std::string expectationsText(const std::vector<Expectation>& expectations) {
  if (expectations.empty()) return {};
  std::vector<std::pair<physics::Quantity, std::string>> groups;
  for (const Expectation& expectation : expectations) {
    auto group =
        std::ranges::find(groups, expectation.quantity, &decltype(groups)::value_type::first);
    if (group == groups.end()) group = groups.insert(group, {expectation.quantity, ""});
    group->second += (group->second.empty() ? "" : ", ") + boundsText(expectation);
  }
  std::string text = "\n[expect]\n";
  for (const auto& [quantity, bounds] : groups) {
    text += line(physics::nameOf(quantity), "[" + bounds + "]");
  }
  return text;
}

}  // namespace

std::string sceneText(const Scene& scene) {
  return line("title", tomlString(scene.title)) + line("caption", tomlString(scene.caption)) +
         bodyText(scene.body) + simulationText(scene.simulation) + initialText(scene.initial) +
         clipText(scene.clip) + videoText(scene.video) + cameraText(scene.camera) +
         bookText(scene.book) + expectationsText(scene.expectations);
}

}  // namespace rotatebook::scene
