// Reads a scene from TOML.
#include <string>
#include <string_view>
#include <utility>

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
#include "scene/resolve.h"
#include "scene/scene_text.h"
#include "scene/schedule.h"
#include "scene/sections.h"
#include "scene/source_locations.h"

namespace rotatebook::scene {
namespace {

void readSections(const ValueReader& file, Spec& spec) {
  auto fields = fieldsInto(spec, titleKeys());
  const auto motion = motionSections();
  addFields(fields, motion.first(motion.size() - 1), spec.motion);
  addFields(fields, pictureSections(), spec);
  addFields(fields, motion.last(1), spec.motion);  // [expect]
  // These depend on the other sections and are read after them.
  for (const char* key : {"panel", "grid", "study", "map"})
    fields.push_back({key, [](const ValueReader&) {}});
  file.readTable(fields);
}

/// Reads how fast time goes, which two keys may say.
void readSpeed(const ValueReader& file, Spec& spec) {
  const auto timePerFrame = file.find("simulation", "time_per_frame");
  if (timePerFrame && spec.clip.speed) {
    timePerFrame->fail(
        "both simulation.time_per_frame and clip.speed say how fast time goes; "
        "keep one of them");
  }
  if (!timePerFrame && !spec.clip.speed) spec.clip.speed.emplace();
}

/// Reads what the file states, and checks it section by section.
Spec readSpec(const ValueReader& file, Spec spec) {
  document::Problems problems;
  problems.note([&] { readSections(file, spec); });
  problems.note([&] {
    readSpeed(file, spec);
    if (const auto panels = file.find("panel")) spec.motions = readPanels(*panels, file);
    if (const auto grid = file.find("grid")) spec.grid = readGrid(*grid, file, spec.clip);
  });
  problems.throwIfAny();
  if (!spec.hasPanels()) problems.note([&] { checkMotion(file, spec.motion.simulation); });
  if (const auto study = file.find("study"))
    problems.note([&] { spec.study = readStudy(*study, file, spec); });
  if (const auto map = file.find("map"))
    problems.note([&] { spec.map = readMap(*map, spec.motions); });
  problems.throwIfAny();
  if (!file.find("title")) spec.title = oneLine(spec.name);
  spec.locations = document::locationsOf(file.node());
  if (const auto cues = file.find("cue"); cues && !spec.cues.empty()) {
    std::size_t cue = 0;
    for (const ValueReader& table : cues->tables(""))
      spec.locations.byKey.emplace(cueKey(cue++), table.find("at").value_or(table).node().location);
  }
  return spec;
}

/// Reads the motions that are stated by the sections of a scene without panels.
void readMotions(const ValueReader& file, Spec& spec) {
  spec.motion.locations = spec.locations;
  if (spec.grid) {
    spec.motions = readCells(file, spec);
  } else if (!spec.hasPanels()) {
    spec.motions = {{spec.motion, ""}};
  }
  if (spec.study) spec.runs = readRuns(file, spec);
}

}  // namespace

Scene parseScene(std::string_view text, const std::filesystem::path& path,
                 std::span<const std::string> overrides, const ReadNamedFile& readNamedFile) {
  requireSameLayout();
  document::TomlNode tree = document::parseToml(text, oneLine(path.string()));
  document::Problems problems;
  problems.note([&] { applyOverrides(tree, overrides, kMotionAlternatives); });

  // Read what is stated
  Spec spec;
  spec.name = path.stem().string();
  spec.folder = path.parent_path();
  problems.note(
      [&] { spec.wordsFile = includeTable(tree, "overlay", "words", spec.folder, readNamedFile); });
  MeshFiles meshes;
  problems.note([&] { meshes = includeMeshes(tree, readNamedFile); });
  const ValueReader file(tree, "");
  problems.note([&] { spec = readSpec(file, std::move(spec)); });
  for (document::Problem& problem : problems.all()) {
    const std::string sections = sectionsOf(problem.unknownKey);
    if (!sections.empty()) problem.remedy = "; it belongs " + sections;
  }
  problems.throwIfAny();

  readMotions(file, spec);

  // Find what follows
  Scene scene = resolve(std::move(spec), meshes);
  readNamedFile ? readMotionFiles(scene, readNamedFile) : schedule(scene);
  return scene;
}

}  // namespace rotatebook::scene
