// --json of the commands that render, simulate, study and check scenes, or print a spin.
#include <csignal>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Json : public ProgramTest {
 protected:
  Json() {
    write("b.toml",
          "title = \"Größe \\\"x\\\" \\\\ 書\"\nbook.color = \"#2b5d8a\"\n"
          "[initial]\nangular_velocity = [5.0, 0.0, 0.005]\n"
          "[clip]\nsize = [64, 36]\nduration = 0.2\n[expect]\nhalf_turns = { max = 3, min = 1 }\n");
    write("wrong.toml", "titel = 'T'\n");
  }

  /// Expects that `text` is a line that Python's parser reads back as one object with these keys.
  void expectKeys(const std::string& text, const std::string& keys) const {
    EXPECT_EQ(countOf("\n", text), 1) << text;
    write("printed.json", text);
    ChildSettings settings;
    settings.folder = folder();
    const ChildResult read = runChild(
        "/usr/bin/env",
        {"python3", "-c", "import json; print(*json.load(open('printed.json', encoding='utf-8')))"},
        settings);
    EXPECT_EQ(read.output, keys + '\n') << read.error << text;
  }
};

constexpr const char* kWrong = "wrong.toml:1:1: unknown key \"titel\"; did you mean \"title\"?";
constexpr const char* kWrongInJson =
    R"("ok":false,"errors":["wrong.toml:1:1: unknown key \"titel\"; did you mean \"title\"?"])";
constexpr const char* kTitleInJson = R"("title":"Größe \"x\" \\ 書")";
constexpr const char* kUnmet = "rotatebook: expectations are not met; the files were kept\n";

TEST_F(Json, OfAStudyThatCantBeWrittenHasTheError) {
  fs::create_directories(folder() / "out/b-study.csv");
  for (const std::string output : {"/proc/x", "out"}) {
    const ChildResult result = runWithoutGraphics(
        {"study", "tiny.toml", "b.toml", "--json", "-o", output, "--set", "title=b"});
    EXPECT_EQ(result.status, 3) << output;
    expectKeys(result.output, "interrupted studies");
    EXPECT_EQ(countOf("\"name\":", result.output), 2);
    EXPECT_EQ(countOf("\"error\":null", result.output), 1);
    EXPECT_THAT(result.error, StartsWith("rotatebook: ")) << output;
  }
}

TEST_F(Json, OfCheckHasEachFile) {
  const ChildResult result = runWithoutGraphics(
      {"check", "tiny.toml", "wrong.toml", "b.toml", "--json", "--set", "body.size=[0.1, 0.2, 9]"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, AllOf(HasSubstr(std::string("rotatebook: ") + kWrong + '\n'),
                                  HasSubstr("note: tiny: the body is 9 m long")));
  expectKeys(result.output, "scenes");
  EXPECT_EQ(countOf("\"ok\":true", result.output), 2);
  EXPECT_THAT(result.output, StartsWith(R"({"scenes":[{"path":"tiny.toml","ok":true,"errors":[],)"
                                        R"("notes":["the body is 9 m long)"));
  EXPECT_THAT(result.output, HasSubstr(kWrongInJson));
}

// That of its clip, which shows a second more where its motion diverges, not that of its duration.
TEST_F(Json, OfCheckHasTheNumberOfFrames) {
  write("b.toml",
        "title = 'B'\n[initial]\nangular_velocity = [5, 3, 1]\n[clip]\nsize = [64, 36]\n"
        "fps = 24\nduration = 0.5\n[simulation]\nmodel = 'particles'\nsubsteps = 1\n"
        "normalize = false\ndamping = 0\n");
  const ChildResult result = runWithoutGraphics({"check", "tiny.toml", "b.toml", "--json"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, AllOf(HasSubstr(R"("notes":[],"frames":12,"panels":[],)"),
                                   HasSubstr(R"("frames":27,"panels":[],)")));
}

TEST_F(Json, OfCheckHasPanels) {
  write("more/panels.toml",
        "title = \"Panels\"\n[[panel]]\nlabel = \"one\"\n"
        "initial.angular_velocity = [5, 0, 0.005]\n[[panel]]\nlabel = \"two\"\n"
        "initial.angular_velocity = [0, 5, 0]\n");
  write("more/wrong.toml", "titel = 'T'\n");
  const ChildResult result = runWithoutGraphics({"check", "more", "--json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error, std::string("rotatebook: more/") + kWrong + '\n');
  expectKeys(result.output, "scenes");
  EXPECT_EQ(result.output,
            R"({"scenes":[{"path":"more/panels.toml","ok":true,"errors":[],"notes":[],)"
            R"("frames":720,"panels":["one","two"],"name":"panels","title":"Panels",)"
            R"("duration_s":12.0,"width":1280,"height":720,"has_study":false},)"
            R"({"path":"more/wrong.toml","ok":false,"errors":["more/wrong.toml:1:1: )"
            R"(unknown key \"titel\"; did you mean \"title\"?"],"notes":[]}]})"
            "\n");
}

TEST_F(Json, OfSimulateHasWhatWasMeasured) {
  const ChildResult result = runWithoutGraphics({"simulate", "b.toml", "--csv", "t.csv", "--json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.error, kUnmet);
  expectKeys(result.output, "name title tables motions");
  EXPECT_THAT(
      result.output,
      AllOf(HasSubstr(kTitleInJson), HasSubstr(R"("tables":[{"path":"t.csv","rows":12})"),
            HasSubstr(R"("label":null,"model":"quaternion","integrator":"rk4",)"
                      R"("half_turns":0,"flips_s":[],"energy_ratio":{"lowest":)"),
            HasSubstr(
                R"("diverged_at_s":null,"diverges_unexpectedly":false,"judged":true,"met":false,)"
                R"("expectations":[{"quantity":"half_turns","from_s":0.0,)"
                R"("to_s":null,"min":1.0,"max":3.0,)")));
}

TEST_F(Json, OfSimulateIsRefusedWhereTheTableIsPrinted) {
  const ChildResult result = runWithoutGraphics({"simulate", "b.toml", "--csv", "-", "--json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: --csv - and --json both print to the standard output; name a file with "
            "--csv\n");
  EXPECT_THAT(result.output, IsEmpty());
}

TEST_F(Json, OfInfoHasTheNumbersOfBodyAndSpin) {
  const ChildResult result = runWithoutGraphics({"info", "b.toml", "--json"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.error, IsEmpty());
  expectKeys(result.output, "name title motions");
  EXPECT_THAT(result.output, AllOf(HasSubstr(kTitleInJson), HasSubstr(R"("spun_axis":"middle",)"),
                                   HasSubstr(R"("euler":{"substeps":)")));
}

TEST_F(Json, OfStudyHasOrdersAndFiles) {
  const ChildResult result =
      runWithoutGraphics({"study", "b.toml", "--steps", "1,2,4", "--integrators", "rk4", "--json",
                          "--set", R"(title='Größe "x" \')"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.error, IsEmpty());
  expectKeys(result.output, "interrupted studies");
  EXPECT_THAT(
      result.output,
      AllOf(HasSubstr(R"("title":"Größe \"x\" \\")"), HasSubstr(R"("x":"simulation.substeps",)"),
            HasSubstr(R"("files":["out/b-study.csv","out/b-study.png","out/b-study.svg",)"
                      R"("out/b-study.pdf","out/b-study.json"],"runs":[{"value":"1",)"),
            HasSubstr(R"("orders":[{"curve":"rk4","order":3.9)")));
}

TEST_F(Json, OfStudyHoldsWhatWasDoneBeforeAnError) {
  const ChildResult result = runWithoutGraphics(
      {"study", "tiny.toml", "b.toml", "--steps", "1", "--integrators", "rk4", "--json", "--set",
       "initial.angular_velocity=[1e4, 0, 1]", "--set", "title=b"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, HasSubstr("rotatebook: tiny: no run reached its end"));
  expectKeys(result.output, "interrupted studies");
  EXPECT_THAT(result.output, HasSubstr(R"("error":"tiny: no run reached its end)"));
  EXPECT_THAT(result.output, HasSubstr(R"("error":null,"files":[],"runs":[])"));
}

TEST_F(Json, OfStudyIsPrintedAfterAnInterrupt) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalWhen = [this] { return has("out"); };
  // Ten minutes, were it not for the signal.
  const ChildResult result = run({"study", "tiny.toml", "--set", "clip.duration=100", "--steps",
                                  "1000000", "--integrators", "rk4", "--json"},
                                 settings);
  EXPECT_EQ(result.status, 130);
  expectKeys(result.output, "interrupted studies");
  EXPECT_THAT(
      result.output,
      AllOf(StartsWith(R"({"interrupted":true,"studies":[{"result":"study","name":"tiny",)"),
            HasSubstr(R"("interrupted":true,"error":null,"files":[],"runs":[])")));
}

TEST_F(Json, OfRenderHasTheScenesInTheirOrderHoweverManyGoOnAtATime) {
  std::vector<std::string> outputs;
  for (const char* jobs : {"1", "2"}) {
    const ChildResult result = run({"render", "b.toml", "tiny.toml", "--json", "--jobs", jobs});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.error, kUnmet);
    outputs.push_back(result.output);
  }
  EXPECT_EQ(outputs[0], outputs[1]);
  expectKeys(outputs[0], "interrupted scenes");
  EXPECT_THAT(
      outputs[0],
      AllOf(
          StartsWith(R"({"interrupted":false,"scenes":[{"name":"b",)"),
          HasSubstr(R"({"name":"tiny","title":"Tiny","width":64,"height":36,)"
                    R"("frames_per_second":60.0,"duration_s":0.2,"renderer":")"),
          HasSubstr(
              R"("already_done":false,"interrupted":false,"error":null,)"
              R"("frames_written":12,"frames_kept":0,"files":["out/tiny.mp4",)"
              R"("out/tiny.csv","out/tiny.json","out/tiny.poster.png"],"frame_folder":"out/tiny/",)"
              R"("replaced":[],"kept_of_other_settings":[],"note":null,)"
              R"("motions":[{"label":null,)")));
  EXPECT_THAT(outputs[0], HasSubstr(kTitleInJson));
  const ChildResult again = run({"render", "tiny.toml", "--json", "--resume"});
  EXPECT_THAT(again.output, HasSubstr(R"("already_done":true,)"));
  EXPECT_THAT(again.output, HasSubstr(R"("motions":[{"label":null,)"));
}

TEST_F(Json, OfRenderHoldsWhatWasDoneBeforeAnError) {
  fs::create_directories(folder() / "out/b.mp4");
  for (const char* jobs : {"1", "2"}) {
    const ChildResult result =
        run({"render", "b.toml", "tiny.toml", "--overwrite", "--json", "--jobs", jobs});
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(result.error, EndsWith("can't write out/b.mp4: it is a folder\n"));
    expectKeys(result.output, "interrupted scenes");
    EXPECT_THAT(result.output, HasSubstr(R"("error":"can't write out/b.mp4: it is a folder",)"));
    EXPECT_THAT(result.output, HasSubstr(R"("name":"tiny",)"));
  }
}

TEST_F(Json, OfRenderIsPrintedAfterAnInterrupt) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalWhen = [this] { return has("out/tiny.partial/frame_00002.png"); };
  const ChildResult result = run({"render", "tiny.toml", "b.toml", "--json", "--jobs", "1", "--set",
                                  "clip.duration=200", "--set", "simulation.substeps=1"},
                                 settings);
  EXPECT_EQ(result.status, 130) << result.error;
  expectKeys(result.output, "interrupted scenes");
  EXPECT_THAT(result.output, StartsWith(R"({"interrupted":true,"scenes":[{"name":"tiny",)"));
  EXPECT_THAT(result.output, HasSubstr(R"("interrupted":true,"error":null,"frames_written":)"));
  EXPECT_THAT(result.output, HasSubstr(R"("files":["out/tiny.partial.mp4"],)"
                                       R"("frame_folder":"out/tiny.partial/")"));
  EXPECT_THAT(result.output, HasSubstr(R"("renderer":null,"encoders":null,"already_done":false,)"
                                       R"("interrupted":false,"error":null,"frames_written":0,)"));
  EXPECT_FALSE(has("out/b.partial"));
}

TEST_F(Json, IsUtf8WhateverTheNameOfAFile) {
  const ChildResult result = run({"check", "no\xff.toml", "--json"});
  EXPECT_EQ(result.status, 2);
  expectKeys(result.output, "scenes");
  EXPECT_THAT(result.output, HasSubstr("\"path\":\"no\uFFFD.toml\""));
}

}  // namespace
}  // namespace rotatebook::cli::testing
