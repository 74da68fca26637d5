// From TOML to a Scene: the whole file, and the defaults that depend on several sections.
#include <string>

#include "scene/overrides.h"
#include "scene/scene_file.h"
#include "scene/sections.h"
#include "scene/study_section.h"
#include "scene/toml_tree.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {
namespace {

void readSections(const ValueReader& file, Scene& scene) {
  file.readTable({
      {"title", [&](const ValueReader& value) { scene.title = value.text(); }},
      {"caption", [&](const ValueReader& value) { scene.caption = value.text(); }},
      {"body", [&](const ValueReader& value) { readBody(value, scene.body, scene.inertia); }},
      {"simulation", [&](const ValueReader& value) { readSimulation(value, scene.simulation); }},
      {"initial", [&](const ValueReader& value) { readInitial(value, scene.initial); }},
      {"clip", [&](const ValueReader& value) { readClip(value, scene.clip); }},
      {"video", [&](const ValueReader& value) { readVideo(value, scene.video); }},
      {"camera", [&](const ValueReader& value) { readCamera(value, scene.camera); }},
      {"book", [&](const ValueReader& value) { readBook(value, scene.book); }},
      {"overlay", [&](const ValueReader& value) { readOverlay(value, scene.overlay); }},
      {"expect", [&](const ValueReader& value) { readExpectations(value, scene.expectations); }},
      {"study", [](const ValueReader&) {}},  // Depends on all others; read when they are.
  });
  if (!file.find("initial")) {
    file.fail("[initial] is missing; it needs angular_velocity or angular_momentum");
  }
}

bool has(const ValueReader& file, std::string_view section, std::string_view key) {
  const auto found = file.find(section);
  return found && found->find(key);
}

void fillDefaults(const ValueReader& file, Scene& scene) {
  if (!file.find("title")) scene.title = scene.name;
  if (!has(file, "simulation", "time_per_frame")) {
    scene.simulation.timePerFrame = scene.clip.frameRate.period();
  }
  if (!has(file, "camera", "position")) {
    scene.camera.position = defaultCameraPosition(scene.body, scene.camera.fieldOfViewDeg,
                                                  scene.clip.width, scene.clip.height);
  }
}

void checkTogether(const ValueReader& file, const Scene& scene) {
  if (const auto body = file.find("body")) checkInertia(*body, scene.simulation.model);
  if (const auto simulation = file.find("simulation")) {
    checkIntegrator(*simulation, scene.simulation);
  }
  if (const auto camera = file.find("camera")) checkCamera(*camera, scene.camera);
}

}  // namespace

Scene parseScene(std::string_view text, const std::filesystem::path& path,
                 std::span<const std::string> overrides) {
  TomlNode tree = parseToml(text, path.string());
  applyOverrides(tree, overrides);

  Scene scene;
  scene.name = path.stem().string();
  scene.folder = path.parent_path();
  const ValueReader file(tree, "");
  readSections(file, scene);
  fillDefaults(file, scene);
  checkTogether(file, scene);
  if (const auto study = file.find("study")) scene.study = readStudy(*study, scene);
  return scene;
}

}  // namespace rotatebook::scene
