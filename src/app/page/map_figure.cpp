// The figure of a map: its picture, and from its array its expectations.
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "embedded/page.h"
#include "image/png_file.h"
#include "page/expectation_table.h"
#include "page/figure.h"
#include "store/fingerprint.h"
#include "store/map_files.h"
#include "study/map_files.h"
#include "study/map_result.h"
#include "system/read_file.h"
#include "video/clip_reader.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

/// Returns the values in the files. Throws InputError if they are another map's.
study::MapResult readResult(const scene::Scene& scene, const store::MapFiles& files,
                            const study::MapRuns& runs) {
  study::MapResult result = emptyResult(scene, runs);
  const std::string json = system::readFileOrEmpty(files.json);
  const bool isSame = study::checksumsIn(json).scene == store::mapSceneChecksum(scene);
  const std::string array = system::readFileOrEmpty(files.npy, study::kLongestNpy);
  if (isSame && readNpy(array, *scene.map, result)) return result;
  throw InputError(files.npy.string() +
                   " doesn't hold the values of the scene's map; make the map again (or give this "
                   "command the same --set): " +
                   remedy("map", scene, files.npy.parent_path()));
}

std::vector<Check> checksOf(const scene::Scene& scene, const study::MapResult& result,
                            const study::MapRuns& runs) {
  std::vector<Check> checks;
  for (const study::ExpectedOfMap& one : expectedOf(result, *scene.map, runs)) {
    checks.push_back(checkOf(one.subject(), one.expectation.bounds, one.measured,
                             std::string(rowOf(scene.map->measure).meaning)));
  }
  return checks;
}

/// Returns the film of the map if there is one. Throws InputError of another map's.
Html filmOf(const scene::Scene& scene, const store::MapFiles& files) {
  if (!scene.map->film || !fs::exists(files.film)) return {};
  if (video::readClipMetadata(files.film).comment != store::recordOfFilm(scene)) {
    throw InputError(files.film.string() +
                     " isn't the film of the scene's map; make it again, or remove it: " +
                     remedy("map --film", scene, files.film.parent_path()));
  }
  const video::PictureSize size = video::readPictureSize(files.film);
  return filled(filmTemplate(), {{"width", {std::to_string(size.width)}},
                                 {"height", {std::to_string(size.height)}},
                                 {"poster", addressOf(files.png().filename().string())},
                                 {"video", addressOf(files.film.filename().string())},
                                 {"title", escaped(scene.title)}});
}

}  // namespace

Figure mapFigure(const scene::Scene& scene, const fs::path& folder, const FigureFiles& shown) {
  const store::MapFiles files = store::mapFiles(folder, scene.name);
  for (const auto& file : files.plots) requireFile(file, scene, "map");
  for (const auto& file : {files.plain, files.npy, files.json}) requireFile(file, scene, "map");
  const study::MapRuns runs(scene);
  const std::vector<Check> checks = checksOf(scene, readResult(scene, files, runs), runs);
  const image::Image pixels = image::readPng(files.png());
  const std::string picture = files.png().filename().string();
  Figure figure{FigureKind::Map, scene.name, scene.title, files.plain.filename().string()};
  figure.badge = unmetBadge(checks);
  figure.files = {picture, figure.thumbnail};
  const Html film = filmOf(scene, files);
  Html links;
  for (const fs::path& plot : files.plots) {
    if (plot != files.png() && shown.isPacked) continue;
    links += linkItem(plot.filename().string(), formatOf(plot));
  }
  if (!film.text.empty()) {
    figure.files.push_back(files.film.filename().string());
    figure.frameRate = scene.clip.frameRate;
    links += linkItem(files.film.filename().string(), "film (MP4)");
  }
  links += linkItem(files.plain.filename().string(), "PNG without text");
  if (!shown.isPacked) {
    links += linkItem(files.npy.filename().string(), "values (NumPy)");
    links += linkItem(files.json.filename().string(), "axes (JSON)");
  }
  figure.section =
      filled(mapTemplate(),
             {{"id", escaped(scene.name)},
              {"anchor", addressOf(scene.name)},
              {"title", escaped(scene.title)},
              {"badge", figure.badge},
              {"picture", addressOf(picture)},
              {"width", {std::to_string(pixels.width())}},
              {"height", {std::to_string(pixels.height())}},
              {"caption", escaped(scene.caption)},
              {"film", film},
              {"checks", foldedChecks(checks, checksTable("Expected and measured", checks))},
              {"links", links},
              {"scene", sceneDetails(scene)}});
  return figure;
}

}  // namespace rotatebook::page
