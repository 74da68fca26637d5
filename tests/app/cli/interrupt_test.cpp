// A render that is stopped half-way.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"
#include "video/decoded_video.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Longer than any machine takes to draw the frame after which the signal comes.
constexpr const char* kLong = "clip.duration=200";
constexpr int kLongFrames = 12'000;

class Interrupt : public ProgramTest {
 protected:
  /// Runs a long render, and sends `signal` once `file` is there.
  ChildResult interrupt(int signal, const std::string& file,
                        const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"render", "tiny.toml", "--set",
                                       kLong,    "--set",     "simulation.substeps=1"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    ChildSettings settings;
    settings.signal = signal;
    settings.signalWhen = [this, file] { return has(file); };
    return run(arguments, settings);
  }
};

TEST_F(Interrupt, LeavesWholeFramesAndAPlayableClip) {
  const ChildResult result = interrupt(SIGINT, "out/tiny.partial/frame_00005.png", {});
  EXPECT_EQ(result.status, 130) << result.error;
  int pictures = 0;
  for (const std::string& name : files()) {
    EXPECT_THAT(name, Not(HasSubstr(".rotatebook-")));
    if (!name.ends_with(".png")) continue;
    ++pictures;
    EXPECT_NO_THROW(image::readPng(folder() / name)) << name;
  }
  EXPECT_GE(pictures, 6);
  EXPECT_LT(pictures, kLongFrames);
  EXPECT_FALSE(has("out/tiny.mp4"));
  const auto clip = video::testing::decodeVideo(folder() / "out/tiny.partial.mp4");
  EXPECT_EQ(static_cast<int>(clip.frames.size()), pictures);
  EXPECT_THAT(
      result.output,
      HasSubstr("\n  wrote out/tiny.partial.mp4 and " + std::to_string(pictures) +
                " frames in out/tiny.partial/\n  interrupted after " + std::to_string(pictures) +
                " frames; go on with the same command and --resume\n"));
}

TEST_F(Interrupt, TerminationHasAStatusOfItsOwn) {
  EXPECT_EQ(interrupt(SIGTERM, "out/tiny.partial/frame_00002.png", {"--no-mp4"}).status, 143);
  EXPECT_TRUE(has("out/tiny.partial/frame_00002.png"));
}

TEST_F(Interrupt, HasTheStatusOfARetryIfAsked) {
  for (const int signal : {SIGTERM, SIGINT}) {
    std::filesystem::remove_all(folder() / "out");
    const ChildResult result =
        interrupt(signal, "out/tiny.partial/frame_00002.png", {"--no-mp4", "--retry-status"});
    EXPECT_EQ(result.status, 75);
    EXPECT_THAT(result.output, HasSubstr("go on with the same command and --resume"));
  }
}

TEST_F(Interrupt, ByATerminalThatIsClosedHasOneToo) {
  EXPECT_EQ(interrupt(SIGHUP, "out/tiny.partial/frame_00002.png", {"--no-mp4"}).status, 129);
  EXPECT_TRUE(has("out/tiny.partial/frame_00002.png"));
}

TEST_F(Interrupt, BySignalsThatAreIgnoredIsNone) {
  ChildSettings settings;
  settings.ignoredSignal = SIGHUP;
  settings.signal = SIGHUP;
  settings.signalWhen = [this] { return has("out/tiny.partial/frame_00002.png"); };
  EXPECT_EQ(run({"render", "tiny.toml", "--set", "clip.duration=2"}, settings).status, 0);
}

TEST_F(Interrupt, StopsTheScenesThatFollow) {
  write("b.toml", kTiny);
  const std::vector<std::string> oneAtATime{"b.toml", "--no-mp4", "-j", "1"};
  EXPECT_EQ(interrupt(SIGINT, "out/tiny.partial/frame_00002.png", oneAtATime).status, 130);
  EXPECT_FALSE(has("out/b.csv"));
  EXPECT_FALSE(has("out/b.partial"));
}

// A frame of these steps takes some 30 ms, the whole motion minutes.
TEST_F(Interrupt, EndsASimulationThatTakesLong) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalWhen = [start = std::chrono::steady_clock::now()] {
    return std::chrono::steady_clock::now() - start > std::chrono::seconds(3);
  };
  const ChildResult result = run(
      {"render", "tiny.toml", "--set", "clip.duration=100", "--set", "simulation.substeps=1000000"},
      settings);
  EXPECT_EQ(result.status, 130);
  EXPECT_EQ(result.output, "tiny: interrupted while simulating; nothing was written\n");
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Interrupt, FinishedRenderReplacesThePart) {
  interrupt(SIGINT, "out/tiny.partial/frame_00005.png", {});
  EXPECT_TRUE(has("out/tiny.partial.mp4"));
  const ChildResult refused = run({"render", "tiny.toml"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.error,
              HasSubstr("had other settings: clip.duration is 200.0 there, 0.2 here"));
  EXPECT_THAT(refused.error, HasSubstr("; render again with --overwrite, or into another folder"));
  EXPECT_EQ(run({"render", "tiny.toml", "--overwrite"}).status, 0);
  EXPECT_FALSE(has("out/tiny.partial.mp4"));
  EXPECT_TRUE(has("out/tiny.mp4"));
  EXPECT_FALSE(has("out/tiny.partial"));
  EXPECT_FALSE(has("out/tiny/frame_00012.png"));
}

class Killed : public ProgramTest {
 protected:
  ChildResult render(const std::string& folder, std::vector<std::string> options,
                     ChildSettings settings = {}) const {
    options.insert(options.begin(),
                   {"render", "tiny.toml", "--set", "clip.duration=2", "-o", folder});
    return run(options, std::move(settings));
  }
  /// Kills a render once it has made a frame.
  void kill(const std::string& folder) const {
    ChildSettings settings;
    settings.signal = SIGKILL;
    settings.signalWhen = [this, folder] { return has(folder + "/tiny.partial/frame_00020.png"); };
    EXPECT_EQ(render(folder, {}, settings).status, 128 + SIGKILL);
  }
};

TEST_F(Killed, RenderGoesOnToTheSameFiles) {
  render("whole", {});
  kill("killed");
  EXPECT_FALSE(has("killed/tiny.mp4"));
  const ChildResult result = render("killed", {"--resume"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, ContainsRegex("\n  kept [0-9]+ frames of an earlier run\n  wrote "));
  EXPECT_EQ(expectSameFiles("whole", "killed"), 120 + 7);
}

TEST_F(Killed, RenderThatIsDoneIsSkipped) {
  render("out", {});
  const ChildResult result = render("out", {"--resume"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(withoutDistances(result.output), "tiny: already done\n");
}

TEST_F(Killed, RenderIsNotContinuedWithOtherSettings) {
  kill("out");
  const ChildResult result = render("out", {"--resume", "--set", "body.mass=2"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, HasSubstr("and had other settings: body.mass is 1.0 there, 2.0 here; "
                                      "render again with --overwrite"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
