// Pictures on the standard output, as other programs take them from a pipe.
#include <cstdlib>
#include <numeric>
#include <string>
#include <sys/wait.h>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"
#include "video/decoded_video.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using video::testing::DecodedFrame;

class StreamOfPictures : public ProgramTest {
 protected:
  /// Returns the standard output of a render to it; expects that it leaves no file.
  std::string streamed(std::vector<std::string> arguments, ChildSettings settings = {}) const {
    arguments.insert(arguments.begin(), {"render", "tiny.toml", "-o", "-"});
    const ChildResult result = run(arguments, std::move(settings));
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_THAT(files(), IsEmpty());
    return result.output;
  }

  /// Returns the status of a line of the shell's, run in the folder.
  int shell(const std::string& line) const {
    const std::string program = "rotatebook() { '" ROTATEBOOK_PROGRAM "' \"$@\"; }; ";
    ChildSettings settings;
    settings.folder = folder();
    return runChild("/bin/bash", {"-c", program + line}, settings).status;
  }

  /// Returns the rows of the frames that a render left, from the top.
  std::string rowsOfFrames() const {
    std::string rows;
    for (int i = 0; i < 12; ++i) {
      const std::string number = std::to_string(100000 + i).substr(1);
      const image::Image frame =
          image::readPng(folder() / "out/tiny" / ("frame_" + number + ".png"));
      const auto size = static_cast<std::size_t>(frame.width() * bytesPerPixel(frame.format()));
      for (int y = 0; y < frame.height(); ++y)
        rows.append(reinterpret_cast<const char*>(frame.row(y)), size);
    }
    return rows;
  }
};

/// Returns the mean difference of two planes. [of 255]
double offBy(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b.at(i));
  return sum / static_cast<double>(a.size());
}

TEST_F(StreamOfPictures, HasTheSameBytesWithoutWideVectors) {
  ChildSettings settings;
  const std::vector<std::string> scene{"--format", "raw", "--set",
                                       "overlay.show=[\"axes\",\"clock\"]"};
  const std::string widest = streamed(scene, settings);
  settings.environment = {{"ROTATEBOOK_NO_AVX2", "1"}};
  EXPECT_TRUE(streamed(scene, settings) == widest);
}

TEST_F(StreamOfPictures, HasTheColoursOfTheMp4AsY4m) {
  const ChildResult result = run({"render", "tiny.toml", "-o", "-"});
  ASSERT_EQ(result.status, 0) << result.error;
  write("a.y4m", result.output);
  ASSERT_EQ(run({"render", "tiny.toml", "-o", "a.mp4", "--set", "video.crf=1"}).status, 0);
  const auto stream = video::testing::decodeVideo(folder() / "a.y4m");
  const auto mp4 = video::testing::decodeVideo(folder() / "a.mp4");
  EXPECT_EQ(stream.pixelFormat, mp4.pixelFormat);
  EXPECT_EQ(stream.range, mp4.range);
  EXPECT_EQ(stream.chromaLocation, mp4.chromaLocation);
  ASSERT_EQ(stream.frames.size(), mp4.frames.size());
  double luma = 0, chroma = 0;
  for (std::size_t i = 0; i < stream.frames.size(); ++i) {
    const DecodedFrame &a = stream.frames[i], &b = mp4.frames[i];
    luma = std::max(luma, offBy(a.y, b.y));
    chroma = std::max({chroma, offBy(a.u, b.u), offBy(a.v, b.v)});
  }
  EXPECT_LT(luma, 0.3);    // measured 0.142
  EXPECT_LT(chroma, 0.3);  // measured 0.168
}

TEST_F(StreamOfPictures, IsTheFilesOfTheFramesAsPngs) {
  const std::string pngs = streamed({"--format", "png"});
  ASSERT_EQ(run({"render", "tiny.toml", "--no-mp4"}).status, 0);
  ASSERT_EQ(shell("cat out/tiny/frame_*.png > all.pngs"), 0);
  EXPECT_EQ(pngs, read("all.pngs"));
}

TEST_F(StreamOfPictures, IsRowsOfPixelsAsRaw) {
  const std::string opaque = streamed({"--format", "raw"});
  const std::vector<std::string> transparent{"--set", "look.background=\"transparent\""};
  const std::string rgba = streamed({"--format", "raw", transparent.front(), transparent.back()});
  EXPECT_EQ(opaque.size(), 12U * 64 * 36 * 3);
  EXPECT_EQ(rgba.size(), 12U * 64 * 36 * 4);
  ASSERT_EQ(run({"render", "tiny.toml", "--no-mp4"}).status, 0);
  EXPECT_TRUE(opaque == rowsOfFrames());
  ASSERT_EQ(run({"render", "tiny.toml", "--no-mp4", "--overwrite", transparent.front(),
                 transparent.back()})
                .status,
            0);
  EXPECT_TRUE(rgba == rowsOfFrames());
}

TEST_F(StreamOfPictures, HasTheSameBytesForAnyNumberOfThreads) {
  for (const char* format : {"y4m", "png", "raw"}) {
    ChildSettings one, four;
    one.environment = {{"LP_NUM_THREADS", "1"}};
    four.environment = {{"LP_NUM_THREADS", "4"}};
    EXPECT_TRUE(streamed({"--format", format}, one) == streamed({"--format", format}, four))
        << format;
  }
}

TEST_F(StreamOfPictures, TakesFramesAndScenesFromAPipeAndReportsAside) {
  const ChildResult result =
      run({"render", "tiny.toml", "-o", "-", "--format", "raw", "--frames", "3:5"});
  EXPECT_EQ(result.output, streamed({"--format", "raw"}).substr(3 * 6912, 2 * 6912));
  EXPECT_THAT(result.error, StartsWith("tiny: wrote 2 frames to the standard output\n"));
  EXPECT_EQ(shell("rotatebook render - -q -o - < tiny.toml > piped 2> said"), 0);
  EXPECT_EQ(read("said"), "");
  EXPECT_EQ(run({"render", "tiny.toml", "-o", "-"}).output, read("piped"));
  const ChildResult unmet =
      run({"render", "tiny.toml", "-o", "-", "--set", "expect.half_turns={ min = 9 }"});
  EXPECT_EQ(unmet.status, 1);
  EXPECT_EQ(unmet.output, read("piped"));
  EXPECT_THAT(unmet.error, AllOf(HasSubstr("\n  not met  half_turns"),
                                 HasSubstr("rotatebook: expectations are not met\n")));
}

TEST_F(StreamOfPictures, WaitsForASlowReader) {
  const std::string render = "rotatebook render tiny.toml -q -o - --set clip.duration=2";
  EXPECT_EQ(shell(render + " | (sleep 0.5; cat) > slow; exit ${PIPESTATUS[0]}"), 0);
  ASSERT_EQ(shell(render + " > file"), 0);
  EXPECT_TRUE(read("slow") == read("file"));
}

TEST_F(StreamOfPictures, EndsWithItsReader) {
  // Longer than a pipe holds.
  const std::string render = "rotatebook render tiny.toml -o - --set clip.duration=2";
  EXPECT_EQ(shell(render + " 2> said | head -c 1000 > start; exit ${PIPESTATUS[0]}"), 141);
  EXPECT_EQ(read("said"), "");
  EXPECT_THAT(read("start"), StartsWith("YUV4MPEG2 W64 H36 F60:1 "));
  EXPECT_EQ(
      shell("trap '' PIPE; " + render + " 2> said | head -c 1 > start; exit ${PIPESTATUS[0]}"), 3);
  EXPECT_EQ(read("said"), "rotatebook: can't write the standard output: Broken pipe\n");
  EXPECT_EQ(shell(render + " 2> said > /dev/full"), 3);
  EXPECT_EQ(read("said"), "rotatebook: can't write the standard output: No space left on device\n");
  EXPECT_THAT(files(), ElementsAre("said", "start"));
}

TEST_F(StreamOfPictures, MayBeTriedAgainAfterAnInterrupt) {
  // The pipe has a reader, which takes no more, so that the render isn't done before the signal.
  const auto interrupted = [&](const std::string& options) {
    return shell("mkfifo pipe; '" ROTATEBOOK_PROGRAM
                 "' render tiny.toml -q -o - --set clip.duration=2 " +
                 options +
                 " > pipe & exec 3< pipe; head -c 1 <&3; kill $!; wait $!; status=$?; rm pipe; "
                 "exit $status");
  };
  EXPECT_EQ(interrupted("--retry-status"), 75);
  EXPECT_EQ(interrupted(""), 143);
}

}  // namespace
}  // namespace rotatebook::cli::testing
