// Maps made tile by tile: the same bytes however they are made.
#include "pipeline/make_map.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <future>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "messages.h"
#include "pipeline/small_clip.h"
#include "plot/map_colours.h"
#include "scene/scene_text.h"
#include "store/map_tiles.h"
#include "study/map_files.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::messageOf;

/// A map of 100 x 40 runs in 8 tiles.
scene::Scene mapScene(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "[simulation]\nintegrator = 'euler'\n"
      "[initial]\nangular_velocity = [8, 0, 0]\ntilt = [0.01, 'z']\n[map]\n"
      "x = { key = 'simulation.substeps', from = 1, to = 9 }\n"
      "y = { key = 'initial.tilt.0', from = 1e-4, to = 1, scale = 'log' }\n"
      "measure = 'half_turns'\nduration = 1\nsize = [100, 40]\n",
      "small.toml", overrides);
}

class MakeMap : public ::testing::Test {
 protected:
  MakeMap() : folder_(emptyFolder()) {}

  store::MapFiles files(const std::string& name = "small") const {
    return store::mapFiles(folder_, name);
  }

  MadeMap make(const scene::Scene& scene, const MapOptions& options = {}) const {
    return makeMap(scene, study::MapRuns(scene), files(), options);
  }

  /// Makes and writes a map; returns the bytes of its files by name.
  std::map<std::string, std::string> bytesAfter(const scene::Scene& scene,
                                                const MapOptions& options) const {
    const MadeMap made = make(scene, options);
    EXPECT_TRUE(made.isWhole);
    writeMap(scene, study::MapRuns(scene), made.result, files(), options.execution.threads);
    std::map<std::string, std::string> bytes;
    for (const auto& file : store::allOf(files())) {
      bytes[file.filename()] = bytesOf(file);
      fs::remove(file);
    }
    EXPECT_FALSE(fs::exists(files().tiles));
    return bytes;
  }

  static MapOptions resuming() {
    MapOptions options;
    options.resume = true;
    return options;
  }

  fs::path folder_;
};

TEST_F(MakeMap, GivesTheSameBytesOnAnyNumberOfThreads) {
  std::map<std::string, std::string> first;
  for (const int threads : {1, 2, 5}) {
    MapOptions options;
    options.execution.threads = threads;
    const auto bytes = bytesAfter(mapScene(), options);
    if (first.empty()) first = bytes;
    EXPECT_EQ(bytes, first) << threads;
  }
  EXPECT_EQ(first.size(), 7U);
}

TEST_F(MakeMap, GivesTheSameBytesFromPartsMadeAtOnce) {
  const auto whole = bytesAfter(mapScene(), {});
  const auto makePart = [this](std::int64_t number) {
    MapOptions options;
    options.part = store::ClipPart{number, 3};
    return make(mapScene(), options);
  };
  std::vector<std::future<MadeMap>> parts;
  for (const std::int64_t number : {1, 2, 3, 2})  // one of them twice
    parts.push_back(std::async(std::launch::async, makePart, number));
  std::vector<std::size_t> tiles;
  for (auto& part : parts) tiles.push_back(part.get().tiles);
  EXPECT_THAT(tiles, ElementsAre(2, 3, 3, 3));
  const MadeMap joined = make(mapScene(), resuming());
  EXPECT_EQ(joined.found, 8U) << "all tiles were there";
  EXPECT_EQ(bytesAfter(mapScene(), resuming()), whole);
}

TEST_F(MakeMap, MakesNoPartOfAMapThatIsThere) {
  writeMap(mapScene(), study::MapRuns(mapScene()), make(mapScene()).result, files());
  MapOptions options;
  options.part = store::ClipPart{1, 3};
  EXPECT_EQ(make(mapScene(), options).found, 2U);
  EXPECT_FALSE(fs::exists(files().tiles));
}

TEST_F(MakeMap, GivesTheSameBytesAfterStops) {
  const auto whole = bytesAfter(mapScene(), {});
  MapOptions part;
  part.part = store::ClipPart{1, 3};
  EXPECT_EQ(make(mapScene(), part).finished, 2U);

  std::atomic<bool> stop = true;
  MapOptions options = resuming();
  options.execution = {1, &stop};
  const MadeMap before = make(mapScene(), options);
  EXPECT_FALSE(before.isWhole);
  EXPECT_EQ(before.found, 2U);
  EXPECT_EQ(before.finished, 2U);
  EXPECT_EQ(before.tiles, 8U);

  // A stop in between comes after any number of tiles, even after the last.
  stop = false;
  options.execution.progress = [&](std::size_t done, std::size_t) { stop = done > 0; };
  const MadeMap between = make(mapScene(), options);
  EXPECT_EQ(between.isWhole, between.finished == between.tiles);
  EXPECT_GE(between.finished, 3U);
  const MadeMap made = make(mapScene(), resuming());
  EXPECT_EQ(made.found, between.finished);
  EXPECT_EQ(made.finished, 8U);
  EXPECT_EQ(bytesAfter(mapScene(), resuming()), whole);
}

// A tile of these runs takes a minute.
TEST_F(MakeMap, KeepsNoTileThatAStopCutShort) {
  const scene::Scene scene = mapScene({"map.duration=1e4", "simulation.integrator=rk4"});
  std::atomic<bool> stop = false;
  MapOptions options;
  options.execution = {1, &stop};
  int calls = 0;
  options.execution.progress = [&](std::size_t, std::size_t) { stop = ++calls > 2; };
  const MadeMap made = make(scene, options);
  EXPECT_FALSE(made.isWhole);
  EXPECT_EQ(made.finished, 0U);
  EXPECT_EQ(make(scene, options).found, 0U);
}

TEST_F(MakeMap, MakesDamagedTilesAgain) {
  const auto whole = bytesAfter(mapScene(), {});
  make(mapScene());
  std::ofstream(files().tiles / "tile_3", std::ios::app) << "x";
  std::fstream damaged(files().tiles / "tile_5", std::ios::in | std::ios::out);
  damaged.seekp(-1, std::ios::end);
  damaged << '\x7f';
  damaged.close();
  // Of zeros, cut off and empty, as a power cut leaves tiles
  const auto size = fs::file_size(files().tiles / "tile_6");
  std::ofstream(files().tiles / "tile_6") << std::string(size, '\0');
  fs::resize_file(files().tiles / "tile_7", 9);
  fs::resize_file(files().tiles / "tile_1", 0);
  EXPECT_EQ(make(mapScene(), resuming()).found, 3U);
  EXPECT_EQ(bytesAfter(mapScene(), resuming()), whole);
}

TEST_F(MakeMap, GoesOnWhereItWasKilledWhileItWroteItsFiles) {
  const auto whole = bytesAfter(mapScene(), {});
  make(mapScene());
  std::ofstream(files().npy) << whole.at("small.npy");
  EXPECT_EQ(make(mapScene(), resuming()).found, 8U);
  EXPECT_EQ(bytesAfter(mapScene(), resuming()), whole);
}

TEST_F(MakeMap, AsksWhereThereAreTiles) {
  make(mapScene());
  EXPECT_MESSAGE(messageOf<InputError>([&] { make(mapScene()); }));
  const scene::Scene other = mapScene({"map.duration=0.9"});
  EXPECT_MESSAGE(messageOf<InputError>([&] { make(other, resuming()); }));
  MapOptions overwrite = resuming();
  overwrite.overwrite = true;
  EXPECT_EQ(make(other, overwrite).found, 0U);
  EXPECT_EQ(make(other, overwrite).found, 8U) << "its own tiles are kept";
}

TEST_F(MakeMap, KeepsValuesOfTheSameSettings) {
  writeMap(mapScene(), study::MapRuns(mapScene()), make(mapScene()).result, files());
  EXPECT_EQ(make(mapScene(), resuming()).found, 8U);
  const scene::Scene retitled =
      mapScene({"title=Other", "map.colors={palette='gray'}", "map.x.label=steps"});
  EXPECT_EQ(make(retitled, resuming()).found, 8U) << "looks change no values";
  EXPECT_MESSAGE(messageOf<InputError>([&] { make(mapScene({"map.duration=2"}), resuming()); }));
  std::ofstream(files().npy, std::ios::app) << "x";
  EXPECT_EQ(make(mapScene(), resuming()).found, 0U) << "its array is damaged";
}

TEST_F(MakeMap, KeepsValuesWhosePicturesCannotBeMadeAnew) {
  const MadeMap made = make(mapScene());
  const study::MapRuns runs(mapScene());
  writeMap(mapScene(), runs, made.result, files());
  store::MapFiles elsewhere = files();
  elsewhere.plots = {folder_ / "none" / "small.png"};
  EXPECT_THROW(writeMap(mapScene(), runs, made.result, elsewhere, 1), MachineError);
  EXPECT_EQ(make(mapScene(), resuming()).found, 8U);
}

TEST_F(MakeMap, WritesWhatItSays) {
  const scene::Scene scene = mapScene();
  const MadeMap made = make(scene);
  const auto written = writeMap(scene, study::MapRuns(scene), made.result, files());
  EXPECT_EQ(written.size(), 7U);
  study::MapResult read = emptyResult(scene, study::MapRuns(scene));
  ASSERT_TRUE(readNpy(bytesOf(files().npy), *scene.map, read));
  EXPECT_EQ(read.values, made.result.values);
  const image::Image plain = image::readPng(files().plain);
  EXPECT_EQ(plain, plot::plainMap(made.result, *scene.map));
  EXPECT_EQ(plain.width(), 100);
  EXPECT_GT(image::readPng(files().png()).width(), 900);
  EXPECT_EQ(study::checksumsIn(bytesOf(files().json)).fingerprint, store::mapFingerprint(scene));
}

TEST_F(MakeMap, WritesNoTableOfManyRuns) {
  const scene::Scene scene = mapScene({"map.size=[101, 100]", "map.duration=0.05"});
  EXPECT_EQ(writeMap(scene, study::MapRuns(scene), make(scene).result, files()).size(), 6U);
  EXPECT_FALSE(fs::exists(files().csv));
}

}  // namespace
}  // namespace rotatebook::pipeline
