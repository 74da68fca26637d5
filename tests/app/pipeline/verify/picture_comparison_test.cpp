#include "pipeline/verify/picture_comparison.h"

#include <cstddef>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "picture/frame_drawer.h"
#include "scene/small_scene.h"
#include "timeline/simulate_scene.h"
#include "video/planes.h"

namespace rotatebook::pipeline {
namespace {

using scene::testing::kFrames;
using scene::testing::smallScene;

/// `share` of `a`, and the rest of `b`.
video::Planes mixture(const video::Planes& a, const video::Planes& b, float share) {
  video::Planes mixed = a;
  for (const auto plane : {&video::Planes::y, &video::Planes::u, &video::Planes::v}) {
    for (std::size_t i = 0; i < (mixed.*plane).size(); ++i) {
      (mixed.*plane)[i] = share * (a.*plane)[i] + (1 - share) * (b.*plane)[i];
    }
  }
  return mixed;
}

// A mixture of two frames is away from each as far as the share of the other says.
TEST(PictureComparison, KnowsAPictureOfTheNextFrameThatIsFarFromBoth) {
  const scene::Scene scene = smallScene();
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  picture::FrameDrawer drawer(scene, motion);
  const auto planesAt = [&](std::int64_t frame) {
    image::Image picture = drawer.makePicture();
    drawer.draw(frame, picture);
    return video::planesToEncode(picture.view(), false);
  };
  const video::Planes said = planesAt(5), next = planesAt(6);
  const auto closerTo = [&](float shareOfNext) {
    return PictureComparison(scene, drawer, kFrames)
        .compare(5, mixture(next, said, shareOfNext), {})
        .closerTo;
  };
  EXPECT_EQ(closerTo(0.9F), 6);             // 0.11 times as far from the next frame as from its own
  EXPECT_EQ(closerTo(0.65F), 6);            // 0.54 times
  EXPECT_EQ(closerTo(0.6F), std::nullopt);  // 0.67 times
  EXPECT_EQ(closerTo(0.0F), std::nullopt);
}

TEST(EncodingBound, GrowsWithTheQuantiser) {
  for (const MeasureRow& row : kMeasures) {
    const auto bound = [&](double quantiser) {
      return encodingBound(quantiser, 640, 360).*row.value;
    };
    EXPECT_GT(bound(0), 0) << row.name;
    EXPECT_LT(bound(0), bound(20)) << row.name;
    EXPECT_LT(bound(20), bound(32)) << row.name;
    EXPECT_LT(2 * bound(32), bound(51)) << row.name;
  }
}

TEST(EncodingBound, IsSmallerWhereMoreIsAveraged) {
  const Deviation small = encodingBound(20, 320, 180), large = encodingBound(20, 1280, 720);
  EXPECT_NEAR(small.brightness / large.brightness, 2, 1e-12);
  EXPECT_EQ(small.lumaPatch, large.lumaPatch);
}

// Whoever codes a few pictures coarsely in a fine clip gains nothing.
TEST(PictureComparison, BoundsACoarsePictureByTheCoarsestProof) {
  const scene::Scene scene = smallScene();
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  picture::FrameDrawer drawer(scene, motion);
  image::Image picture = drawer.makePicture();
  drawer.draw(5, picture);
  const video::Planes planes = video::planesToEncode(picture.view(), false);
  const auto boundAt = [&](std::optional<double> quantiser) {
    return PictureComparison(scene, drawer, kFrames).compare(5, planes, {quantiser}).bound.rms;
  };
  EXPECT_EQ(boundAt(51), boundAt(kCoarsestProof));
  EXPECT_LT(boundAt(20), boundAt(kCoarsestProof));
  EXPECT_LT(boundAt(std::nullopt), boundAt(kCoarsestProof));
}

// Presets that skip blocks report coarse quantisers of pictures with little noise.
TEST(PictureComparison, BoundsAFinePictureOfCoarseQuantisersByItsNoise) {
  const scene::Scene scene = smallScene({"clip.size=[320, 180]"});
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  picture::FrameDrawer drawer(scene, motion);
  image::Image picture = drawer.makePicture();
  drawer.draw(5, picture);
  const video::Planes drawn = video::planesToEncode(picture.view(), false);
  const auto boundAt = [&](float noise, double quantiser) {
    video::Planes noisy = drawn;
    for (std::size_t i = 0; i < noisy.y.size(); ++i) noisy.y[i] += i % 2 == 0 ? noise : -noise;
    EXPECT_NEAR(codingNoise(noisy, drawn).value(), noise, 1e-4);
    return compareWith(drawn, 5, noisy, {quantiser}).bound;
  };
  EXPECT_LT(boundAt(1, 30).rms, boundAt(2, 30).rms);
  EXPECT_LT(boundAt(2, 30).lumaPatch, boundAt(3, 30).lumaPatch);
  EXPECT_LT(boundAt(2, 30).worstBlock, encodingBound(30, 320, 180).worstBlock);
  EXPECT_EQ(boundAt(2, 30).chromaPatch, encodingBound(30, 320, 180).chromaPatch);
  EXPECT_EQ(boundAt(0.3F, 26).rms, encodingBound(14, 320, 180).rms) << "still texture";
  EXPECT_EQ(boundAt(0.3F, 26).lumaPatch, encodingBound(20, 320, 180).lumaPatch);
  // Noise never allows more than the quantiser.
  EXPECT_EQ(boundAt(9, 20).lumaPatch, encodingBound(20, 320, 180).lumaPatch);
}

}  // namespace
}  // namespace rotatebook::pipeline
