// `rotatebook study`: tables and plots of many runs.
#include <csignal>
#include <string>

#include "cli/program_test.h"
#include "lacking.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kFlipping = R"(title = "Flips"
[simulation]
model = "exact"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
tilt = [0.1, "z"]
[clip]
duration = 12
[study]
x = { key = "initial.tilt", values = [0.1, 0.01] }
measure = ["flip_interval", "flip_law"]
expect = [{ of = "flip_law", max = 0.001 }]
)";

class StudyCommand : public ProgramTest {
 protected:
  StudyCommand() { write("flips.toml", kFlipping); }

  /// Expects that tiny.toml with `options` is refused with `message`, and that nothing is written.
  void expectRefused(const std::vector<std::string>& options, const std::string& message) const {
    std::vector<std::string> arguments{"study", "tiny.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, "rotatebook: " + message + "\n");
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(files(), ElementsAre("flips.toml"));
  }
};

TEST_F(StudyCommand, WritesTablesAndPlotsWithoutGraphics) {
  const ChildResult result = runWithoutGraphics(
      {"study", "tiny.toml", "--steps", "1,2,4,8", "--integrators", "rk4,splitting"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(result.output,
              AllOf(StartsWith("tiny: Tiny\n  rk4              "), HasSubstr("\n  splitting  "),
                    EndsWith("\n  wrote out/tiny-study.csv, out/tiny-study.png, "
                             "out/tiny-study.svg, out/tiny-study.pdf and out/tiny-study.json\n")));
  EXPECT_THAT(files(),
              ElementsAre("flips.toml", "out/", "out/tiny-study.csv", "out/tiny-study.json",
                          "out/tiny-study.pdf", "out/tiny-study.png", "out/tiny-study.svg"));
  EXPECT_EQ(countOf("\n", read("out/tiny-study.csv")), 1 + 2 * 4);
}

TEST_F(StudyCommand, StudiesTheAxesOfTheScene) {
  const ChildResult result = run({"study", "flips.toml", "-o", "x"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("\n  0.1: flip_interval "),
                    HasSubstr("\n  met      flip_law at 0.1: expected at most 0.001; measured "),
                    EndsWith("\n  wrote x/flips-study.csv, x/flips-study.png, x/flips-study.svg, "
                             "x/flips-study.pdf and x/flips-study.json\n")));
  EXPECT_THAT(files(), ElementsAre("flips.toml", "x/", "x/flips-study.csv", "x/flips-study.json",
                                   "x/flips-study.pdf", "x/flips-study.png", "x/flips-study.svg"));
}

TEST_F(StudyCommand, LeavesTheSameBytesInAnyFolder) {
  for (const char* folder : {"x", "x/y"}) {
    ASSERT_EQ(run({"study", "flips.toml", "-o", folder}).status, 0);
  }
  for (const char* ending : {"csv", "json", "pdf", "png", "svg"}) {
    const std::string name = std::string("flips-study.") + ending;
    EXPECT_EQ(read("x/y/" + name), read("x/" + name)) << name;
  }
}

TEST_F(StudyCommand, StudiesSeveralScenes) {
  EXPECT_EQ(run({"study", "flips.toml", "tiny.toml", "--set", "clip.duration=9", "--set",
                 "study.x={ key = 'initial.tilt', values = [0.1] }", "--set",
                 "study.measure=['half_turns']", "--set", "study.expect=[]", "--set",
                 "initial.tilt=[0.1, 'z']"})
                .status,
            0);
  EXPECT_TRUE(has("out/flips-study.png"));
  EXPECT_TRUE(has("out/tiny-study.png"));
}

TEST_F(StudyCommand, FailsIfAnExpectationIsUnmet) {
  const ChildResult result = run({"study", "tiny.toml", "--steps", "1,2,4,8", "--integrators",
                                  "rk4", "--set", "study.expect=[{ of = 'order', min = 5 }]"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output,
              HasSubstr("\n  not met  order of rk4: expected at least 5; measured "));
  EXPECT_EQ(result.error, "rotatebook: expectations are not met; the files were kept\n");
  EXPECT_TRUE(has("out/tiny-study.png"));
  EXPECT_EQ(run({"study", "flips.toml", "--set", "study.expect=[{ of = 'flip_law', max = 1e-9 }]"})
                .status,
            1);
}

TEST_F(StudyCommand, RefusesBadLists) {
  const std::string steps =
      ": not a list of whole numbers; write substeps, for example "
      "1,2,4,8";
  expectRefused({"--steps", "1,x"}, "--steps 1,x" + steps);
  expectRefused({"--steps", "1,,2"}, "--steps 1,,2" + steps);
  expectRefused({"--steps", "0.5"}, "--steps 0.5" + steps);
  expectRefused({"--steps", "1,02"}, "--steps 1,02" + steps);
  expectRefused({"--steps", ""},
                "argument 4, after --steps, is empty; is it a variable that isn't set?");
  expectRefused({"--steps", "4,0"},
                "--steps 4,0: simulation.substeps must be an integer from 1 to 1000000, not 0");
  expectRefused({"--steps", "4,4"}, "--steps 4,4: study.x.values has 4 twice");
}

TEST_F(StudyCommand, RefusesIntegratorsThatTheModelDoesNotHave) {
  const std::string valid =
      "simulation.integrator must be \"euler\", \"rk4\", \"symplectic-euler\" or \"verlet\", not ";
  const std::string particles = "simulation.model=particles";
  expectRefused({"--set", particles, "--integrators", "euler,verlt"},
                "--integrators euler,verlt: " + valid + "\"verlt\"; did you mean \"verlet\"?");
  expectRefused(
      {"--set", particles, "--integrators", "dmv6"},
      "--integrators dmv6: simulation.integrator = \"dmv6\", but the model \"particles\" has "
      "\"euler\", \"rk4\", \"symplectic-euler\" and \"verlet\"");
  expectRefused({"--set", particles, "--integrators", "rk4,"},
                "--integrators rk4,: study.curves.values must be a word, not "
                "\"\"");
  expectRefused({"--set", particles, "--integrators", ""},
                "argument 6, after --integrators, is empty; is it a variable that isn't set?");
}

TEST_F(StudyCommand, RefusesScenesWithNothingToVary) {
  expectRefused({"--set", "simulation.model=exact"},
                "study tiny.toml: the model \"exact\" takes no steps, whose order [study] finds "
                "without a measure; state x and measure, or choose another model");
  expectRefused({"--set", "clip.duration=0.01"},
                "study tiny.toml: [study] takes a single sample of a motion, which shows none; "
                "raise study.duration or clip.duration");
  expectRefused({"tiny.toml"},
                "two scenes are named tiny; they would overwrite each other: render them into "
                "different folders");
}

TEST_F(StudyCommand, SaysSoIfEveryRunDiverges) {
  write("out/tiny-study.svg", "<!-- rotatebook -->\n</svg>\n");
  const ChildResult result =
      run({"study", "tiny.toml", "--steps", "1,2", "--integrators", "euler", "--set",
           "simulation.model=particles", "--set", "simulation.normalize=false"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(
      result.error,
      AllOf(StartsWith("rotatebook: tiny: no run reached its end (out/tiny-study.csv says "
                       "why), so that there is nothing to compare; the first: diverged at "),
            EndsWith(" s; take shorter steps, for example --steps 256,512,1024,2048\n")));
  EXPECT_EQ(countOf("diverged at", read("out/tiny-study.csv")), 2);
  EXPECT_FALSE(has("out/tiny-study.svg"));
}

TEST_F(StudyCommand, SaysWhatDoesNotHappen) {
  const ChildResult result =
      run({"study", "flips.toml", "--set", "clip.duration=1", "--set", "study.expect=[]"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  0.1: flip_interval not within 0.98"));
}

TEST_F(StudyCommand, RefusesLettersThatTheFontLacksBeforeItRuns) {
  expectRefused({"--set", "title=中"},
                "the font Inter lacks \"中\", which is in \"中\"; choose an installed font that "
                "has it, overlay.font = \"...\"");
}

TEST_F(StudyCommand, ShowsABarOnATerminal) {
  ROTATEBOOK_SKIP_IF_LACKING(whyNoTerminal());
  ChildSettings settings;
  settings.terminal = true;
  const ChildResult result = run({"study", "tiny.toml"}, settings);
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.error, HasSubstr("\rtiny  [################] 100 %  154/154 runs, "));
}

class InterruptedStudy : public ProgramTest, public ::testing::WithParamInterface<int> {};

TEST_P(InterruptedStudy, WritesNothing) {
  ChildSettings settings;
  settings.signal = GetParam();
  settings.signalWhen = [this] { return has("out"); };
  const ChildResult result = run({"study", "tiny.toml", "--set", "clip.duration=100", "--steps",
                                  "100,101,102,103,104", "--set", "simulation.normalize=true"},
                                 settings);
  EXPECT_EQ(result.status, 128 + GetParam());
  EXPECT_EQ(result.output, "tiny: Tiny\n  interrupted; nothing was written\n");
  EXPECT_THAT(files(), ElementsAre("out/"));
}

TEST_F(StudyCommand, IsInterruptedInTheMiddleOfARun) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalWhen = [this] { return has("out"); };
  // Ten minutes, were it not for the signal.
  const ChildResult result = run({"study", "tiny.toml", "--set", "clip.duration=100", "--steps",
                                  "1000000", "--integrators", "rk4"},
                                 settings);
  EXPECT_EQ(result.status, 130);
  EXPECT_EQ(result.output, "tiny: Tiny\n  interrupted; nothing was written\n");
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedStudy, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace rotatebook::cli::testing
