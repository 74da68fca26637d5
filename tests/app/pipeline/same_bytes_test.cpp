// A render's files are the same in bytes, however its work is shared out.
#include "base/same_bytes.h"

#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "image/png_file.h"
#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "store/clip_record.h"
#include "store/encoding.h"
#include "timeline/trajectory_csv.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using rotatebook::testing::Files;
using rotatebook::testing::sameBytes;
using rotatebook::testing::sameFiles;
using testing::bytesOf;
using testing::emptyFolder;
using testing::pngAndMp4;
using testing::smallScene;

/// Bytes by path within `folder`.
Files filesIn(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[entry.path().lexically_relative(folder).string()] = bytesOf(entry.path());
    }
  }
  return files;
}

/// One after the other on one thread, each step in the plainest way.
void renderSerially(const scene::Scene& scene, const std::string& record, const fs::path& folder) {
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  picture::FrameDrawer drawer(scene, motion);
  fs::create_directories(folder / "small");
  video::VideoWriter writer(video::VideoFormat::Mp4, folder / "small.mp4",
                            store::videoSettings(scene, record));
  image::Image picture = drawer.makePicture();
  for (std::int64_t frame = 0; frame < motion.frameCount(); ++frame) {
    drawer.draw(frame, picture);
    image::PngWriter().write(folder / "small" / store::frameName(frame), picture.view());
    writer.write(picture.view());
  }
  writer.finish();
}

void rendersTheSame(const scene::Scene& scene) {
  const fs::path folder = emptyFolder();
  const auto rendered = [&](int threads) {
    const fs::path into = folder / ("threads-" + std::to_string(threads));
    testing::render(scene, {.folder = into,
                            .outputs = {pngOutput(threads), videoOutput(video::VideoFormat::Mp4)}});
    return filesIn(into);
  };
  const Files one = rendered(1);
  EXPECT_EQ(one.size(),
            19U);  // 12 frames and 3 files that tell of them, clip, poster, table, result
  EXPECT_TRUE(sameFiles(rendered(2), one));
  EXPECT_TRUE(sameFiles(rendered(7), one));
  const std::string record =
      store::recordOfVideo(one.at("small/scene.toml"), video::ffmpegVersion());
  renderSerially(scene, record, folder / "serial");
  for (const auto& [name, bytes] : filesIn(folder / "serial")) {
    EXPECT_TRUE(sameBytes(bytes, one.at(name))) << name;
  }
}

TEST(SameBytes, WithAnyNumberOfThreads) {
  rendersTheSame(smallScene());
}

/// Of the frames that a render hands to its caller's own sink.
std::map<std::int64_t, std::string> checksumsOf(const scene::Scene& scene, int threads) {
  HashSink sink;
  testing::render(scene, {.folder = emptyFolder(), .outputs = {sinkOutput(sink, threads)}});
  return sink.checksums();
}

TEST(SameBytes, OfPicturesInTheCallersOwnSink) {
  const timeline::ClipMotion motion = timeline::simulateScene(smallScene());
  picture::FrameDrawer drawer(smallScene(), motion);
  image::Image picture = drawer.makePicture();
  HashSink serial;
  for (std::int64_t frame = 0; frame < motion.frameCount(); ++frame) {
    drawer.draw(frame, picture);
    serial.write(frame, picture.view());
  }
  const auto one = checksumsOf(smallScene(), 1);
  EXPECT_EQ(one, serial.checksums());
  EXPECT_EQ(checksumsOf(smallScene(), 4), one);
  EXPECT_NE(checksumsOf(smallScene({"initial.angular_velocity=[5, 3, 1.01]"}), 1), one);
}

TEST(SameBytes, OfALargerPictureWithOverlays) {
  rendersTheSame(smallScene({"clip.size=[640, 360]", "overlay.show=['caption', 'axes', 'energy']",
                             "camera.position=[0, 0, 0.8]"}));
}

TEST(SameBytes, WithSupersamplingAndABlurredBook) {
  rendersTheSame(smallScene({"look.supersample=2", "look.motion_blur=2"}));
}

TEST(SameBytes, OfAnotherSceneAreOthers) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder / "a"));
  testing::render(smallScene({"initial.angular_velocity=[5, 3, 1.01]"}), pngAndMp4(folder / "b"));
  const auto a = filesIn(folder / "a"), b = filesIn(folder / "b");
  for (const char* name : {"small.csv", "small.mp4", "small/frame_00011.png"}) {
    EXPECT_NE(a.at(name), b.at(name)) << name;
  }
}

// Checks the message of a failure of the others.
TEST(SameBytes, NameTheFirstDifferenceOfEachFile) {
  const Files expected{{"a.csv", "t,x\n1,2\n3,4\n"}, {"b.png", {"\0\1\2", 3}}, {"c", "same"}};
  EXPECT_TRUE(sameFiles(expected, expected));
  const auto words = [&](const Files& found) {
    return std::string(sameFiles(found, expected).message());
  };
  EXPECT_EQ(words({{"a.csv", "t,x\n1,2\n3,5\n"}, {"b.png", {"\0\1\xff", 3}}, {"c", "same"}}),
            "files differ:\n  a.csv: line 3 is \"3,5\", not \"3,4\"\n"
            "  b.png: byte 2 is 0xff, not 0x02");
  EXPECT_EQ(words({{"a.csv", "t,x\n1,2\n3,4\n"}, {"b.png", {"\0\1", 2}}, {"d", "same"}}),
            "files differ:\n  b.png: it ends at byte 2 of 3\n  c: it is missing\n"
            "  d: it shouldn't be there");
  EXPECT_EQ(words({{"a.csv", "t,x\n1,2\n3,4\n"}, {"b.png", {"\0\1\2\3", 4}}, {"c", "same"}}),
            "files differ:\n  b.png: it goes on at byte 3, where it should end");
}

}  // namespace
}  // namespace rotatebook::pipeline
