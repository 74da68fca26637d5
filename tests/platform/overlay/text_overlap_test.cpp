// Verifies that texts never meet, at any size.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "overlay/caption_and_clock.h"
#include "overlay/motion.h"
#include "scene/shipped_scene.h"

namespace rotatebook::overlay {
namespace {

namespace fs = std::filesystem;

const std::string kEverything = "'clock', " + testing::namesOfMotionOverlays();

/// The longest of the scenes that ship and are drawn as clips; maps have sheets of their own.
std::string longestCaption() {
  std::string longest;
  const fs::path folder = fs::path(ROTATEBOOK_SOURCE) / "scenes";
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const fs::path name = entry.path().lexically_relative(folder).replace_extension();
    const scene::Scene scene = scene::shippedScene(name.string());
    const std::string& caption = scene.caption;
    if (!scene.map && caption.size() > longest.size()) longest = caption;
  }
  return longest;
}

scene::Scene sceneOf(int width, int height, const std::string& show) {
  scene::Scene scene = testing::tumbling(
      {"clip.size=[" + std::to_string(width) + ", " + std::to_string(height) + "]",
       "simulation.model='particles'", "simulation.integrator='euler'",
       "overlay.show=[" + show + "]"});
  static const std::string kLongest = longestCaption();
  scene.caption = kLongest;
  scene.title = "Energy not corrected: the book spins up and explodes";
  return scene;
}

struct Size {
  int width, height;
};

std::string text(const Size& size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

constexpr Size kWhole[] = {{640, 360},   {854, 480},   {1280, 720}, {1920, 1080},
                           {2560, 1440}, {3840, 2160}, {480, 854},  {1080, 1080}};
constexpr Size kPanels[] = {{424, 360}, {640, 352}, {320, 720}, {426, 720},
                            {640, 720}, {318, 178}, {960, 540}, {1278, 1078},
                            {212, 178}, {212, 130}, {158, 270}, {158, 130}};

void expectApart(const std::vector<Box>& boxes, const Size& size) {
  EXPECT_EQ(testing::meeting(boxes), "");
  for (const Box& box : boxes) {
    EXPECT_TRUE((Box{0, 0, 1.0 * size.width, 1.0 * size.height}.holds(box)))
        << box.x << ", " << box.y << ", " << box.width << " x " << box.height;
  }
}

/// Frames of an ordinary motion, and the last one with the notice.
void expectNoMeeting(const scene::Scene& scene, CaptionAndClock* captionAndClock,
                     const Viewport& viewport) {
  physics::Trajectory trajectory = testing::motionOf(scene);
  trajectory.divergedAt = 9999.99;
  MotionOverlays overlays(scene, trajectory, viewport);
  image::Image picture = testing::greyPicture(scene);
  const std::int64_t step = viewport.height > 1500 ? 60 : 9;
  for (std::int64_t frame = 0; frame <= scene.clip.frameCount(); frame += step) {
    overlays.draw(frame, testing::clipFromWorld(scene, overlays.bottomRows()), picture);
    std::vector<Box> boxes = overlays.texts();
    if (captionAndClock != nullptr) {
      captionAndClock->draw(frame, picture);
      boxes.insert(boxes.end(), captionAndClock->texts().begin(), captionAndClock->texts().end());
    }
    SCOPED_TRACE(frame);
    expectApart(boxes, {viewport.width, viewport.height});
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Texts, NeverMeetOnAWholePicture) {
  EXPECT_GT(longestCaption().size(), 200U);  // measured 206
  for (const Size& size : kWhole) {
    SCOPED_TRACE(text(size));
    const scene::Scene scene =
        sceneOf(size.width, size.height, "'caption', 'settings', " + kEverything);
    CaptionAndClock captionAndClock(scene);
    expectNoMeeting(
        scene, &captionAndClock,
        {size.width, size.height, captionAndClock.corner(), captionAndClock.bottomRows()});
  }
}

TEST(Texts, NeverMeetAtAnyScale) {
  for (const Size& size : {Size{640, 360}, Size{1280, 720}, Size{480, 854}, Size{1080, 1080}}) {
    for (const double scale : {0.5, 1.5, 2.0, 3.0}) {
      SCOPED_TRACE(text(size) + " " + std::to_string(scale));
      scene::Scene scene = sceneOf(size.width, size.height, "'caption', " + kEverything);
      scene.overlay.scale = scale;
      scene.caption.clear();
      scene.title = "A title";
      CaptionAndClock captionAndClock(scene);
      expectNoMeeting(
          scene, &captionAndClock,
          {size.width, size.height, captionAndClock.corner(), captionAndClock.bottomRows()});
    }
  }
}

TEST(Texts, NeverMeetInGerman) {
  for (const Size& size : {Size{640, 360}, Size{1280, 720}, Size{480, 854}}) {
    SCOPED_TRACE(text(size));
    scene::Scene scene = sceneOf(size.width, size.height, "'settings', " + kEverything);
    scene.overlay.words = scene::germanWords();
    CaptionAndClock captionAndClock(scene);
    expectNoMeeting(
        scene, &captionAndClock,
        {size.width, size.height, captionAndClock.corner(), captionAndClock.bottomRows()});
  }
}

TEST(Texts, NeverMeetOnAPanel) {
  for (const Size& size : kPanels) {
    SCOPED_TRACE(text(size));
    const scene::Scene scene = sceneOf(size.width, size.height, kEverything);
    // Small ones, and those of a picture twice as wide and high.
    for (const double letters : {0.0, 0.044 * std::min(size.width, size.height)}) {
      SCOPED_TRACE(letters);
      expectNoMeeting(scene, nullptr,
                      {.width = size.width, .height = size.height, .letters = letters});
    }
  }
}

TEST(Texts, OfAClipWithPanelsNeverMeet) {
  for (const Size& size : kWhole) {
    for (const char* show : {"'caption', 'clock'", "'clock'"}) {
      SCOPED_TRACE(text(size) + show);
      const scene::Scene scene = sceneOf(size.width, size.height, show);
      CaptionAndClock captionAndClock(scene, CaptionAndClock::ClockPosition::Bottom);
      EXPECT_TRUE(captionAndClock.corner().empty());
      image::Image picture = testing::greyPicture(scene);
      captionAndClock.draw(100, picture);
      EXPECT_FALSE(captionAndClock.texts().empty());
      expectApart(captionAndClock.texts(), size);
      for (const Box& box : captionAndClock.texts())
        EXPECT_GE(box.y, size.height - captionAndClock.bottomRows());
    }
  }
}

}  // namespace
}  // namespace rotatebook::overlay
