#include "pipeline/disk_space.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::emptyFolder;

// Larger than the other tests' clips, of which headers are the most part.
TEST(DiskSpace, IsAboutWhatARenderTakes) {
  constexpr double kLeast = 0.7, kMost = 2;  // measured 0.81
  const fs::path folder = emptyFolder();
  const scene::Scene scene = testing::smallScene({"clip.size=[640, 360]"});
  const std::vector formats{video::VideoFormat::Mp4, video::VideoFormat::Gif};
  testing::render(scene, {.folder = folder, .formats = formats});
  double taken = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) taken += static_cast<double>(entry.file_size());
  }
  const double needed = diskSpace(scene, scene.clip.frameCount(), true, formats, folder).needed;
  EXPECT_GT(needed / taken, kLeast);
  EXPECT_LT(needed / taken, kMost);
}

TEST(DiskSpace, GrowsWithFramesAndFormats) {
  const auto needed = [](std::int64_t frames, bool png,
                         const std::vector<video::VideoFormat>& formats) {
    return diskSpace(testing::smallScene(), frames, png, formats, "/").needed;
  };
  EXPECT_EQ(needed(20, true, {}), 2 * needed(10, true, {}));
  EXPECT_GT(needed(10, true, {}), needed(10, false, {video::VideoFormat::Gif}));
  EXPECT_EQ(needed(10, false, {}), 0);
}

TEST(DiskSpace, TellsWhatIsFree) {
  EXPECT_EQ(diskSpace(testing::smallScene(), 1, true, {}, "/proc").free, 0);
  EXPECT_THROW(diskSpace(testing::smallScene(), 1, true, {}, "/nonexistent"), MachineError);
}

}  // namespace
}  // namespace rotatebook::pipeline
