// A Scene as TOML, every key in a fixed order.
#include "scene/scene_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "scene/names.h"
#include "scene/nearest_name.h"
#include "scene/study_section.h"
#include "scene/toml_text.h"

namespace rotatebook::scene {
namespace {

std::string line(std::string_view key, const std::string& value, const std::string& comment = "") {
  const std::string start = std::string(key) + " = " + value;
  return comment.empty() ? start + "\n" : start + "  # " + comment + "\n";
}

std::string array(const Eigen::Vector3d& vector) {
  return "[" + joined({tomlNumber(vector.x()), tomlNumber(vector.y()), tomlNumber(vector.z())}) +
         "]";
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

std::string inertiaText(const std::optional<Eigen::Matrix3d>& inertia) {
  if (!inertia) return "";
  const Eigen::Matrix3d& tensor = *inertia;
  const std::string comment = "kg m^2, in place of the solid cuboid's";
  if (tensor.isDiagonal(0)) return line("inertia", array(tensor.diagonal()), comment);
  return line(
      "inertia",
      "[" + joined({array(tensor.row(0)), array(tensor.row(1)), array(tensor.row(2))}) + "]",
      comment);
}

// `parent` is empty, or what comes before a section's name in its head: "panel.".
std::string head(const std::string& parent, const std::string& section) {
  return "\n[" + parent + section + "]\n";
}

std::string bodyText(const std::string& parent, const physics::Cuboid& body,
                     const std::optional<Eigen::Matrix3d>& inertia) {
  return head(parent, "body") +
         line("size", array(body.size),
              "m, along x (from the spine), y (to the top), z (to the cover)") +
         line("mass", tomlNumber(body.mass), "kg") + inertiaText(inertia);
}

std::string integratorText(const physics::SimulationSettings& settings) {
  const auto names = integratorNames(settings.model);
  if (names.empty()) return "";
  return line("integrator", word(kIntegrators, settings.integrator), quotedList(names, "or"));
}

std::string timePerFrameText(const physics::SimulationSettings& settings) {
  return line("time_per_frame", tomlNumber(settings.timePerFrame),
              "s simulated for each frame of video");
}

// All but time_per_frame, which the panels of a scene share.
std::string simulationText(const std::string& parent, const physics::SimulationSettings& settings) {
  return head(parent, "simulation") +
         line("model", word(kModels, settings.model), choicesIn(kModels)) +
         integratorText(settings) +
         line("normalize", settings.normalize ? "true" : "false",
              "undo the integrator's drift after each step") +
         line("damping", tomlNumber(settings.damping), "particles: fraction of critical damping") +
         line("stiffness", tomlNumber(settings.stiffness), "particles: N/m, of each spring") +
         line("substeps", std::to_string(settings.substeps), "integration steps for each frame");
}

std::string initialText(const std::string& parent, const physics::InitialSpin& spin) {
  const bool isVelocity = spin.kind == physics::InitialSpin::Kind::AngularVelocity;
  std::string text =
      head(parent, "initial") +
      line(nameOf(kSpinKinds, spin.kind), array(spin.value), isVelocity ? "rad/s" : "kg m^2/s");
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
         line("duration", tomlNumber(clip.duration), "s of video") +
         (clip.poster
              ? line("poster", tomlNumber(*clip.poster), "s, of the still that stands for it")
              : "");
}

std::string videoText(const EncodingSettings& video) {
  return "\n[video]\n" +
         line("crf", std::to_string(video.crf), "1 to 51, smaller is better and takes more space") +
         line("preset", tomlString(video.preset),
              "\"book\" or x264's \"ultrafast\" to \"placebo\"") +
         line("threads", std::to_string(video.threads),
              "of the encoder; another number gives other bytes");
}

std::string cameraText(const CameraSettings& camera) {
  return "\n[camera]\n" + line("position", array(camera.position), "m") +
         line("target", array(camera.target), "m, the point in the middle of the picture") +
         line("up", array(camera.up)) +
         line("field_of_view_deg", tomlNumber(camera.fieldOfViewDeg),
              "degrees, from bottom to top") +
         line("frame", word(kFrames, camera.frame), choicesIn(kFrames));
}

std::string bookText(const BookSettings& book) {
  return "\n[book]\n" +
         line("front", tomlString(book.front),
              "\"builtin\" or a picture's path from the scene's folder") +
         line("spine", tomlString(book.spine)) + line("back", tomlString(book.back));
}

std::string lookText(const LookSettings& look) {
  return "\n[look]\n" +
         line("background", word(kBackgrounds, look.background), choicesIn(kBackgrounds)) +
         line("supersample", std::to_string(look.supersample),
              "1, or 2 to draw with twice as many pixels across and down") +
         line("motion_blur", std::to_string(look.motionBlur),
              "moments averaged in a picture: 1, 2, 4, 8 or 16");
}

std::string overlayText(const OverlaySettings& overlay) {
  std::vector<std::string> names;
  for (const Overlay one : overlay.show) names.push_back(word(kOverlays, one));
  return "\n[overlay]\n" +
         line("show", "[" + joined(names) + "]", "of " + quotedList(namesOf(kOverlays), "and")) +
         line("font", tomlString(overlay.font), "\"builtin\" or an installed family");
}

std::string boundsText(const Expectation& expectation) {
  std::vector<std::string> parts;
  const auto add = [&parts](const std::string& key, std::optional<double> value) {
    if (value) parts.push_back(key + " = " + tomlNumber(*value));
  };
  add("min", expectation.min);
  add("max", expectation.max);
  add("rises_to", expectation.risesTo);
  add("falls_to", expectation.fallsTo);
  add("from", expectation.from);
  // A window without an end has no key for it.
  if (std::isfinite(expectation.to)) add("to", expectation.to);
  return "{ " + joined(parts) + " }";
}

// All bounds on a quantity stand behind one key, where the first of them is.
std::string expectationsText(const std::string& parent,
                             const std::vector<Expectation>& expectations) {
  std::vector<std::pair<Quantity, std::vector<std::string>>> groups;
  for (const Expectation& expectation : expectations) {
    const auto sameQuantity = [&](const auto& group) {
      return group.first == expectation.quantity;
    };
    auto group = std::find_if(groups.begin(), groups.end(), sameQuantity);
    if (group == groups.end()) group = groups.insert(group, {expectation.quantity, {}});
    group->second.push_back(boundsText(expectation));
  }

  std::string text = groups.empty() ? "" : head(parent, "expect");
  for (const auto& [quantity, bounds] : groups) {
    const std::string all = joined(bounds);
    text += line(nameOf(quantity), bounds.size() == 1 ? all : "[" + all + "]");
  }
  return text;
}

std::string panelText(const Panel& panel) {
  const std::string parent = "panel.";
  return "\n[[panel]]\n" + line("label", tomlString(panel.label)) +
         bodyText(parent, panel.body, panel.inertia) + simulationText(parent, panel.simulation) +
         initialText(parent, panel.initial) + expectationsText(parent, panel.expectations);
}

// What moves, as far as it isn't in panels.
std::string motionText(const Scene& scene) {
  if (!scene.panels.empty()) return head("", "simulation") + timePerFrameText(scene.simulation);
  return bodyText("", scene.body, scene.inertia) + simulationText("", scene.simulation) +
         timePerFrameText(scene.simulation) + initialText("", scene.initial);
}

std::string panelsText(const Scene& scene) {
  if (scene.panels.empty()) return expectationsText("", scene.expectations);
  std::string text;
  for (const Panel& panel : scene.panels) text += panelText(panel);
  return text;
}

}  // namespace

std::string sceneText(const Scene& scene) {
  return line("title", tomlString(scene.title)) + line("caption", tomlString(scene.caption)) +
         motionText(scene) + clipText(scene.clip) + videoText(scene.video) +
         cameraText(scene.camera) + bookText(scene.book) + lookText(scene.look) +
         overlayText(scene.overlay) + panelsText(scene) +
         (scene.study ? studyText(*scene.study) : "");
}

}  // namespace rotatebook::scene
