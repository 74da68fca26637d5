#include "pipeline/frame_drawer.h"

#include <gtest/gtest.h>

#include "image/comparison.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

image::Image drawn(const scene::Scene& scene, std::int64_t frame) {
  const ClipMotion motion = simulateScene(scene);
  FrameDrawer drawer(scene, motion);
  image::Image picture = drawer.makePicture();
  drawer.draw(frame, picture);
  return picture;
}

scene::Scene sceneWith(const std::string& overlays) {
  return testing::smallScene({"clip.size=[320, 180]", "overlay.show=" + overlays});
}

TEST(FrameDrawer, DrawsTheBookAloneWithoutOverlays) {
  const scene::Scene scene = sceneWith("[]");
  const physics::Trajectory trajectory = testing::motionOf(scene);
  render::Renderer renderer = makeRenderer(scene);
  image::Image expected = renderer.makePicture();
  renderer.draw(trajectory.samples[7].corners, expected);
  EXPECT_EQ(drawn(scene, 7), expected);
}

TEST(FrameDrawer, WritesOverTheBook) {
  const image::Image plain = drawn(sceneWith("[]"), 7);
  const image::Image clock = drawn(sceneWith("['clock']"), 7);
  const image::Image caption = drawn(sceneWith("['caption']"), 7);
  EXPECT_NE(clock, plain);
  EXPECT_NE(caption, plain);
  EXPECT_NE(caption, clock);
  EXPECT_EQ(drawn(sceneWith("['clock']"), 7), clock);
}

TEST(FrameDrawer, TurnsWithTheCamerasFrame) {
  const auto inFrame = [](const char* frame, std::int64_t n) {
    return drawn(testing::smallScene({"camera.frame=" + std::string(frame)}), n);
  };
  EXPECT_NE(inFrame("world", 0), inFrame("world", 9));
  // The book stands still but for the integrator's drift, which moves single edge pixels.
  const image::Tolerance edges{.largest = 8, .failPercent = 1};
  EXPECT_TRUE(image::compare(inFrame("body", 0).view(), inFrame("body", 9).view(), edges).same);
  EXPECT_FALSE(image::compare(inFrame("body", 0).view(), inFrame("world", 9).view(), edges).same);
  EXPECT_FALSE(
      image::compare(inFrame("body", 0).view(), inFrame("momentum", 0).view(), edges).same);
}

}  // namespace
}  // namespace rotatebook::pipeline
