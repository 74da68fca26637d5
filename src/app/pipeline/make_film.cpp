#include "pipeline/make_film.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "base/error.h"
#include "image/png_file.h"
#include "pipeline/frame_sink.h"
#include "pipeline/kept_tiles.h"
#include "plot/map_plot.h"
#include "store/clip_record.h"
#include "store/encoding.h"
#include "store/fingerprint.h"
#include "store/map_tiles.h"
#include "system/atomic_file.h"

namespace rotatebook::pipeline {
namespace {

std::size_t frameCountOf(const scene::Scene& scene) {
  return static_cast<std::size_t>(
      std::max<std::int64_t>(2, scene.clip.frameRate.framesIn(scene.map->film->duration)));
}

/// The scenes whose maps are the frames of a film.
class FilmFrames {
 public:
  explicit FilmFrames(const scene::Scene& scene) : scene_(scene), count_(frameCountOf(scene)) {
    for (std::size_t i = 0; i < count_; ++i) width_ = std::max(width_, plot::mapWidth(at(i)));
  }

  /// Draws a frame; nullopt after a stop. All have the same even size, and what is the same in them
  /// in the same place.
  std::optional<image::Image> draw(std::size_t index, const std::atomic<bool>* stop) const {
    const scene::Scene scene = at(index);
    const study::MapRuns runs(scene);
    study::MapResult result = emptyResult(scene, runs);
    for (const study::MapTile& tile : runs.tiles()) {
      putTile(tile, runs.valuesOf(tile, stop), *scene.map, result);
      if (stop != nullptr && *stop) return std::nullopt;
    }
    return plot::mapPicture(result, scene, width_);
  }

 private:
  scene::Scene at(std::size_t index) const {
    scene::Scene scene = scene_;
    scene.map =
        mapOfFilm(*scene_.map, static_cast<double>(index) / static_cast<double>(count_ - 1));
    return scene;
  }

  scene::Scene scene_;
  std::size_t count_;
  int width_ = 0;
};

image::Image decoded(const std::string& png) {
  return image::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()},
                          "a frame of the film");
}

/// Returns whether the film was written; after a stop it isn't.
bool encodeFilm(const scene::Scene& scene, const store::MapTiles& frames, std::size_t count,
                const std::filesystem::path& path, const std::atomic<bool>* stop) {
  std::optional<VideoSink> sink;
  for (std::size_t i = 0; i < count; ++i) {
    if (stop != nullptr && *stop) return false;
    const std::optional<std::string> png = frames.read(i);
    if (!png)
      throw MachineError("a frame of " + path.string() + " is lost; try again with --resume");
    const image::Image picture = decoded(*png);
    if (!sink) {
      video::VideoSettings settings =
          store::videoSettings(scene, store::recordOfFilm(scene), false);
      settings.width = picture.width();
      settings.height = picture.height();
      settings.transparent = false;
      sink.emplace(video::VideoFormat::Mp4, path, settings);
    }
    sink->write(static_cast<std::int64_t>(i), picture.view());
  }
  sink->finish();
  return true;
}

}  // namespace

void requireMayReplaceFilm(const scene::Scene& scene, const store::MapFiles& files,
                           const MapOptions& options) {
  if (!scene.map->film) {
    throw InputError(scene.name +
                     ": map.film, the part of the map to zoom into, is missing; e.g. "
                     "--set 'map.film={ x = [2, 3], duration = 10 }'");
  }
  if (options.overwrite) return;
  if (std::filesystem::exists(files.film) &&
      store::recordIn(files.film) != store::recordOfFilm(scene)) {
    throw InputError(files.film.string() +
                     " is a film of other settings; replace it with --overwrite, or name another "
                     "folder with -o");
  }
  requireMayGoOn(store::MapTiles(files.filmFrames, store::filmFingerprint(scene)), options, "film",
                 [](std::size_t) { return std::string("frames"); });
}

MadeFilm makeFilm(const scene::Scene& scene, const store::MapFiles& files,
                  const MapOptions& options) {
  requireMayReplaceFilm(scene, files, options);
  const std::size_t count = frameCountOf(scene);
  if (options.resume && store::recordIn(files.film) == store::recordOfFilm(scene))
    return {count, count, count, true, true};
  const FilmFrames film(scene);
  const store::MapTiles kept(files.filmFrames, store::filmFingerprint(scene));
  makeRoom(kept, options);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < count; ++i) {
    if (!kept.read(i)) missing.push_back(i);
  }
  const std::size_t found = count - missing.size();
  MadeFilm made{count, found, found};
  std::atomic<std::size_t> finished = 0;
  runParallel(
      missing,
      [&](std::size_t i) {
        const auto picture = film.draw(i, options.execution.stop);
        if (!picture) return;
        kept.write(i, image::PngWriter().encode(picture->view(), files.film.string()));
        ++finished;
      },
      options.execution);
  made.finished += finished;
  if (made.finished < made.frames) return made;
  made.isWhole = encodeFilm(scene, kept, made.frames, files.film, options.execution.stop);
  if (made.isWhole) kept.remove();
  return made;
}

}  // namespace rotatebook::pipeline
