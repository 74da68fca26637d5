// Clips that say they are of one scene, and show another.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "pipeline/verify/verify_clip.h"
#include "store/encoding.h"
#include "timeline/motion_checksum.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline::testing {

/// smallScene() in pictures that show a degree.
inline scene::Scene shownScene(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), "clip.size=[320, 180]");
  return scene::testing::smallScene(overrides);
}

/// A clip that says it is of one scene, and shows another.
struct Forgery {
  scene::Scene said = shownScene();
  scene::Scene shown = shownScene();
  std::int64_t shift = 0;  ///< Frame n shows frame n + shift, as far as there is one.
  std::int64_t frames = kFrames;
  bool swapped = false;  ///< Red and blue.
  int brighter = 0;      ///< By how much each colour of each pixel is. [of 255]
  std::function<void(video::VideoSettings&)> change{};
  std::function<void(store::Provenance&)> made{};
};

inline void swapRedAndBlue(image::Image& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* row = picture.row(y);
    for (int x = 0; x < picture.width(); ++x) std::swap(row[4 * x], row[4 * x + 2]);
  }
}

inline void brighten(image::Image& picture, int by) {
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* row = picture.row(y);
    for (int i = 0; i < 4 * picture.width(); ++i) {
      if (i % 4 != 3) row[i] = static_cast<std::uint8_t>(std::min(row[i] + by, 255));
    }
  }
}

inline void writeClip(const Forgery& forgery, const std::filesystem::path& path) {
  const timeline::ClipMotion motion = timeline::simulateScene(forgery.shown);
  picture::FrameDrawer drawer(forgery.shown, motion);
  store::Provenance provenance = store::provenanceOf(
      forgery.said, timeline::motionChecksum(timeline::simulateScene(forgery.said)), {},
      drawer.description(), video::ffmpegVersion());
  if (forgery.made) forgery.made(provenance);
  video::VideoSettings settings =
      store::videoSettings(forgery.shown, store::sceneRecord(forgery.said, provenance));
  if (forgery.change) forgery.change(settings);
  video::VideoWriter writer(video::VideoFormat::Mp4, path, settings);
  image::Image picture = drawer.makePicture();
  for (std::int64_t n = 0; n < forgery.frames; ++n) {
    drawer.draw(std::clamp<std::int64_t>(n + forgery.shift, 0, kFrames - 1), picture);
    if (forgery.swapped) swapRedAndBlue(picture);
    if (forgery.brighter > 0) brighten(picture, forgery.brighter);
    writer.write(picture.view());
  }
  writer.finish();
}

inline Verification verified(const Forgery& forgery) {
  const std::filesystem::path path = emptyFolder() / "clip.mp4";
  writeClip(forgery, path);
  return verifyClip(path, {.allFrames = true});
}

inline bool proved(const Verification& found) {
  return found.verdict() == Verdict::Proved;
}

inline std::vector<std::string> failedIn(const Verification& found) {
  std::vector<std::string> names;
  for (const ClipCheck& check : found.checks) {
    if (!check.passed) names.push_back(check.what);
  }
  return names;
}

inline std::int64_t wrongPictures(const Verification& found) {
  return std::ranges::count(found.pictures, false, &PictureCheck::passed);
}

/// Expects that only pictures are wrong, and all of them.
inline void expectWrongPictures(const Verification& found) {
  EXPECT_FALSE(proved(found));
  EXPECT_THAT(failedIn(found), ::testing::IsEmpty());
  EXPECT_EQ(wrongPictures(found), kFrames);
}

}  // namespace rotatebook::pipeline::testing
