#include "verify/picture_comparison.h"

#include <cstddef>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "picture/frame_drawer.h"
#include "scene/small_scene.h"
#include "timeline/simulate_scene.h"
#include "video/planes.h"

namespace rotatebook::verify {
namespace {

using scene::testing::kFrames;
using scene::testing::smallScene;
using video::VideoFormat;

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
    return video::planesOf(picture.view(), false);
  };
  const video::Planes said = planesAt(5), next = planesAt(6);
  const auto closerTo = [&](float shareOfNext) {
    return PictureComparison(scene, drawer, kFrames, VideoFormat::Mp4)
        .compare(5, mixture(next, said, shareOfNext))
        .closerTo;
  };
  EXPECT_EQ(closerTo(0.9F), 6);             // 0.11 times as far from the next frame as from its own
  EXPECT_EQ(closerTo(0.65F), 6);            // 0.54 times
  EXPECT_EQ(closerTo(0.6F), std::nullopt);  // 0.67 times
  EXPECT_EQ(closerTo(0.0F), std::nullopt);
}

TEST(EncodingBound, IsThatOfTheMeasurements) {
  const auto expectBound = [](VideoFormat format, int crf, double rms, double worstBlock) {
    EXPECT_NEAR(encodingBound(format, crf).rms, rms, 0.05) << nameOf(format) << " " << crf;
    EXPECT_NEAR(encodingBound(format, crf).worstBlock, worstBlock, 0.05)
        << nameOf(format) << " " << crf;
  };
  expectBound(VideoFormat::Mp4, 0, 1.5, 4);
  expectBound(VideoFormat::Mp4, 18, 3.8, 10);
  expectBound(VideoFormat::Mp4, 36, 15.2, 47.6);
  expectBound(VideoFormat::Mp4, 51, 26, 60);
  expectBound(VideoFormat::WebM, 0, 3.8, 10);
}

TEST(EncodingBound, GrowsWithTheRateFactor) {
  EXPECT_LT(encodingBound(VideoFormat::Mp4, 1).worstBlock,
            encodingBound(VideoFormat::Mp4, 18).worstBlock);
  EXPECT_LT(encodingBound(VideoFormat::Mp4, 18).rms, encodingBound(VideoFormat::Mp4, 30).rms);
  EXPECT_EQ(encodingBound(VideoFormat::WebM, 1).rms, encodingBound(VideoFormat::WebM, 51).rms);
}

}  // namespace
}  // namespace rotatebook::verify
