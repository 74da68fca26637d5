// A letter of a caption that is another than the scene's: docs/verify.md says at which sizes it is
// noticed.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "pipeline/verify/picture_comparison.h"
#include "store/encoding.h"
#include "video/clip_reader.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline {
namespace {

using video::VideoFormat;

/// The way in which a caption is coded.
struct Coding {
  std::string size;
  std::string preset;
  int crf = 18;
  VideoFormat format = VideoFormat::Mp4;
};

/// The pictures of a scene with `caption`, and what they are encoded from.
struct Captioned {
  Captioned(const std::string& caption, const Coding& coding)
      : scene(scene::testing::smallScene(
            {"clip.size=" + coding.size, "clip.duration=0.3", "caption='" + caption + "'",
             "overlay.show=['caption', 'clock']", "video.preset=" + coding.preset,
             "video.crf=" + std::to_string(coding.crf)})) {
    const timeline::ClipMotion motion = timeline::simulateScene(scene);
    picture::FrameDrawer drawer(scene, motion);
    for (std::int64_t frame = 0; frame < motion.frameCount(); ++frame) {
      pictures.push_back(drawer.makePicture());
      drawer.draw(frame, pictures.back());
      planes.push_back(video::planesToEncode(pictures.back().view(), false));
    }
  }

  scene::Scene scene;
  std::vector<image::Image> pictures;
  std::vector<video::Planes> planes;
};

/// Returns the least, over all pictures of a clip of `shown`, of the largest measure over its
/// bound, compared with `said`; above 1 each picture is refused.
double smallestExcess(const Captioned& shown, const Captioned& said, const Coding& coding) {
  const auto path = pipeline::testing::emptyFolder() / "captioned.video";
  video::VideoWriter writer(coding.format, path, store::videoSettings(shown.scene, ""));
  for (const image::Image& picture : shown.pictures) writer.write(picture.view());
  writer.finish();
  video::ClipReader reader(path);
  double smallest = 1e9;
  for (std::size_t frame = 0; reader.next(); ++frame) {
    const video::PictureFacts& coded = reader.pictureFacts();
    const PictureCheck check =
        compareWith(said.planes.at(frame), static_cast<std::int64_t>(frame), reader.picture(),
                    {coded.quantiser, coded.coarsestQuantiser});
    double largest = 0;
    for (const MeasureRow& row : kMeasures) {
      largest = std::max(largest, check.measured.*row.value / check.bound.*row.value);
    }
    smallest = std::min(smallest, largest);
  }
  return smallest;
}

class OtherLetters : public ::testing::TestWithParam<Coding> {};

TEST_P(OtherLetters, AreNoticedInEachPicture) {
  const Captioned said("It lasts 3.6 s", GetParam());
  EXPECT_LT(smallestExcess(said, said, GetParam()), 1);
  for (const char* other : {"It lasts 8.6 s", "It lasts 3.8 s", "It lasts 3 6 s"}) {
    const Captioned shown(other, GetParam());
    const double excess = smallestExcess(shown, said, GetParam());
    std::cout << GetParam().size << " " << GetParam().preset << " " << GetParam().crf << " "
              << other << " " << excess << "\n";
    EXPECT_GT(excess, 1) << other;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, OtherLetters,
                         ::testing::Values(Coding{"[640, 360]", "book"},      // measured 2.40
                                           Coding{"[640, 360]", "book", 24},  // measured 1.28
                                           Coding{"[640, 360]", "veryslow"},  // measured 1.30
                                           Coding{"[640, 360]", "book", 18,
                                                  VideoFormat::WebM},             // measured 1.47
                                           Coding{"[1280, 720]", "book", 24},     // measured 2.68
                                           Coding{"[1280, 720]", "veryslow", 24}  // measured 1.74
                                           ));

}  // namespace
}  // namespace rotatebook::pipeline
