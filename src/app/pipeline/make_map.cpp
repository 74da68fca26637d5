#include "pipeline/make_map.h"

#include <array>
#include <atomic>
#include <functional>
#include <mutex>

#include "base/checksum.h"
#include "base/error.h"
#include "base/text.h"
#include "image/png_file.h"
#include "pipeline/kept_tiles.h"
#include "plot/map_colours.h"
#include "plot/map_plot.h"
#include "plot/plot_files.h"
#include "store/fingerprint.h"
#include "store/map_tiles.h"
#include "store/study_files.h"
#include "study/map_files.h"
#include "system/atomic_file.h"
#include "system/parallel_runs.h"
#include "system/program_mark.h"
#include "system/read_file.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using study::MapResult;
using study::MapTile;

bool readValues(const store::MapFiles& files, const std::string& fingerprint,
                const scene::MapSettings& map, MapResult& result) {
  const study::MapChecksums made = study::checksumsIn(system::readFileOrEmpty(files.json));
  if (made.fingerprint != fingerprint) return false;
  const std::string array = system::readFileOrEmpty(files.npy, study::kLongestNpy);
  return checksumOf(array) == made.npy && readNpy(array, map, result);
}

/// Puts those of the `wanted` tiles that are on the disk into the result; returns the numbers of
/// the others.
std::vector<std::size_t> missingTiles(const std::vector<MapTile>& tiles, store::FrameRange wanted,
                                      const store::MapTiles& kept, const scene::MapSettings& map,
                                      MapResult& result) {
  std::vector<std::size_t> missing;
  for (auto i = static_cast<std::size_t>(wanted.first); i < static_cast<std::size_t>(wanted.end);
       ++i) {
    const auto count =
        static_cast<std::size_t>(tiles[i].width) * static_cast<std::size_t>(tiles[i].height);
    const auto bytes = kept.read(i, count * sizeof(double));
    if (bytes) {
      putTile(tiles[i], study::doublesOf(*bytes), map, result);
    } else {
      missing.push_back(i);
    }
  }
  return missing;
}

std::string tilesText(std::size_t count) {
  return countText(static_cast<std::int64_t>(count), "tile");
}

/// Returns the files that are removed before others are written. Values of the same settings stay,
/// so that pictures can be made of them whatever stops the writing.
std::vector<fs::path> outdatedFiles(const scene::Scene& scene, const store::MapFiles& files) {
  if (store::mapFingerprintIn(files) != store::mapFingerprint(scene)) return allOf(files);
  std::vector<fs::path> all = files.plots;
  all.insert(all.end(), {files.plain, files.csv});
  return all;
}

/// Writes the arrays. Returns the text about them.
std::string writeValues(const scene::Scene& scene, const study::MapRuns& runs,
                        const MapResult& result, const store::MapFiles& files, bool isSmall) {
  const std::string array = npyOf(result, *scene.map);
  system::writeFileAtomically(files.npy, array);
  if (isSmall) system::writeFileAtomically(files.csv, mapCsv(result, scene));
  const study::MapChecksums sums{store::mapFingerprint(scene), store::sceneChecksum(scene),
                                 checksumOf(array)};
  return jsonLine(mapJson(result, scene, runs, sums));
}

}  // namespace

void requireMayReplaceMap(const scene::Scene& scene, const store::MapFiles& files,
                          const MapOptions& options) {
  if (options.overwrite) return;
  const std::string fingerprint = store::mapFingerprint(scene);
  const store::MapTiles kept(files.tiles, fingerprint);
  requireMayGoOn(kept, options, "map", tilesText);
  // The tiles are removed after the JSON is written: an array beside them alone is of a killed map
  if (!fs::exists(files.json) && kept.count().same > 0) return;
  const auto made = study::checksumsIn(system::readFileOrEmpty(files.json));
  if (!fs::exists(files.npy) || made.fingerprint == fingerprint) return;
  throw InputError(files.npy.string() +
                   " holds the values of other settings, or another build of this program; replace "
                   "them with --overwrite, or name another folder with -o");
}

MadeMap makeMap(const scene::Scene& scene, const study::MapRuns& runs, const store::MapFiles& files,
                const MapOptions& options) {
  requireMayReplaceMap(scene, files, options);
  const scene::MapSettings& map = *scene.map;
  const std::string fingerprint = store::mapFingerprint(scene);
  const std::vector<MapTile> tiles = runs.tiles();
  const store::FrameRange wanted = store::framesOf(options.part.value_or(store::ClipPart{}),
                                                   static_cast<std::int64_t>(tiles.size()));
  const auto count = static_cast<std::size_t>(wanted.count());
  MadeMap made{emptyResult(scene, runs), true, count, count, count};
  const bool goesOn = options.resume || options.part;
  if (goesOn && readValues(files, fingerprint, map, made.result)) return made;

  const store::MapTiles kept(files.tiles, fingerprint);
  makeRoom(kept, options);
  const std::vector<std::size_t> missing = missingTiles(tiles, wanted, kept, map, made.result);
  made.found = made.finished = count - missing.size();
  const std::atomic<bool>* stop = options.execution.stop;
  std::mutex mutex;
  made.isWhole = runParallel(
      missing,
      [&](std::size_t i) {
        const std::vector<double> values = runs.valuesOf(tiles[i], stop);
        if (stop != nullptr && *stop) return;
        kept.write(i, study::bytesOf(values));
        const std::lock_guard lock(mutex);
        putTile(tiles[i], values, map, made.result);
        ++made.finished;
      },
      options.execution);
  made.isWhole = made.finished == count;
  return made;
}

std::vector<std::string> writeMap(const scene::Scene& scene, const study::MapRuns& runs,
                                  const MapResult& result, const store::MapFiles& files,
                                  int threads) {
  std::vector<std::string> written;
  for (const fs::path& file : files.plots) written.push_back(file.string());
  written.insert(written.end(), {files.plain.string(), files.npy.string(), files.json.string()});
  const bool isSmall =
      static_cast<std::size_t>(scene.map->runs()) * result.values.size() <= study::kMaxMapRows;
  if (isSmall) written.push_back(files.csv.string());
  store::removeFiles(outdatedFiles(scene, files));
  std::string json;
  const std::array<std::function<void()>, 3> parts{
      [&] {
        for (const plot::PlotFile& plotted : plot::mapPlot(result, scene, files.plots))
          system::writeMarked(plotted.path, plotted.bytes);
      },
      [&] { json = writeValues(scene, runs, result, files, isSmall); },
      [&] { image::writePng(files.plain, plot::plainMap(result, *scene.map).view()); }};
  constexpr std::array<std::size_t, parts.size()> kAll{0, 1, 2};
  system::runParallel(kAll, [&](std::size_t i) { parts.at(i)(); }, {threads});
  system::writeFileAtomically(files.json, json);
  store::MapTiles(files.tiles, "").remove();
  return written;
}

}  // namespace rotatebook::pipeline
