// Recorded motions: rotatebook judge and toss, and clips of recordings.
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "messages.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Recorded : public ProgramTest {
 protected:
  Recorded() {
    for (const char* name : {"mujoco", "simbody"}) copy(name, std::string(name) + ".csv");
  }

  void copy(const std::string& recording, const std::string& name) const {
    fs::copy_file(
        fs::path(ROTATEBOOK_SOURCE) / "scenes/comparisons/recordings" / (recording + ".csv"),
        folder() / name, fs::copy_options::overwrite_existing);
  }

  void writeScene(const std::string& file) const {
    write("scene.toml",
          "[body]\nsize = [0.15, 0.22, 0.04]\n[simulation]\nmodel = \"recorded\"\n"
          "file = \"" +
              file +
              "\"\n[clip]\nsize = [64, 36]\nduration = 0.2\n"
              "[overlay]\nshow = [\"ghost\"]\n");
  }

  ChildResult judge(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "judge");
    arguments.insert(arguments.end(), {"--size", "0.15,0.22,0.04", "--to", "10"});
    return runWithoutGraphics(arguments);
  }
};

TEST_F(Recorded, AreJudged) {
  const ChildResult result = judge({"mujoco.csv", "simbody.csv"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(
      result.output,
      AllOf(HasSubstr("mujoco.csv: gains energy, as with an explicit gyroscopic torque of order 1"),
            HasSubstr("energy +47.5 % at most, +47.5 % at the end; |L| +21.5 % at most"),
            HasSubstr("3 of 3 flips"), HasSubstr("simbody.csv: agrees with the exact motion")));
}

TEST_F(Recorded, AreReadFromTheStandardInput) {
  const ChildResult judged = runWords("judge - --size 0.15,0.22,0.04 --to 10 < simbody.csv");
  EXPECT_EQ(judged.status, 0) << judged.error;
  EXPECT_THAT(judged.output, HasSubstr("stdin: agrees with the exact motion\n"));
  EXPECT_THAT(runWords("judge - < simbody.csv").error,
              HasSubstr("\n  - is a scene here; a table needs --inertia or --size\n"));
  fs::copy_file(fs::path(ROTATEBOOK_SOURCE) / "docs/toss.csv", folder() / "toss.csv");
  EXPECT_THAT(runWords("toss - < toss.csv").output, HasSubstr("stdin: flight from 1.22 to 1.98 s"));
  EXPECT_EQ(
      runWords("toss - -o toss.toml < toss.csv").error,
      "rotatebook: toss.toml: a scene reads a file; save the recording, and toss that instead "
      "of -\n");
}

TEST_F(Recorded, AreJudgedByBounds) {
  const std::vector<std::string> bounds{"--max-error-deg", "1",    "--max-energy-drift", "0.01",
                                        "--max-L-drift",   "0.01", "--half-turns"};
  std::vector<std::string> arguments{"simbody.csv", "--junit", "good.xml"};
  arguments.insert(arguments.end(), bounds.begin(), bounds.end());
  EXPECT_EQ(judge(arguments).status, 0);
  EXPECT_THAT(read("good.xml"),
              AllOf(HasSubstr("<testsuite name=\"simbody.csv\" tests=\"4\" failures=\"0\">"),
                    Not(HasSubstr("<failure"))));
  arguments[0] = "mujoco.csv";
  arguments[2] = "bad.xml";
  const ChildResult result = judge(arguments);
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("  not met  energy_drift: expected at most 0.01; measured 0.4754\n"),
                    HasSubstr("  met      half_turns: expected 3 due; measured 3\n")));
  EXPECT_THAT(read("bad.xml"),
              AllOf(HasSubstr("failures=\"3\""),
                    HasSubstr("<failure message=\"at most 0.01; measured 0.4754\"/>")));
}

TEST_F(Recorded, AreJudgedAsJson) {
  const ChildResult result = judge({"simbody.csv", "--json", "--max-error-deg", "0"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(
      result.output,
      AllOf(HasSubstr("{\"met\":false,\"motions\":[{\"name\":\"simbody.csv\""),
            HasSubstr("\"half_turns_due\":3"), HasSubstr("\"bounds\":[{\"name\":\"error_deg\"")));
}

TEST_F(Recorded, NotesAndFlawsAreInJsonToo) {
  std::string table = read("simbody.csv");
  const std::size_t row = table.find("\n5,") + 1;
  table.replace(row, table.find('\n', row) - row, "5,1,0,0,0,6.28,0,0");
  table += ",,,,,,,\n";
  write("stray.csv", table);
  const ChildResult result = runWithoutGraphics(
      {"judge", "stray.csv", "--size", "0.15,0.22,0.04", "--json", "--max-error-deg", "1"});
  EXPECT_EQ(result.status, 1) << result.error;
  EXPECT_THAT(
      result.output,
      AllOf(HasSubstr("\"flaws\":[\"1 row is off its neighbours: the attitude at 5 s, by "),
            HasSubstr("\"notes\":[\"1 row at the table's ends has no reading and is left out\","
                      "\"1 row is off"),
            HasSubstr("\"rates_factor\":1.0,\"rates_bias\":[0.0,0.0,0.0]"),
            HasSubstr("but for its flaws: 1 row is off"), Not(HasSubstr("\"met\":true"))));
}

TEST_F(Recorded, AFewRowsArentJudged) {
  write("few.csv", "time_s,qw,qx,qy,qz\n0,1,0,0,0\n0.1,0.9689,0.2474,0,0\n0.2,0.8776,0.4794,0,0\n");
  const ChildResult result = runWithoutGraphics({"judge", "few.csv", "--size", "0.15,0.22,0.04"});
  EXPECT_EQ(result.status, 1) << result.error;
  EXPECT_THAT(result.output,
              HasSubstr("few.csv: not judged: 3 rows are too few to tell; record at least 12"));
}

TEST_F(Recorded, TablesThatContradictThemselvesArentJudged) {
  std::string table = read("simbody.csv");
  table.replace(table.find("wx,wy,wz"), 8, "gyrX (rad/s),gyrY (rad/s),gyrZ (rad/s)");
  write("world.csv", table);
  const ChildResult result = runWithoutGraphics(
      {"judge", "world.csv", "simbody.csv", "--size", "0.15,0.22,0.04", "--junit", "judged.xml"});
  EXPECT_EQ(result.status, 1) << result.error;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("world.csv: not judged: the rates are along the world's axes; state "
                              "simulation.rates_along = \"world\", or --rates-along world"),
                    HasSubstr("simbody.csv: agrees with the exact motion")));
  EXPECT_THAT(read("judged.xml"),
              AllOf(HasSubstr("<testsuite name=\"world.csv\" tests=\"1\" failures=\"1\">"),
                    HasSubstr("<testsuite name=\"simbody.csv\" tests=\"1\" failures=\"0\">")));
  EXPECT_THAT(judge({"world.csv", "--json"}).output,
              HasSubstr("\"mistake\":\"the rates are along the world's axes"));
  EXPECT_THAT(judge({"world.csv", "--rates-along", "world"}).output,
              HasSubstr("world.csv: agrees with the exact motion"));
  writeScene("world.csv");
  EXPECT_THAT(runWithoutGraphics({"check", "scene.toml"}).error,
              HasSubstr("the rates are along the world's axes"));
  EXPECT_EQ(runWithoutGraphics({"check", "scene.toml", "--set", "simulation.rates_along=\"world\""})
                .status,
            0);
}

TEST_F(Recorded, TheUnitOfTimesIsStated) {
  std::string table = read("simbody.csv");
  table.replace(table.find("time_s"), 6, "time_ms");
  write("seconds.csv", table);
  EXPECT_THAT(judge({"seconds.csv", "--time-unit", "s"}).output,
              HasSubstr("seconds.csv: agrees with the exact motion"));
}

TEST_F(Recorded, ScenesAreJudgedToo) {
  const ChildResult result = runWithoutGraphics({"judge", "tiny.toml"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("tiny.toml: agrees with the exact motion"));
}

TEST_F(Recorded, NeedABody) {
  const ChildResult result = runWithoutGraphics({"judge", "simbody.csv"});
  EXPECT_EQ(result.status, 2);
  EXPECT_MESSAGE(result.error);
  EXPECT_THAT(runWithoutGraphics({"judge", "simbody.csv", "--inertia", "1,2,9"}).error,
              HasSubstr("a principal moment can't exceed the sum of the other two"));
  EXPECT_THAT(runWithoutGraphics({"judge", "simbody.csv", "--inertia", "1,2"}).error,
              HasSubstr("--inertia 1,2 must be three numbers over 0"));
}

TEST_F(Recorded, ClipsAreProvedWithTheirFile) {
  writeScene("simbody.csv");
  const ChildResult render = run({"render", "scene.toml", "--no-png"});
  ASSERT_EQ(render.status, 0) << render.error;
  const ChildResult proof = run({"verify", "out/scene.mp4", "--scene-folder", "."});
  EXPECT_TRUE(proof.status == 0 || proof.status == 4) << proof.error << proof.output;
  EXPECT_EQ(run({"verify", "out/scene.mp4"}).status, proof.status);
  copy("mujoco", "simbody.csv");
  EXPECT_MESSAGE(run({"verify", "out/scene.mp4"}).error);
  EXPECT_MESSAGE(run({"verify", "out/scene.mp4", "--scene-folder", "."}).error);
}

TEST_F(Recorded, FramesAreAssembledWithoutTheirFile) {
  writeScene("simbody.csv");
  ASSERT_EQ(run({"render", "scene.toml"}).status, 0);
  fs::remove(folder() / "simbody.csv");
  EXPECT_EQ(run({"assemble", "out/scene", "-o", "again.mp4"}).status, 0);
  EXPECT_EQ(read("again.mp4"), read("out/scene.mp4"));
}

TEST_F(Recorded, AreReadFromTheScenesFolderAlone) {
  fs::create_directory(folder() / "below");
  fs::rename(folder() / "simbody.csv", folder() / "outside.csv");
  writeScene("../outside.csv");
  fs::rename(folder() / "scene.toml", folder() / "below/scene.toml");
  const ChildResult result = runWithoutGraphics({"check", "below/scene.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_MESSAGE(result.error);
  EXPECT_EQ(runWithoutGraphics({"check", "below/scene.toml", "--allow-outside"}).status, 0);
}

TEST_F(Recorded, TossesTellTheInertiaAndWriteAScene) {
  fs::copy_file(fs::path(ROTATEBOOK_SOURCE) / "docs/toss.csv", folder() / "toss.csv");
  const ChildResult result = runWithoutGraphics({"toss", "toss.csv", "-o", "toss.toml"});
  ASSERT_EQ(result.status, 0) << result.error;
  // The default book's ratios are 0.3151 and 0.7266.
  EXPECT_THAT(result.output, AllOf(HasSubstr("  I1/I3 = 0.315"), HasSubstr("  I2/I3 = 0.726"),
                                   HasSubstr("of rest before"), HasSubstr("wrote toss.toml\n")));
  const ChildResult simulated = runWithoutGraphics({"simulate", "toss.toml"});
  EXPECT_EQ(simulated.status, 0) << simulated.error;
  EXPECT_THAT(simulated.output, HasSubstr("within 0."));  // degrees of the exact motion
  EXPECT_THAT(runWithoutGraphics({"toss", "toss.csv", "-o", "out/toss.toml"}).error,
              HasSubstr("write it beside the recording"));
  EXPECT_THAT(runWithoutGraphics({"toss", "toss.csv", "-o", "toss.toml"}).error,
              HasSubstr("toss.toml exists, and isn't overwritten"));
  EXPECT_THAT(runWithoutGraphics({"toss", "toss.csv", "--json"}).output,
              AllOf(HasSubstr(R"("I1_over_I3":{"value":0.315)"), HasSubstr(R"("readings":)")));
  EXPECT_THAT(runWithoutGraphics({"toss", "toss.csv", "--lever", "-1"}).error,
              HasSubstr("--lever must be a number, 0 or more, not -1"));
}

TEST_F(Recorded, JudgingReplacesItsOwnReportAlone) {
  const std::vector<std::string> judge{"judge", "simbody.csv", "--size", "0.15,0.22,0.04",
                                       "--junit"};
  const auto to = [&](const std::string& file) {
    std::vector<std::string> words = judge;
    words.push_back(file);
    return runWithoutGraphics(words);
  };
  EXPECT_EQ(to("judged.xml").status, 0);
  EXPECT_EQ(to("judged.xml").status, 0);
  const std::string before = read("simbody.csv");
  EXPECT_THAT(to("simbody.csv").error, HasSubstr("simbody.csv exists, and isn't overwritten"));
  EXPECT_EQ(read("simbody.csv"), before);
}

TEST_F(Recorded, JudgingRefusesOptionsThatNothingTakes) {
  writeScene("simbody.csv");
  EXPECT_THAT(runWithoutGraphics({"judge", "scene.toml", "--size", "1,2,3"}).error,
              HasSubstr("are a table's, and there is none"));
  EXPECT_THAT(
      runWithoutGraphics({"judge", "simbody.csv", "--inertia", "1,2,2", "--set", "a=1"}).error,
      HasSubstr("--set is a scene's, and there is none"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
