#include "cli/scene_report.h"

#include "base/json.h"

namespace rotatebook::cli {
namespace {

JsonObject fileObject(const SceneFile& file) {
  JsonObject object;
  object.addString("path", file.path.string())
      .addBool("ok", file.errors.empty())
      .add("errors", jsonArrayOf(file.errors, jsonString));
  return object;
}

std::string panelLabels(const scene::Scene& scene) {
  if (!scene.hasPanels()) return "[]";
  return jsonArrayOf(scene.motions,
                     [](const scene::Panel& panel) { return jsonString(panel.label); });
}

std::string checkJson(const SceneFile& file) {
  JsonObject object = fileObject(file);
  object.add("notes", jsonArrayOf(file.notes, jsonString));
  if (!file.scene) return object.text();
  if (file.frames) object.addInteger("frames", *file.frames);
  return object.add("panels", panelLabels(*file.scene)).text();
}

std::string listJson(const SceneFile& file) {
  JsonObject object = fileObject(file);
  if (!file.scene) return object.text();
  const scene::Scene& scene = *file.scene;
  return object.addString("name", scene.name)
      .addString("title", scene.title)
      .addNumber("duration_s", scene.clip.duration)
      .addInteger("width", scene.clip.width)
      .addInteger("height", scene.clip.height)
      .addInteger("frames", scene.clip.frameCount())
      .add("panels", panelLabels(scene))
      .addBool("has_study", scene.study.has_value())
      .text();
}

void printFiles(const std::vector<SceneFile>& files, std::string (*asJson)(const SceneFile&),
                std::ostream& out) {
  out << JsonObject().add("scenes", jsonArrayOf(files, asJson)).text() << '\n';
}

}  // namespace

void reportChecksAsJson(const std::vector<SceneFile>& files, std::ostream& out) {
  printFiles(files, checkJson, out);
}

void reportListAsJson(const std::vector<SceneFile>& files, std::ostream& out) {
  printFiles(files, listJson, out);
}

}  // namespace rotatebook::cli
