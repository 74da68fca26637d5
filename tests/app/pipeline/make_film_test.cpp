// Films of maps: the same bytes however they are made.
#include "pipeline/make_film.h"

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "pipeline/small_clip.h"
#include "scene/scene_text.h"
#include "store/fingerprint.h"
#include "video/clip_reader.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using testing::emptyFolder;
using testing::messageOf;

// Six frames of 16 x 12 runs, with ticks that come and go.
scene::Scene filmScene(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "[initial]\nangular_velocity = [8, 0, 0]\ntilt = [0.01, 'z']\n[clip]\nfps = 10\n[map]\n"
      "x = { key = 'simulation.substeps', from = 1, to = 9 }\n"
      "y = { key = 'initial.tilt.0', from = 1e-4, to = 1, scale = 'log' }\n"
      "measure = 'half_turns'\nduration = 1\nsize = [16, 12]\ncolors = { from = 0, to = 5 }\n"
      "film = { y = [0.1, 0.15], duration = 0.6 }\n",
      "small.toml", overrides);
}

class MakeFilm : public ::testing::Test {
 protected:
  MakeFilm() : files_(store::mapFiles(emptyFolder(), "small")) {}

  MadeFilm make(const scene::Scene& scene, int threads = 2, bool resume = false) const {
    MapOptions options;
    options.execution.threads = threads;
    options.resume = resume;
    return makeFilm(scene, files_, options);
  }

  MadeFilm stopAfter(std::size_t count) const {
    std::atomic<bool> stop = false;
    MapOptions options;
    options.execution.threads = 1;
    options.execution.stop = &stop;
    options.execution.progress = [&](std::size_t done, std::size_t) {
      if (done >= count) stop = true;
    };
    return makeFilm(filmScene(), files_, options);
  }

  store::MapFiles files_;
};

TEST_F(MakeFilm, HasTheSameBytesWithAnyThreadsAndAfterAStop) {
  EXPECT_TRUE(make(filmScene(), 1).isWhole);
  const std::string bytes = bytesOf(files_.film);
  EXPECT_FALSE(fs::exists(files_.filmFrames));
  make(filmScene(), 3);
  EXPECT_EQ(bytesOf(files_.film), bytes);

  fs::remove(files_.film);
  const MadeFilm stopped = stopAfter(2);
  EXPECT_FALSE(stopped.isWhole);
  EXPECT_FALSE(fs::exists(files_.film));
  EXPECT_MESSAGE(messageOf<InputError>([&] { make(filmScene()); }));
  const MadeFilm whole = make(filmScene(), 2, true);
  EXPECT_EQ(whole.found, stopped.finished);
  EXPECT_TRUE(make(filmScene(), 2, true).wasDone);
  EXPECT_GE(whole.found, 2U);
  EXPECT_EQ(bytesOf(files_.film), bytes);
}

TEST_F(MakeFilm, HasAFrameForEachMomentAndKnowsItsScene) {
  make(filmScene());
  EXPECT_EQ(video::readClipMetadata(files_.film).comment, store::recordOfFilm(filmScene()));
  video::ClipReader reader(files_.film);
  int frames = 0;
  while (reader.next()) ++frames;
  EXPECT_EQ(frames, 6);
  EXPECT_NEAR(reader.facts().duration, 0.6, 1e-3);
}

TEST_F(MakeFilm, RefusesAMapWithoutAFilmAndFramesOfOthers) {
  scene::Scene without = filmScene();
  without.map->film.reset();
  EXPECT_MESSAGE(messageOf<InputError>([&] { make(without); }));
  make(filmScene());
  EXPECT_MESSAGE(messageOf<InputError>([&] { make(filmScene({"map.duration=2"})); }));
  fs::remove(files_.film);
  stopAfter(1);
  EXPECT_MESSAGE(messageOf<InputError>([&] { make(filmScene({"map.duration=2"}), 1, true); }));
}

}  // namespace
}  // namespace rotatebook::pipeline
