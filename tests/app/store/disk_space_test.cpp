#include "store/disk_space.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "pipeline/small_clip.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::emptyFolder;
using video::VideoFormat;

constexpr double kBlock = 4096;  // [bytes]

/// The book with its covers, which weigh more than plain cloth.
scene::Scene coveredScene(const std::vector<std::string>& overrides = {}) {
  return scene::testing::smallScene(overrides);
}

/// Returns the space that the files below `folder` take, in whole blocks. [bytes]
double takenIn(const fs::path& folder) {
  double taken = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    taken += kBlock * std::ceil(static_cast<double>(entry.file_size()) / kBlock);
  }
  return taken;
}

/// Returns the space that a render is expected to need, with the files that it begins with, over
/// the space that it takes.
double ratio(const scene::Scene& scene, const pipeline::RenderOptions& options) {
  double needed = 0;
  const pipeline::RenderListener listener{
      [&](const pipeline::RenderStart& start) { needed = start.space.needed; }, {}};
  const double before = takenIn(options.folder);
  pipeline::renderClip(scene, timeline::simulateScene(scene), options, listener);
  return needed / (takenIn(options.folder) - before);
}

TEST(DiskSpace, IsAboutWhatARenderTakes) {
  constexpr double kMin = 0.8, kMax = 1.8;  // measured 1.0 to 1.3
  for (const auto& [size, duration] :
       {std::pair{"[16, 16]", "0.1"}, {"[96, 54]", "1"}, {"[320, 180]", "0.5"}}) {
    for (const bool png : {true, false}) {
      const scene::Scene scene = coveredScene(
          {std::string("clip.size=") + size, std::string("clip.duration=") + duration});
      const double found =
          ratio(scene, {.folder = emptyFolder(),
                        .outputs = pipeline::outputsOf(png, {video::VideoFormat::Mp4})});
      EXPECT_GT(found, kMin) << size << ", PNGs: " << png;
      EXPECT_LT(found, kMax) << size << ", PNGs: " << png;
    }
  }
}

TEST(DiskSpace, CountsTheCaption) {
  constexpr double kMin = 0.8, kMax = 1.6;  // measured 1.05 to 1.58
  for (const std::size_t letters : {0, 200}) {
    std::string caption;
    while (caption.size() < letters) caption += "A book turns ";
    for (const char* size : {"[96, 54]", "[160, 90]", "[320, 180]"}) {
      scene::Scene scene = coveredScene({std::string("clip.size=") + size, "clip.duration=1",
                                         "overlay.show=['caption', 'clock']"});
      scene.caption = caption;
      const double found = ratio(scene, {.folder = emptyFolder(),
                                         .outputs = pipeline::outputsOf(true, {VideoFormat::Mp4})});
      EXPECT_GT(found, kMin) << size << ' ' << letters;
      EXPECT_LT(found, kMax) << size << ' ' << letters;
    }
  }
}

TEST(DiskSpace, CountsEveryFormat) {
  constexpr double kMin = 0.8, kMax = 1.8;  // measured 1.0 to 1.5
  for (const VideoFormat format : video::kVideoFormats) {
    const double found =
        ratio(coveredScene({"clip.size=[320, 180]"}),
              {.folder = emptyFolder(), .outputs = pipeline::outputsOf(false, {format})});
    EXPECT_GT(found, kMin) << nameOf(format);
    EXPECT_LT(found, kMax) << nameOf(format);
  }
}

// Each panel has a table.
TEST(DiskSpace, CountsEveryTable) {
  constexpr double kMin = 0.8, kMax = 1.8;  // measured 1.1
  const scene::Scene scene = scene::parseScene(
      "[initial]\nangular_velocity = [5, 3, 1]\n"
      "[clip]\nsize = [64, 36]\nfps = 24\nduration = 2\n"
      "[[panel]]\nlabel = \"a\"\n[[panel]]\nlabel = \"b\"\n[[panel]]\nlabel = \"c\"\n",
      "panels.toml");
  const double found = ratio(
      scene,
      {.folder = emptyFolder(), .outputs = pipeline::outputsOf(false, {video::VideoFormat::Mp4})});
  EXPECT_GT(found, kMin);
  EXPECT_LT(found, kMax);
}

TEST(DiskSpace, CountsNoFramesThatAreKept) {
  constexpr double kMin = 0.8, kMax = 1.8;  // measured 1.15
  const scene::Scene scene = coveredScene({"clip.size=[320, 180]"});
  pipeline::RenderOptions options{.folder = emptyFolder(),
                                  .outputs = pipeline::outputsOf(true, {VideoFormat::Gif})};
  pipeline::testing::stoppedAfter(9, scene, options);
  fs::remove(options.folder / "small.partial.gif");
  options.earlier.resume = true;
  const double found = ratio(scene, options);
  EXPECT_GT(found, kMin);
  EXPECT_LT(found, kMax);
}

TEST(DiskSpace, OfAPartCountsNoFramesBesideIt) {
  const scene::Scene scene = coveredScene();
  pipeline::RenderOptions options{.folder = emptyFolder(), .outputs = {pipeline::pngOutput()}};
  const auto neededBy = [&](FrameRange range) {
    double needed = 0;
    const pipeline::RenderListener listener{
        [&](const pipeline::RenderStart& start) { needed = start.space.needed; }, {}};
    options.frames = range;
    pipeline::renderClip(scene, timeline::simulateScene(scene), options, listener);
    return needed;
  };
  const auto neededFor = [&](std::int64_t pngs, std::int64_t frames) {
    return diskSpace(scene, {.pngs = pngs, .frames = frames}, options.folder).needed;
  };
  EXPECT_EQ(neededBy({1, 2}), neededFor(1, 1));
  EXPECT_EQ(neededBy({5, 6}), neededFor(1, 1));
  options.earlier.resume = true;
  EXPECT_EQ(neededBy({2, 5}), neededFor(3, 3));
  EXPECT_EQ(neededBy({0, 6}), neededFor(1, 6)) << "frame 0 alone is missing";
}

TEST(DiskSpace, GrowsWithFramesAndFormats) {
  const auto needed = [](const FilesToWrite& files) {
    return diskSpace(coveredScene(), files, "/").needed;
  };
  const double none = needed({});
  EXPECT_GT(none, 0);
  EXPECT_DOUBLE_EQ(needed({.pngs = 20}) - none, 2 * (needed({.pngs = 10}) - none));
  EXPECT_GT(needed({.pngs = 10}), needed({.frames = 10, .formats = {VideoFormat::Gif}}));
  EXPECT_EQ(needed({.frames = 10}), none);
}

TEST(DiskSpace, ReportsWhatIsFree) {
  EXPECT_EQ(diskSpace(coveredScene(), {.pngs = 1}, "/proc").free, 0);
  EXPECT_THROW(diskSpace(coveredScene(), {.pngs = 1}, "/nonexistent"), MachineError);
}

TEST(SpaceWarning, SaysHowMuchIsMissingAndWhatHelps) {
  EXPECT_EQ(spaceWarning({12.34e9, 321e6}, "out", true),
            "about 12 GB are needed in out and 321 MB are free: make room, or leave PNGs out with "
            "--no-png");
  EXPECT_EQ(spaceWarning({94'208, 0}, "out", false),
            "about 94 kB are needed in out and 0 kB are free: make room");
}

TEST(SpaceWarning, IsNoneWhereThereIsEnough) {
  EXPECT_EQ(spaceWarning({1e9, 1e9}, "out", true), "");
}

}  // namespace
}  // namespace rotatebook::store
