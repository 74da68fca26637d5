// The figure of a map: its picture, and from its result its expectations.
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "embedded/page.h"
#include "image/png_file.h"
#include "page/expectation_table.h"
#include "page/figure.h"
#include "page/result_json.h"
#include "store/fingerprint.h"
#include "store/map_files.h"
#include "video/clip_reader.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

/// Returns the film of the map if there is one. Throws InputError of another map's.
Html filmOf(const scene::Scene& scene, const store::MapFiles& files, const Language& say) {
  if (!scene.map->film || !fs::exists(files.film)) return {};
  if (video::readClipMetadata(files.film).comment != store::recordOfFilm(scene)) {
    throw InputError(
        fmt::format("{} isn't the film of the scene's map; make it again, or remove it: {}",
                    files.film.string(), remedy("map --film", scene, files.film.parent_path())));
  }
  const video::PictureSize size = video::readPictureSize(files.film);
  return filled(filmTemplate(),
                {{"width", {std::to_string(size.width)}},
                 {"height", {std::to_string(size.height)}},
                 {"poster", addressOf(files.png().filename().string())},
                 {"video", addressOf(files.film.filename().string())},
                 {"title", escaped(say(scene.title))}},
                say);
}

}  // namespace

Figure mapFigure(const scene::Scene& scene, const fs::path& folder, const FigureFiles& shown,
                 const Language& say) {
  const store::MapFiles files = store::mapFiles(folder, scene.name);
  for (const auto& file : files.plots) requireFile(file, scene, "map");
  for (const auto& file : {files.plain, files.npy, files.json}) requireFile(file, scene, "map");
  const std::vector<Check> checks =
      readChecks(files.json, scene, store::sceneChecksum(scene), "map", "make the map again", say);
  const image::Image pixels = image::readPng(files.png());
  const std::string picture = files.png().filename().string();
  Figure figure{FigureKind::Map, scene.name, say(scene.title), files.plain.filename().string()};
  figure.badge = unmetBadge(checks, say);
  figure.files = {picture, figure.thumbnail};
  const Html film = filmOf(scene, files, say);
  Html links;
  for (const fs::path& plot : files.plots) {
    if (plot != files.png() && shown.isPacked) continue;
    links += linkItem(plot.filename().string(), formatOf(plot));
  }
  if (!film.text.empty()) {
    figure.files.push_back(files.film.filename().string());
    figure.frameRate = scene.clip.frameRate;
    links += linkItem(files.film.filename().string(), say("film (MP4)"));
  }
  links += linkItem(files.plain.filename().string(), say("PNG without text"));
  if (!shown.isPacked) {
    links += linkItem(files.npy.filename().string(), say("values (NumPy)"));
    links += linkItem(files.json.filename().string(), say("axes (JSON)"));
  }
  figure.section =
      filled(mapTemplate(),
             {{"id", escaped(scene.name)},
              {"anchor", addressOf(scene.name)},
              {"title", escaped(figure.title)},
              {"badge", figure.badge},
              {"picture", addressOf(picture)},
              {"width", {std::to_string(pixels.width())}},
              {"height", {std::to_string(pixels.height())}},
              {"caption", captionOf(scene, say)},
              {"film", film},
              {"checks",
               foldedChecks(checks, checksTable(say("Expected and measured"), checks, say), say)},
              {"links", links},
              {"scene", sceneDetails(scene, say)}},
             say);
  return figure;
}

}  // namespace rotatebook::page
