// Memory must not grow with the clip.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <sys/resource.h>

#include <gtest/gtest.h>

#include "image/png_file.h"
#include "picture/frame_drawer.h"
#include "pipeline/assemble.h"
#include "pipeline/fake_sinks.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;

// Largest memory of this process so far. [KiB]
long peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

constexpr std::int64_t kSome = 60;
constexpr long kPictureKib = 160 * 90 * 4 / 1024;

scene::Scene clipOf(std::int64_t frames) {
  return testing::smallScene({"clip.size=[160,90]", "clip.duration=" + std::to_string(frames),
                              "clip.fps=1", "simulation.time_per_frame=0.02"});
}

TEST(Memory, OfARenderDoesNotGrowWithTheClip) {
  const long allPictures = 9 * kSome * kPictureKib;  // What keeping the added ones would take.
  const fs::path folder = testing::emptyFolder();
  // The allocator of each thread takes a while to have all that it needs.
  for (int i = 0; i < 3; ++i) testing::render(clipOf(kSome), testing::pngAndMp4(folder));
  const long before = peakMemory();
  testing::render(clipOf(10 * kSome), testing::pngAndMp4(folder));
  EXPECT_LT(peakMemory() - before, allPictures / 2);  // measured 0.18 of all
}

/// Counts the files that this process has open.
std::ptrdiff_t openFiles() {
  return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
}

TEST(OpenFiles, OfARenderDoNotGrowWithTheClip) {
  const auto mostOpen = [](std::int64_t frames) {
    std::ptrdiff_t most = 0;
    const RenderListener listener{{}, [&](RenderProgress) { most = std::max(most, openFiles()); }};
    const scene::Scene scene = clipOf(frames);
    renderClip(scene, timeline::simulateScene(scene),
               {.folder = testing::emptyFolder(),
                .outputs = {pngOutput(1), videoOutput(video::VideoFormat::Mp4)}},
               listener);
    return most;
  };
  const std::ptrdiff_t some = mostOpen(kSome);
  EXPECT_LE(mostOpen(10 * kSome), some + 2);  // measured: the same, or one PNG on its way more
  EXPECT_GT(some, 5);
}

// Frames from elsewhere, so that no renderer has raised the peak before.
void writeFrames(const fs::path& folder, std::int64_t count) {
  fs::create_directories(folder);
  const image::Image picture(160, 90, image::PixelFormat::Rgb8);
  for (std::int64_t index = 0; index < count; ++index) {
    image::writePng(folder / store::frameName(index), picture.view());
  }
}

TEST(Memory, OfAssemblingDoesNotGrowWithTheClip) {
  const long allPictures = 9 * kSome * kPictureKib;
  const fs::path folder = testing::emptyFolder();
  writeFrames(folder / "some", kSome);
  writeFrames(folder / "many", 10 * kSome);
  assemble(folder / "some", folder / "some.mp4", FrameRate{}, {});
  const long before = peakMemory();
  assemble(folder / "many", folder / "many.mp4", FrameRate{}, {});
  EXPECT_LT(peakMemory() - before, allPictures / 2);  // measured 0.01 of all
}

TEST(Memory, HoldsAsManyPicturesForALongClip) {
  const timeline::ClipMotion motion = timeline::simulateScene(clipOf(10 * kSome));
  picture::FrameDrawer drawer(testing::smallScene(), motion);
  for (const std::int64_t count : {kSome, 10 * kSome}) {
    testing::FakeSink sink;
    drawFrames(drawer, {{0, count}}, {{sink}}, {});
    EXPECT_EQ(sink.written(), count);
    EXPECT_LE(sink.pictures().size(), 8U);
  }
}

}  // namespace
}  // namespace rotatebook::pipeline
