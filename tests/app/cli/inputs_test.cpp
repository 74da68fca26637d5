// Every file that a scene names, under a name that a command writes: none is lost.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kTetrahedron = R"(v 0 0 0
v 0.1 0 0
v 0 0.2 0
v 0 0 0.3
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
)";

constexpr const char* kAllInputs = R"(title = "All kinds"
[initial]
angular_velocity = [5.0, 0.0, 0.005]
[book]
front = "front.png"
color = "#2b5d8a"
[clip]
size = [64, 36]
duration = 0.2
[overlay]
words = "french.words"
show = []
[[panel]]
label = "Book"
[[panel]]
label = "Measured"
simulation.model = "recorded"
simulation.file = "measured.csv"
[[panel]]
label = "Solid"
body.mesh = "solid.obj"
body.density = 700
)";

constexpr const char* kRuns = R"(title = "Runs"
[initial]
angular_velocity = [5.0, 0.0, 0.005]
tilt = [0.01, "z"]
[book]
front = "front.png"
color = "#2b5d8a"
[clip]
size = [64, 36]
duration = 0.2
[overlay]
words = "french.words"
[map]
x = { key = "simulation.substeps", from = 1, to = 9 }
y = { key = "initial.tilt.0", from = 1e-4, to = 1, scale = "log" }
measure = "half_turns"
duration = 1
size = [32, 32]
colors = { from = 0, to = 9 }
film = { x = [2, 3], duration = "0.1 s" }
)";

class Inputs : public ProgramTest {
 protected:
  Inputs() {
    fs::copy_file(fs::path(ROTATEBOOK_SOURCE) / "scenes/comparisons/recordings/simbody.csv",
                  folder() / "measured.csv");
    image::writePng(folder() / "front.png", image::Image(8, 12, image::PixelFormat::Rgb8).view());
    write("french.words", "Energy = \"Énergie\"\n");
    write("solid.obj", kTetrahedron);
    write("all.toml", kAllInputs);
    write("runs.toml", kRuns);
  }

  /// Expects that `command`, which writes, moves or removes `output`, is refused where that is one
  /// of `inputs`, of which the scene's own name is a link then.
  void expectRefused(const std::string& output, const std::map<std::string, std::string>& inputs,
                     const std::vector<std::string>& command) const {
    for (const auto& [input, what] : inputs) {
      fs::create_directories((folder() / output).parent_path());
      fs::rename(folder() / input, folder() / output);
      fs::create_symlink(output, folder() / input);
      const auto before = files();
      const std::string bytes = read(output);
      const ChildResult result = run(command);
      EXPECT_EQ(result.status, 2) << command.front() << ' ' << input << result.error;
      EXPECT_THAT(result.error, HasSubstr(input + " is " + what + " and would be "));
      EXPECT_THAT(result.error, HasSubstr("; name another "));
      EXPECT_THAT(result.output, IsEmpty());
      EXPECT_EQ(files(), before) << command.front() << ' ' << input;
      EXPECT_TRUE(read(output) == bytes) << command.front() << " changed " << input;
      fs::remove(folder() / input);
      fs::rename(folder() / output, folder() / input);
    }
  }

  const std::map<std::string, std::string> ofRecord{
      {"front.png", "a texture of the scene all"},
      {"solid.obj", "a mesh of the scene all"},
      {"measured.csv", "a recording of the scene all"}};
  const std::map<std::string, std::string> ofAll{
      {"front.png", "a texture of the scene all"},
      {"solid.obj", "a mesh of the scene all"},
      {"measured.csv", "a recording of the scene all"},
      {"french.words", "a table of words of the scene all"},
      {"all.toml", "the scene itself"}};
  const std::map<std::string, std::string> ofRuns{
      {"front.png", "a texture of the scene runs"},
      {"french.words", "a table of words of the scene runs"},
      {"runs.toml", "the scene itself"}};
};

TEST_F(Inputs, AreNotWrittenOverByARender) {
  expectRefused("out/all_measured.csv", ofAll, {"render", "all.toml"});
  expectRefused("out/all.mp4", ofAll, {"render", "all.toml", "--resume"});
  expectRefused("out/all.partial/more/x", ofAll, {"render", "all.toml", "--overwrite"});
  expectRefused("out/all/frames.manifest", ofAll, {"render", "all.toml", "--part", "1/2"});
  expectRefused("out/all_00000-00002.mp4", ofAll, {"render", "all.toml", "--frames", "0:2"});
}

TEST_F(Inputs, AreNotWrittenOverByCommandsOfOnePicture) {
  expectRefused("x.png", ofAll, {"still", "all.toml", "-o", "x.png"});
  expectRefused("all.png", ofAll, {"still", "all.toml"});
  expectRefused("x.png", ofAll, {"still", "all.toml", "-o", "x.png", "--count", "2"});
}

TEST_F(Inputs, AreNotWrittenOverByTablesAndPages) {
  expectRefused("x_measured.csv", ofAll, {"simulate", "all.toml", "--csv", "x.csv"});
  expectRefused("out/index.html", ofAll, {"page", "all.toml"});
  expectRefused("out/runs-study.csv", ofRuns, {"study", "runs.toml"});
  for (const char* name : {"out/runs.npy", "out/runs.plain.png", "out/runs.tiles/tile_0"})
    expectRefused(name, ofRuns, {"map", "runs.toml"});
  expectRefused("out/runs.film.mp4", ofRuns, {"map", "runs.toml", "--film"});
}

TEST_F(Inputs, AreNotWrittenOverByWhatIsSubmitted) {
  for (const char* name :
       {"out/farm/render/tasks.txt", "out/farm/render/plan.json", "out/farm/render/join.sh",
        "out/farm/render/log/notes", "out/farm/render/ends/1", "out/all.poster.png"})
    expectRefused(name, ofAll, {"submit", "render", "all.toml", "--plan", "list", "--chunk", "5"});
  expectRefused("out/runs.csv", ofRuns, {"submit", "map", "runs.toml", "--plan", "list"});
  expectRefused("out/runs-study.png", ofRuns, {"submit", "study", "runs.toml", "--plan", "list"});
}

TEST_F(Inputs, AreNotWrittenOverByAClipThatIsMadeAgain) {
  const ChildResult first = run({"render", "all.toml", "-o", "first", "--no-png"});
  ASSERT_EQ(first.status, 0) << first.error;
  const std::vector<std::string> rerun{"verify", "first/all.mp4",  "--again",
                                       "out",    "--scene-folder", "."};
  expectRefused("out/all_measured.csv", ofRecord, rerun);
  expectRefused("out/all.poster.png", ofRecord, rerun);
}

TEST_F(Inputs, AreNotWrittenOverByAVerdict) {
  write("j.xml", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites");
  fs::remove(folder() / "french.words");
  fs::create_hard_link(folder() / "j.xml", folder() / "french.words");
  const std::string before = read("j.xml");
  EXPECT_EQ(run({"judge", "all.toml", "--junit", "j.xml"}).status, 2);
  EXPECT_EQ(run({"judge", "j.xml", "--junit", "j.xml"}).status, 2);
  EXPECT_EQ(read("j.xml"), before);
}

// A phone's toss, as docs/toss.md has it: the scene's table has the recording's name.
TEST_F(Inputs, AreNoRecordingOfTheScenesOwnName) {
  fs::rename(folder() / "measured.csv", folder() / "s.csv");
  write("s.toml",
        "[body]\nsize = [0.15, 0.22, 0.04]\n[simulation]\nmodel = \"recorded\"\n"
        "file = \"s.csv\"\n[clip]\nsize = [64, 36]\nduration = 0.2\n");
  const std::string bytes = read("s.csv");
  const auto expectKept = [&](const std::vector<std::string>& command) {
    const ChildResult result = run(command);
    EXPECT_EQ(result.status, 2) << command.front();
    EXPECT_THAT(result.error,
                HasSubstr("s.csv is a recording of the scene s and would be replaced; name"));
    EXPECT_TRUE(read("s.csv") == bytes) << command.front();
  };
  expectKept({"render", "s.toml", "-o", ".", "--no-png"});
  expectKept({"render", "s.toml", "-o", ".", "--resume"});
  expectKept({"simulate", "s.toml", "--csv", "s.csv"});
  expectKept({"submit", "render", "s.toml", "-o", ".", "--plan", "list", "--chunk", "5"});
  EXPECT_EQ(run({"render", "s.toml", "--no-png"}).status, 0) << "into another folder";
  expectKept({"verify", "out/s.mp4", "--again", ".", "--scene-folder", "."});
}

// The runs of a study may be of recordings, too.
TEST_F(Inputs, AreRecordingsOfAStudysRuns) {
  write("other.toml",
        "[body]\nsize = [0.15, 0.22, 0.04]\n[simulation]\nmodel = \"recorded\"\n"
        "file = \"again.csv\"\n[clip]\nsize = [64, 36]\nduration = 0.2\n"
        "[study]\nx = { key = \"simulation.file\", values = [\"again.csv\", \"measured.csv\"] }\n"
        "measure = [\"half_turns\"]\n");
  fs::copy_file(folder() / "measured.csv", folder() / "again.csv");
  expectRefused("out/other-study.csv",
                {{"again.csv", "a recording of the scene other"},
                 {"measured.csv", "a recording of the scene other"}},
                {"study", "other.toml"});
}

}  // namespace
}  // namespace rotatebook::cli::testing
