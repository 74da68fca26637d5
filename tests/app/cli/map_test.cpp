// `rotatebook map`: files, refusals, interrupts.
#include <csignal>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr const char* kMap = R"(title = "Turns"
book.color = "#2b5d8a"
simulation.integrator = "euler"
[initial]
angular_velocity = [8.0, 0.0, 0.0]
tilt = [0.01, "z"]
[map]
x = { key = "simulation.substeps", from = 1, to = 9 }
y = { key = "initial.tilt.0", from = 1e-4, to = 1, scale = "log" }
measure = "half_turns"
duration = 2
size = [80, 50]
marks = [{ at = [5, 0.01], label = "here" }]
expect = [{ of = "largest", min = 1, max = 999 }]
)";

// Takes many seconds on one thread.
constexpr const char* kLong = "map.duration=400";

class MapCommand : public ProgramTest {
 protected:
  MapCommand() { write("turns.toml", kMap); }

  void expectRefused(const std::vector<std::string>& options, const std::string& message) const {
    std::vector<std::string> arguments{"map", "turns.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.error, StartsWith("rotatebook: " + message));
    EXPECT_THAT(files(), ElementsAre("turns.toml"));
  }
};

TEST_F(MapCommand, WritesPicturesValuesAndAxesWithoutGraphics) {
  const ChildResult result = runWithoutGraphics({"map", "turns.toml"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(
      result.output,
      AllOf(StartsWith("turns: Turns\n  4000 runs: values from 0 to "),
            HasSubstr("\n  here at [5, 0.01]: "),
            HasSubstr("\n  met      largest value: expected at least 1, at most 999; measured "),
            EndsWith("\n  wrote out/turns.png, out/turns.svg, out/turns.pdf, "
                     "out/turns.plain.png, out/turns.npy, out/turns.json and out/turns.csv\n")));
  EXPECT_THAT(files(), ElementsAre("out/", "out/turns.csv", "out/turns.json", "out/turns.npy",
                                   "out/turns.pdf", "out/turns.plain.png", "out/turns.png",
                                   "out/turns.svg", "turns.toml"));
  EXPECT_EQ(image::readPng(folder() / "out/turns.plain.png").height(), 50);
  EXPECT_EQ(countOf("\n", read("out/turns.csv")), 4001);
}

TEST_F(MapCommand, SaysWhatIsUnmet) {
  const ChildResult result =
      run({"map", "turns.toml", "--set", "map.expect=[{of='largest', max=0}]"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output,
              HasSubstr("\n  not met  largest value: expected at most 0; measured "));
  EXPECT_TRUE(has("out/turns.png"));
}

TEST_F(MapCommand, PrintsJson) {
  const ChildResult result = run({"map", "turns.toml", "--json"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output,
              AllOf(StartsWith("{\"interrupted\":false,\"maps\":[{\"name\":\"turns\""),
                    HasSubstr("\"facts\":{\"runs\":4000,\"with_value\":4000,\"never\":0"),
                    HasSubstr("\"quantity\":\"largest value\""), EndsWith("}]}]}\n")));
}

TEST_F(MapCommand, MakesAFilmOfTheMapThatHasOne) {
  expectRefused({"--film"}, "turns: map.film, the part of the map to zoom into, is missing; ");
  const ChildResult result =
      runWithoutGraphics({"map", "turns.toml", "--film", "--set", "map.colors={from=0, to=9}",
                          "--set", "map.film={x=[2, 3], duration='0.2 s'}"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "turns: Turns\n  wrote out/turns.film.mp4\n");
  EXPECT_THAT(files(), ElementsAre("out/", "out/turns.film.mp4", "turns.toml"));
  const ChildResult verified = run({"verify", "out/turns.film.mp4"});
  EXPECT_EQ(verified.status, 2) << "a film of a map is no clip of a scene";
}

TEST_F(MapCommand, GoesOnAfterBeingKilled) {
  ASSERT_EQ(run({"map", "turns.toml", "--set", kLong, "-o", "whole"}).status, 0);
  ChildSettings settings;
  settings.signal = SIGKILL;
  settings.signalWhen = [this] { return has("out/turns.tiles/tile_1"); };
  EXPECT_EQ(run({"map", "turns.toml", "--set", kLong, "--threads", "1"}, settings).status, 137);
  EXPECT_FALSE(has("out/turns.npy"));
  EXPECT_THAT(run({"map", "turns.toml", "--set", kLong}).error, HasSubstr("go on with --resume"));
  const ChildResult result = run({"map", "turns.toml", "--set", kLong, "--resume"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr(" of 6 tiles of an earlier run\n"));
  EXPECT_EQ(expectSameFiles("whole", "out"), 7);
}

TEST_F(MapCommand, StopsWhenItIsInterrupted) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalWhen = [this] { return has("out/turns.tiles/tile_0"); };
  const ChildResult result = run({"map", "turns.toml", "--set", kLong, "--threads", "1"}, settings);
  EXPECT_EQ(result.status, 130) << result.error;
  EXPECT_THAT(result.output,
              HasSubstr(" of 6 tiles are in out/turns.tiles; go on with --resume\n"));
  EXPECT_FALSE(has("out/turns.npy"));
}

TEST_F(MapCommand, RefusesWhatIsWrongBeforeItWrites) {
  write("plain.toml", kTiny);
  const ChildResult plain = run({"map", "plain.toml"});
  EXPECT_EQ(plain.status, 2);
  EXPECT_THAT(plain.error, HasSubstr("plain.toml: the scene has no [map]"));
  std::filesystem::remove(folder() / "plain.toml");
  expectRefused({"--set", "map.x.key=simulation.stride"},
                "--set map.x.key=simulation.stride: there is no key simulation.stride");
  expectRefused({"--set", "map.x.to=0.5"}, "turns.toml:8:43: map.x runs from 1.0 to 0.5");
  expectRefused({"--set", "map.y.from=0"}, "--set map.y.from=0: map.y is logarithmic");
  expectRefused({"--set", "map.size=[16384, 16384]"},
                "--set map.size=[16384, 16384]: map.size asks");
  expectRefused({"--set", "map.measure=centre_drift"},
                "--set map.measure=centre_drift: map.measure");
  expectRefused({"--set", "title=\xe4\xb8\xad"}, "");
  expectRefused({"--threads", "0"}, "");
}

TEST_F(MapCommand, ReplacesValuesOfOtherSettingsOnlyIfTold) {
  ASSERT_EQ(run({"map", "turns.toml"}).status, 0);
  const std::vector<std::string> other{"map", "turns.toml", "--set", "map.duration=1"};
  const ChildResult refused = run(other);
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.error, HasSubstr("replace them with --overwrite"));
  std::vector<std::string> overwriting = other;
  overwriting.push_back("--overwrite");
  EXPECT_EQ(run(overwriting).status, 0);
}

TEST_F(MapCommand, NeverReplacesWhatItIsMadeFromOrAClipsTable) {
  write("out.toml", kMap);
  std::filesystem::create_directories(folder() / "links");
  std::filesystem::create_symlink("../out.toml", folder() / "links/out.json");
  const ChildResult linked = run({"map", "out.toml", "-o", "links"});
  EXPECT_EQ(linked.status, 2);
  EXPECT_THAT(linked.error, HasSubstr("is the scene itself and would be replaced"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
