#include "picture/frame_drawer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/comparison.h"
#include "image/marked_tiles.h"
#include "pipeline/small_clip.h"
#include "scene/shipped_scene.h"

namespace rotatebook::picture {
namespace {

image::Image drawnFrame(const scene::Scene& scene, std::int64_t frame) {
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  FrameDrawer drawer(scene, motion);
  image::Image picture = drawer.makePicture();
  drawer.draw(frame, picture);
  return picture;
}

scene::Scene sceneWith(const std::string& overlays) {
  return pipeline::testing::smallScene({"clip.size=[320, 180]", "overlay.show=" + overlays});
}

TEST(FrameDrawer, DrawsTheBookAloneWithoutOverlays) {
  const scene::Scene scene = sceneWith("[]");
  const physics::Trajectory trajectory = pipeline::testing::motionOf(scene);
  render::Renderer renderer = makeRenderer(scene);
  image::Image expected = renderer.makePicture();
  renderer.draw(trajectory.samples[7].cage, expected);
  EXPECT_EQ(drawnFrame(scene, 7), expected);
}

TEST(FrameDrawer, WritesOverTheBook) {
  const image::Image plain = drawnFrame(sceneWith("[]"), 7);
  const image::Image clock = drawnFrame(sceneWith("['clock']"), 7);
  const image::Image caption = drawnFrame(sceneWith("['caption']"), 7);
  EXPECT_NE(clock, plain);
  EXPECT_NE(caption, plain);
  EXPECT_NE(caption, clock);
  EXPECT_EQ(drawnFrame(sceneWith("['clock']"), 7), clock);
}

TEST(FrameDrawer, DrawsTheSameOverAnyPicture) {
  for (const char* more : {"look.supersample=1", "look.supersample=2", "look.background='stars'"}) {
    const scene::Scene scene = pipeline::testing::smallScene(
        {"clip.size=[320, 180]", "overlay.show=['caption', 'clock', 'polhode', 'omega']",
         "camera.frame='body'", more});
    const timeline::ClipMotion motion = timeline::simulateScene(scene);
    FrameDrawer drawer(scene, motion);
    std::array<image::Image, 2> pictures;
    for (const std::int64_t frame : {0, 3, 9, 9, 1, 4, 0}) {
      image::Image& picture = pictures[static_cast<std::size_t>(frame % 2)];
      drawer.draw(frame, picture);
      EXPECT_EQ(picture, drawnFrame(scene, frame)) << more << ", frame " << frame;
    }
  }
}

// Of clips with cues, panels, paths, and a body that deforms.
TEST(FrameDrawer, MarksTilesAsTheSameThatAreTheSame) {
  for (const char* name :
       {"slow-motion", "comparisons/axes", "bodies/earth", "figures/figh-rolling",
        "figures/fig06-undamped", "comparisons/tossed-book"}) {
    const scene::Scene scene = scene::shippedScene(name, {"clip.size=[480, 270]", "clip.fps=2"});
    const timeline::ClipMotion motion = timeline::simulateScene(scene);
    FrameDrawer drawer(scene, motion);
    image::testing::MarkedTiles tiles;
    std::array<image::Image, 2> pictures;
    for (std::int64_t frame = 0; frame < motion.frameCount(); ++frame) {
      image::Image& picture = pictures[static_cast<std::size_t>(frame % 2)];
      drawer.draw(frame, picture);
      EXPECT_TRUE(tiles.agreeWith(picture)) << name << ", frame " << frame;
    }
    EXPECT_GT(tiles.known(), 1000U) << name;
  }
}

TEST(FrameDrawer, TurnsWithTheCamerasFrame) {
  const auto inFrame = [](const char* frame, std::int64_t n) {
    return drawnFrame(pipeline::testing::smallScene({"camera.frame=" + std::string(frame)}), n);
  };
  EXPECT_NE(inFrame("world", 0), inFrame("world", 9));
  // The book stands still but for the integrator's drift, which moves single edge pixels.
  const image::Tolerance edges{.largest = 8, .failPercent = 1};
  EXPECT_TRUE(image::compare(inFrame("body", 0).view(), inFrame("body", 9).view(), edges).same);
  EXPECT_FALSE(image::compare(inFrame("body", 0).view(), inFrame("world", 9).view(), edges).same);
  EXPECT_FALSE(
      image::compare(inFrame("body", 0).view(), inFrame("momentum", 0).view(), edges).same);
}

TEST(FrameDrawer, DrawsBackFromABodyThatGrows) {
  const auto burst = [](const std::string& follow, std::int64_t n) {
    return drawnFrame(
        pipeline::testing::smallScene({"simulation.model=particles", "simulation.normalize=false",
                                       "simulation.damping=0", "simulation.integrator=euler",
                                       "simulation.substeps=2", "camera.follow=" + follow}),
        n);
  };
  EXPECT_NE(burst("size", 9), burst("none", 9));
  EXPECT_EQ(drawnFrame(pipeline::testing::smallScene({"camera.follow=size"}), 9),
            drawnFrame(pipeline::testing::smallScene(), 9));
}

// Blurred or not, the motion is the same to the last bit.
TEST(ShutterMoments, BeginWithTheSample) {
  for (const std::string model : {"particles", "matrix", "quaternion", "exact"}) {
    const scene::Scene scene = pipeline::testing::smallScene(
        {"simulation.model='" + model + "'", "simulation.substeps=24", "look.motion_blur=4"});
    const physics::Trajectory trajectory = pipeline::testing::motionOf(scene);
    const timeline::ShutterMoments moments(scene);
    ASSERT_EQ(moments.count(), 4U);
    for (std::size_t i = 0; i < trajectory.samples.size(); ++i) {
      ASSERT_EQ(moments.at(0, i, 0).cage, trajectory.samples[i].cage) << model << " " << i;
    }
    // The shutter closes half a frame later: at the eighth of eight moments less one half.
    EXPECT_NEAR(moments.at(0, 1, 3).time,
                trajectory.samples[1].time + 3.0 / 8 * trajectory.interval, 1e-15);
  }
}

TEST(FrameDrawer, AveragesTheMomentsOfMotionBlur) {
  const scene::Scene sharp = sceneWith("[]");
  const scene::Scene blurred =
      pipeline::testing::smallScene({"clip.size=[320, 180]", "look.motion_blur=2"});
  const timeline::ShutterMoments moments(blurred);
  render::Renderer renderer = makeRenderer(sharp);
  image::LinearMean mean(320, 180);
  image::Image expected = renderer.makePicture();
  for (const std::size_t moment : {0U, 1U}) {
    renderer.draw(moments.at(0, 5, moment).cage, expected);
    mean.add(expected.view());
  }
  mean.take(expected);
  const image::Image first = drawnFrame(sharp, 5);
  EXPECT_EQ(drawnFrame(blurred, 5), expected);
  EXPECT_NE(first, expected);
}

scene::Scene clearScene(const std::string& overlays, std::vector<std::string> settings = {}) {
  settings.insert(settings.end(), {"clip.size=[320, 180]", "look.background=transparent",
                                   "overlay.show=" + overlays});
  return pipeline::testing::smallScene(settings);
}

std::array<int, 4> pixelAt(const image::Image& picture, int x, int y) {
  const std::uint8_t* pixel = picture.row(y) + static_cast<std::ptrdiff_t>(x) * 4;
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

TEST(FrameDrawer, DrawsNothingWithoutBodiesAndOverlays) {
  const image::Image nothing(320, 180, image::PixelFormat::Rgba8);
  EXPECT_NE(drawnFrame(clearScene("[]"), 7), nothing);
  EXPECT_EQ(drawnFrame(clearScene("[]", {"look.body=false"}), 7), nothing);
  for (const char* way :
       {"look.motion_blur=2", "look.supersample=2", "body.shape=racket", "camera.frame=turning"})
    EXPECT_EQ(drawnFrame(clearScene("[]", {"look.body=false", way}), 7), nothing) << way;
}

TEST(FrameDrawer, DrawsTheSameOverlaysWithoutBodies) {
  const std::string overlays = "['clock', 'axes', 'momentum', 'omega']";
  const image::Image body = drawnFrame(clearScene("[]"), 7);
  const image::Image both = drawnFrame(clearScene(overlays), 7);
  const image::Image alone = drawnFrame(clearScene(overlays, {"look.body=false"}), 7);
  int beside = 0, over = 0;
  for (int y = 0; y < body.height(); ++y) {
    for (int x = 0; x < body.width(); ++x) {
      const bool isDrawn = pixelAt(alone, x, y)[3] > 0;
      if (pixelAt(body, x, y)[3] == 0) {
        ASSERT_EQ(pixelAt(alone, x, y), pixelAt(both, x, y)) << x << " " << y;
        beside += isDrawn;
      } else if (pixelAt(body, x, y) != pixelAt(both, x, y)) {
        ASSERT_TRUE(isDrawn) << x << " " << y;
        ++over;
      }
    }
  }
  EXPECT_GT(beside, 1000);  // measured 1243
  EXPECT_GT(over, 500);     // measured 626
}

}  // namespace
}  // namespace rotatebook::picture
