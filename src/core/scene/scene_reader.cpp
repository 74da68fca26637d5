// Reads a Scene from TOML: the whole file, and the defaults that depend on several sections.
#include <algorithm>
#include <string>

#include "base/document/included_table.h"
#include "base/document/overrides.h"
#include "base/document/problems.h"
#include "base/document/toml_tree.h"
#include "base/document/value_reader.h"
#include "base/text.h"
#include "scene/body_section.h"
#include "scene/key_rows.h"
#include "scene/keys/keys.h"
#include "scene/motion_files.h"
#include "scene/names.h"
#include "scene/placed_particles.h"
#include "scene/scene_text.h"
#include "scene/sections.h"
#include "scene/source_locations.h"
#include "scene/spin_axis.h"

namespace rotatebook::scene {
namespace {

void readSections(const ValueReader& file, Scene& scene) {
  auto fields = fieldsInto(scene, titleKeys());
  const auto motion = motionSections();
  addFields(fields, motion.first(motion.size() - 1), scene);
  addFields(fields, pictureSections(), scene);
  addFields(fields, motion.last(1), scene);  // [expect]
  // These depend on the other sections and are read after them.
  for (const char* key : {"panel", "grid", "study", "map"})
    fields.push_back({key, [](const ValueReader&) {}});
  file.readTable(fields);
}

/// Returns the default camera position, from which the largest of the bodies is seen whole.
Eigen::Vector3d cameraPosition(const Scene& scene) {
  const double angle = scene.camera.fieldOfViewDeg;
  if (scene.panels.empty()) {
    return defaultCameraPosition(scene.body, angle, scene.clip.width, scene.clip.height);
  }
  const auto diagonal = [](const Panel& panel) { return panel.body.size.norm(); };
  const Panel& largest = *std::ranges::max_element(scene.panels, {}, diagonal);
  // The angle is over a panel's shorter side, so the panel's shape doesn't matter.
  return defaultCameraPosition(largest.body, angle, 1, 1);
}

void readMotions(const ValueReader& file, const MeshFiles& meshes, Scene& scene) {
  const auto timePerFrame = file.find("simulation", "time_per_frame");
  if (timePerFrame && scene.clip.speed) {
    timePerFrame->fail(
        "both simulation.time_per_frame and clip.speed say how fast time goes; "
        "keep one of them");
  }
  if (!timePerFrame) {
    if (!scene.clip.speed) scene.clip.speed.emplace();
    scene.simulation.timePerFrame = scene.clip.frameRate.period() * scene.clip.speed->constant;
    scene.simulation.substepped = kSubstepped;
  }
  if (const auto panels = file.find("panel")) {
    scene.panels = readPanels(*panels, file, scene.simulation, meshes);
  }
  if (const auto grid = file.find("grid")) readGrid(*grid, file, scene);
}

void placeCamera(const ValueReader& file, Scene& scene) {
  if (!file.find("camera", "position")) scene.camera.position = cameraPosition(scene);
  if (const auto camera = file.find("camera")) checkCamera(*camera, scene.camera);
}

/// Notes the locations of those kLocatedKeys that the file states, and of the panels' labels.
void noteLocations(const ValueReader& file, Scene& scene) {
  for (const std::string_view key : kLocatedKeys) {
    const auto dot = key.find('.');
    auto value = file.find(key.substr(0, dot));
    if (value && dot != key.npos) value = value->find(key.substr(dot + 1));
    if (value) scene.locations.emplace(key, value->node().location);
  }
  const auto panels = file.find("panel");
  if (!panels) return;
  std::size_t panel = 0;
  for (const ValueReader& table : panels->tables("")) {
    if (const auto own = table.find("simulation", "file")) {
      scene.locations.emplace(recordingKey(panel), own->node().location);
    }
    scene.locations.emplace(labelKey(panel++), table.find("label")->node().location);
  }
}

}  // namespace

Scene parseScene(std::string_view text, const std::filesystem::path& path,
                 std::span<const std::string> overrides, const ReadNamedFile& readNamedFile) {
  requireSameLayout();
  document::TomlNode tree = document::parseToml(text, oneLine(path.string()));
  document::Problems problems;
  problems.note([&] { applyOverrides(tree, overrides, kMotionAlternatives); });

  // Read all keys
  Scene scene;
  scene.name = path.stem().string();
  scene.folder = path.parent_path();
  problems.note([&] {
    scene.wordsFile = includeTable(tree, "overlay", "words", scene.folder, readNamedFile);
  });
  MeshFiles meshes;
  problems.note([&] { meshes = includeMeshes(tree, readNamedFile); });
  const ValueReader file(tree, "");
  problems.note([&] { readSections(file, scene); });
  takeContent(meshes, scene.solid.mesh);
  problems.note([&] { readMotions(file, meshes, scene); });
  for (document::Problem& problem : problems.all()) {
    const std::string sections = sectionsOf(problem.unknownKey);
    if (!sections.empty()) problem.remedy = "; it belongs " + sections;
  }
  problems.throwIfAny();
  if (!file.find("title")) scene.title = oneLine(scene.name);
  noteLocations(file, scene);

  // Check across sections, and read what depends on several of them
  if (scene.panels.empty()) {
    problems.note([&] {
      checkMotion(file, scene.simulation);
      placeParticles(file, scene);
    });
    // The axis of a spin follows from the particles
    if (problems.all().empty()) problems.note([&] { settleSpin(file, scene); });
  }
  problems.note([&] { placeCamera(file, scene); });
  if (const auto overlay = file.find("overlay")) {
    problems.note([&] { checkOverlays(*overlay, scene); });
  }
  if (const auto study = file.find("study")) problems.note([&] { readStudy(*study, file, scene); });
  if (const auto map = file.find("map")) problems.note([&] { readMap(*map, scene); });
  problems.throwIfAny();
  checkSteps(file, scene);
  if (readNamedFile) readMotionFiles(scene, readNamedFile);
  return scene;
}

}  // namespace rotatebook::scene
