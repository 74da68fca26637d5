// Reports that --quiet holds back, and what it prints all the same.
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kUnnormalized =
    std::string(ROTATEBOOK_SOURCE) + "/scenes/figures/fig07-unnormalized.toml";

class Quiet : public ProgramTest {
 protected:
  /// Expects that the command succeeds, and prints nothing with --quiet, wherever it is.
  void expectSilent(std::vector<std::string> arguments) const {
    SCOPED_TRACE(arguments.front());
    EXPECT_THAT(run(arguments).output, Not(IsEmpty()));
    arguments.push_back("-q");
    expectNothing(run(arguments));
    arguments.pop_back();
    arguments.insert(arguments.begin(), "--quiet");
    expectNothing(run(arguments));
  }

 private:
  static void expectNothing(const ChildResult& result) {
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(result.error, IsEmpty());
  }
};

TEST_F(Quiet, ReportsArentPrinted) {
  expectSilent({"render", "tiny.toml"});
  expectSilent({"check", "tiny.toml"});
  expectSilent({"simulate", "tiny.toml", "--csv", "x.csv"});
  expectSilent({"still", "tiny.toml", "-o", "tiny.png"});
  expectSilent({"still", "tiny.toml", "--count", "1", "-o", "sheet.png"});
  expectSilent({"diff", "tiny.png", "tiny.png"});
  expectSilent({"verify", "out/tiny.mp4"});
  expectSilent({"verify", "out/tiny.mp4", "--again", "again"});
  expectSilent({"assemble", "out/tiny", "-o", "x.mp4"});
  expectSilent({"page", "tiny.toml", "--no-thumbnails"});
  expectSilent({"check", "."});
  expectSilent({"judge", "--pack", "pack"});
}

TEST_F(Quiet, ResultsArePrinted) {
  EXPECT_EQ(run({"check", "--print", "tiny.toml", "-q"}).output,
            run({"check", "--print", "tiny.toml"}).output);
  EXPECT_EQ(run({"info", "tiny.toml", "-q"}).output, run({"info", "tiny.toml"}).output);
  const std::vector<std::string> table{"simulate", "tiny.toml", "--csv", "-"};
  const ChildResult loud = run(table);
  EXPECT_THAT(loud.error, HasSubstr(" flips; "));
  const ChildResult quiet = run({"-q", "simulate", "tiny.toml", "--csv", "-"});
  EXPECT_EQ(quiet.output, loud.output);
  EXPECT_THAT(quiet.error, IsEmpty());
  run({"render", "tiny.toml", "-q"});
  EXPECT_THAT(run({"verify", "out/tiny.mp4", "--json", "-q"}).output, StartsWith("{\"clip\":"));
}

TEST_F(Quiet, NoProgressIsShown) {
  if (const std::string why = whyNoTerminal(); !why.empty()) GTEST_SKIP() << why;
  ChildSettings settings;
  settings.terminal = true;
  EXPECT_THAT(run({"render", "tiny.toml"}, settings).error, HasSubstr("12/12 frames"));
  EXPECT_THAT(run({"render", "tiny.toml", "-q"}, settings).error, IsEmpty());
}

TEST_F(Quiet, TheReasonOfAFailureIsPrinted) {
  const ChildResult unmet = run(
      {"simulate", "tiny.toml", "-q", "--set", "expect.half_turns={ min = 3 }", "--csv", "x.csv"});
  EXPECT_EQ(unmet.status, 1);
  EXPECT_THAT(unmet.output, IsEmpty());
  EXPECT_THAT(unmet.error, AllOf(HasSubstr("not met  half_turns: expected at least 3"),
                                 HasSubstr("rotatebook: expectations are not met")));
  run({"still", "tiny.toml", "--time", "0", "-o", "a.png"});
  run({"still", "tiny.toml", "--time", "0.2", "-o", "b.png"});
  const ChildResult different = run({"diff", "a.png", "b.png", "-q"});
  EXPECT_EQ(different.status, 1);
  EXPECT_THAT(different.error, HasSubstr("different: largest difference "));
}

TEST_F(Quiet, WhatIsLostAndWhatStaysIsPrinted) {
  run({"render", "tiny.toml", "--format", "mp4,gif", "--no-png"});
  const ChildResult result =
      run({"render", "tiny.toml", "--no-png", "-q", "--set", "clip.duration=0.1"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.error,
              AllOf(HasSubstr("note: tiny: replaced out/tiny.csv"),
                    HasSubstr("note: tiny: kept out/tiny.gif, made with other settings\n")));
  EXPECT_THAT(result.output, IsEmpty());
}

TEST_F(Quiet, NotesAndErrorsArePrinted) {
  const ChildResult noted =
      run({"check", "tiny.toml", "-q", "--set", "initial.angular_velocity=[500.0, 0, 0.1]"});
  EXPECT_EQ(noted.status, 0);
  EXPECT_THAT(noted.error, HasSubstr("note: tiny: "));
  const ChildResult changed = run({"simulate", kUnnormalized, "-q"});
  EXPECT_EQ(changed.status, 0);
  EXPECT_THAT(changed.error, AllOf(StartsWith("note: fig07-unnormalized: "), HasSubstr("regime")));
  const ChildResult wrong = run({"check", "tiny.toml", "other.toml", "-q"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.error, "rotatebook: other.toml: scene not found\n");
}

}  // namespace
}  // namespace rotatebook::cli::testing
