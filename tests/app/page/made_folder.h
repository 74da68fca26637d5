// A folder with what a render and a study leave, without the rendering.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "page/figure.h"
#include "scene/scene_text.h"
#include "store/clip_files.h"
#include "store/clip_record.h"
#include "store/encoding.h"
#include "store/tables.h"
#include "system/atomic_file.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"
#include "video/video_writer.h"

namespace rotatebook::page::testing {

/// An empty folder for the running test alone.
inline std::filesystem::path emptyFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(ROTATEBOOK_TEST_OUTPUT) / "page" /
                      (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// Half a second, named "small".
inline scene::Scene smallScene(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "title = \"Small & <small>\"\ncaption = \"It's \\\"small\\\".\"\n"
      "[initial]\nangular_velocity = [5, 3, 1]\n"
      "[clip]\nsize = [64, 36]\nfps = 24\nduration = 0.5\n"
      "[expect]\nhalf_turns = { max = 0 }\nL_ratio = { min = 2 }\n",
      "scenes/small.toml", overrides);
}

/// Stands for files that nobody reads.
inline void touch(const std::filesystem::path& path) {
  system::writeFileAtomically(path, "x");
}

inline void makePicture(const std::filesystem::path& path, int width, int height) {
  image::writePng(path, image::Image(width, height, image::PixelFormat::Rgb8).view());
}

/// The record that a render of `scene` leaves.
inline std::string recordOf(const scene::Scene& scene) {
  return store::sceneRecord(scene, {.scene = scene.name, .program = "1"});
}

/// Leaves a video of black pictures of the scene's size in `folder`, with its record.
inline void makeVideo(const scene::Scene& scene, const std::filesystem::path& folder,
                      video::VideoFormat format = video::VideoFormat::Mp4) {
  const scene::ClipSettings& clip = scene.clip;
  video::VideoWriter writer(format, store::clipFiles(folder, scene.name).video(format),
                            store::videoSettings(scene, recordOf(scene)));
  const image::Image black(clip.width, clip.height, image::PixelFormat::Rgb8);
  // FFmpeg takes an APNG of one picture for a PNG.
  for (int i = 0; i < 2; ++i) writer.write(black.view());
  writer.finish();
}

/// Leaves the clip of `scene` in `folder`: its CSV and JSON are true, its MP4 and poster are black.
inline void makeClip(const scene::Scene& scene, const std::filesystem::path& folder) {
  const store::ClipFiles files = store::clipFiles(folder, scene.name);
  makeVideo(scene, folder);
  makePicture(files.poster, scene.clip.width, scene.clip.height);
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  store::writeTables(store::csvFiles(files.csv, scene), scene, motion);
  store::writeResult(files.json, scene, motion, timeline::summarize(scene, motion),
                     timeline::motionChecksum(motion));
}

/// Returns why the folder has no figure of the scene; "no error" if it has.
inline std::string messageOf(const scene::Scene& scene, const std::filesystem::path& folder) {
  try {
    readFigure(scene, folder);
    return "no error";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace rotatebook::page::testing
