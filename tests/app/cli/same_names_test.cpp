// Clips, maps, films and studies whose files have the same names: none replaces another's.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A clip and a map, with a film.
constexpr const char* kBoth = R"(title = "Both"
book.color = "#2b5d8a"
[initial]
angular_velocity = [5.0, 0.0, 0.005]
tilt = [0.01, "z"]
[clip]
size = [64, 36]
duration = 0.2
[map]
x = { key = "simulation.substeps", from = 1, to = 9 }
y = { key = "initial.tilt.0", from = 1e-4, to = 1, scale = "log" }
measure = "half_turns"
duration = 1
size = [32, 32]
colors = { from = 0, to = 9 }
film = { x = [2, 3], duration = "0.1 s" }
)";

using Command = std::vector<std::string>;

class SameNames : public ProgramTest {
 protected:
  void makeScenes(const std::vector<std::string>& names) const {
    for (const std::string& name : names) write(name + ".toml", kBoth);
  }

  /// Expects that `second` is refused for `file`, which `first` left and keeps, with `message`.
  void expectKept(const std::string& file, const Command& first, const Command& second,
                  const std::string& message) const {
    const ChildResult made = run(first);
    ASSERT_EQ(made.status, 0) << made.error;
    ASSERT_TRUE(has(file));
    const std::string bytes = read(file);
    const ChildResult refused = run(second);
    EXPECT_EQ(refused.status, 2) << second.front();
    EXPECT_THAT(refused.error,
                AllOf(HasSubstr(file + " belongs to " + message), HasSubstr("would replace it")));
    EXPECT_TRUE(read(file) == bytes) << second.front();
    EXPECT_EQ(run(first).status, 0) << "its own";
    fs::remove_all(folder() / "out");
  }

  /// Expects that `command`, beside all else that it left, replaces none of the `files` that is of
  /// others, and each that is its own.
  void expectOthersKept(const Command& command, const std::vector<std::string>& files,
                        const std::string& message) const {
    const ChildResult made = run(command);
    ASSERT_EQ(made.status, 0) << made.error;
    for (const std::string& file : files) {
      const std::string own = read(file), others = "mine\n" + own.substr(0, own.size() / 2);
      write(file, others);
      const ChildResult refused = run(command);
      EXPECT_EQ(refused.status, 2) << file;
      EXPECT_THAT(refused.error, HasSubstr(file + message));
      EXPECT_EQ(read(file), others);
      write(file, own);
    }
    EXPECT_EQ(run(command).status, 0) << "its own";
  }
};

constexpr const char* kStudied = R"([initial]
angular_velocity = [5.0, 0.0, 0.005]
[study]
x = { key = "simulation.substeps", values = [4, 8] }
measure = ["energy_drift"]
duration = 0.2
)";

const Command kRender{"render", "m.toml", "--no-png"};
const Command kMakeMap{"map", "m.toml"};

TEST_F(SameNames, OfAClipAndAMap) {
  makeScenes({"m"});
  expectKept("out/m.csv", kMakeMap, kRender, "the map m");
  expectKept("out/m.json", kRender, kMakeMap, "the clip m");
  expectKept("out/m.csv", kMakeMap, {"simulate", "m.toml", "--csv", "out/m.csv"}, "the map m");
  expectKept("out/m.csv", kMakeMap,
             {"submit", "render", "m.toml", "--plan", "list", "--chunk", "9"}, "the map m");
  expectKept("out/m.json", kRender, {"submit", "map", "m.toml", "--plan", "list", "--chunk", "9"},
             "the clip m");
}

TEST_F(SameNames, OfAMapMayBeReplacedIfAsked) {
  makeScenes({"m"});
  ASSERT_EQ(run(kMakeMap).status, 0);
  EXPECT_EQ(run({"render", "m.toml", "--no-png", "--overwrite"}).status, 0);
  EXPECT_THAT(read("out/m.csv"), ::testing::StartsWith("frame,time_s,"));
}

TEST_F(SameNames, OfAClipAndAFilm) {
  makeScenes({"m", "m.film"});
  const Command film{"map", "m.toml", "--film"};
  const Command clip{"render", "m.film.toml", "--no-png"};
  expectKept("out/m.film.mp4", film, clip, "the film of the map m");
  expectKept("out/m.film.mp4", clip, film, "the clip m.film");
}

TEST_F(SameNames, OfTwoMaps) {
  makeScenes({"m", "m.plain"});
  const Command plain{"map", "m.plain.toml"};
  expectKept("out/m.plain.png", kMakeMap, plain, "the map m");
  expectKept("out/m.plain.png", plain, kMakeMap, "the map m.plain");
}

TEST_F(SameNames, OfAClipsPicturesAndAMap) {
  makeScenes({"m", "m.poster", "m.thumbnail"});
  const Command poster{"map", "m.poster.toml"};
  expectKept("out/m.poster.png", poster, kRender, "the map m.poster");
  expectKept("out/m.poster.png", kRender, poster, "the clip m");

  // A page's thumbnail; the page shows a scene that has no map
  write("m.toml", kTiny);
  const Command thumbnail{"map", "m.thumbnail.toml"};
  ASSERT_EQ(run(kRender).status, 0);
  ASSERT_EQ(run(thumbnail).status, 0);
  const std::string map = read("out/m.thumbnail.png");
  const ChildResult page = run({"page", "m.toml"});
  EXPECT_EQ(page.status, 2);
  EXPECT_THAT(page.error, HasSubstr("out/m.thumbnail.png belongs to the map m.thumbnail, and the"));
  EXPECT_TRUE(read("out/m.thumbnail.png") == map);
  EXPECT_FALSE(has("out/index.html"));
  fs::remove_all(folder() / "out");
  ASSERT_EQ(run(kRender).status, 0);
  expectKept("out/m.thumbnail.png", {"page", "m.toml"}, thumbnail, "the clip m");
}

TEST_F(SameNames, OfAPanelsTableAndAMap) {
  makeScenes({"m_b"});
  write("m.toml", std::string(kTiny) + "[[panel]]\nlabel = \"a\"\nbody.mass = 2\n" +
                      "[[panel]]\nlabel = \"b\"\n");
  const Command map{"map", "m_b.toml"};
  expectKept("out/m_b.csv", map, kRender, "the map m_b");
  expectKept("out/m_b.csv", kRender, map, "the clip m");
}

TEST_F(SameNames, OfAStudyAndOthers) {
  makeScenes({"m", "m-study"});
  const Command study{"study", "m.toml", "--steps", "1,2", "--integrators", "rk4"};
  expectKept("out/m-study.csv", study, {"render", "m-study.toml", "--no-png"}, "the study of m");
  expectKept("out/m-study.png", study, {"map", "m-study.toml"}, "the study of m");
  expectKept("out/m-study.csv", {"map", "m-study.toml"}, study, "the map m-study");
}

TEST_F(SameNames, OfAStillAndAMap) {
  makeScenes({"m"});
  ASSERT_EQ(run({"map", "m.toml", "-o", "."}).status, 0);
  const std::string map = read("m.png");
  const ChildResult still = run({"still", "m.toml"});
  EXPECT_EQ(still.status, 2);
  EXPECT_THAT(still.error,
              HasSubstr("m.png belongs to the map m, and the picture would replace it"));
  EXPECT_TRUE(read("m.png") == map);
}

TEST_F(SameNames, OfPicturesAndWhatAMapOrAClipLeft) {
  makeScenes({"m"});
  ASSERT_EQ(run({"map", "m.toml", "-o", "maps"}).status, 0);
  ASSERT_EQ(run({"render", "m.toml", "--set", "clip.duration=0.1"}).status, 0);
  ASSERT_EQ(run({"still", "m.toml", "-o", "one.png"}).status, 0);
  const std::vector<Command> commands{{"still", "m.toml", "-o"},
                                      {"still", "m.toml", "--times", "0,0.1", "-o"},
                                      {"diff", "one.png", "one.png", "-o"}};
  const std::map<std::string, std::string> owners{{"maps/m.png", "the map m"},
                                                  {"maps/m.plain.png", "the map m"},
                                                  {"out/m.poster.png", "the clip m"},
                                                  {"out/m/frame_00001.png", "the clip m"}};
  for (Command command : commands) {
    command.emplace_back();
    for (const auto& [file, owner] : owners) {
      command.back() = file;
      const std::string bytes = read(file);
      const ChildResult result = run(command);
      EXPECT_EQ(result.status, 2) << command.front();
      EXPECT_THAT(result.error, HasSubstr(file + " belongs to " + owner + ", and the picture"));
      EXPECT_TRUE(read(file) == bytes);
    }
    command.back() = command.front() + ".png";  // Its own, also again
    EXPECT_EQ(run(command).status, 0);
    EXPECT_EQ(run(command).status, 0);
  }
}

TEST_F(SameNames, OfAClipAndAFileThatNoRenderLeft) {
  const auto expectForeignKept = [this](const std::string& file, const Command& command,
                                        const std::string& remedy) {
    write(file, "t,wx,wy,wz\n");
    const ChildResult refused = run(command);
    EXPECT_EQ(refused.status, 2) << file;
    EXPECT_THAT(refused.error, HasSubstr(file + " was left by no render, and the "));
    EXPECT_THAT(refused.error, HasSubstr(remedy));
    EXPECT_EQ(read(file), "t,wx,wy,wz\n");
    EXPECT_FALSE(has("out/tiny/frame_00000.png"));
    fs::remove(folder() / file);
  };
  for (const char* name : {"out/tiny.csv", "out/tiny.poster.png", "out/tiny.mp4"}) {
    expectForeignKept(name, {"render", "tiny.toml"}, "--overwrite");
    expectForeignKept(name, {"submit", "render", "tiny.toml", "--plan", "list", "--chunk", "9"},
                      "with -o");
  }
  expectForeignKept("out/tiny.gif", {"render", "tiny.toml", "--format", "gif"}, "--overwrite");
  expectForeignKept("out/toss.csv", {"render", "tiny.toml", "-o", "out/toss.mp4"}, "--overwrite");
  expectForeignKept("out/q.poster.png", {"render", "tiny.toml", "-o", "out/q.mp4"}, "--overwrite");
  expectForeignKept("out/t.csv", {"simulate", "tiny.toml", "--csv", "out/t.csv"}, "--csv");

  // It may be replaced on purpose, and is the render's then
  write("out/tiny.csv", "t,wx,wy,wz\n");
  EXPECT_EQ(run({"render", "tiny.toml", "--no-png", "--overwrite"}).status, 0);
  EXPECT_EQ(run({"render", "tiny.toml", "--format", "gif"}).status, 0);
  EXPECT_EQ(run({"render", "tiny.toml", "--size", "32x18", "--format", "gif"}).status, 0);
  fs::remove_all(folder() / "out/tiny");
  EXPECT_EQ(run({"render", "tiny.toml", "--format", "gif"}).status, 0) << "it has its mark";

  // Its own table beside it makes no foreign picture the render's
  fs::remove_all(folder() / "out");
  const Command pictures{"render", "tiny.toml", "--no-png", "--format", "gif,apng"};
  EXPECT_EQ(run(pictures).status, 0);
  for (const char* name : {"out/tiny.poster.png", "out/tiny.gif", "out/tiny.apng"})
    expectForeignKept(name, pictures, "--overwrite");
}

TEST_F(SameNames, OfAStudyAndAFileOfNoStudy) {
  write("s.toml", kStudied);
  expectOthersKept({"study", "s.toml"},
                   {"out/s-study.csv", "out/s-study.json", "out/s-study.png", "out/s-study.svg",
                    "out/s-study.pdf"},
                   " was left by no study, and the study of s would replace it");
}

TEST_F(SameNames, OfAStillAndAPictureOfAnotherProgram) {
  for (const char* name : {"a.png", "tiny.png"}) write(name, "mine");
  const std::vector<Command> commands{{"still", "tiny.toml"},
                                      {"still", "tiny.toml", "-o", "a.png"},
                                      {"still", "tiny.toml", "-o", "a.png", "--count", "2"}};
  for (const Command& command : commands) {
    const ChildResult refused = run(command);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.error, HasSubstr(".png has no mark of rotatebook, and the picture would"));
  }
  EXPECT_EQ(read("a.png") + read("tiny.png"), "minemine");
  fs::remove(folder() / "a.png");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(run(commands[1]).status, 0) << "its own";
}

// A map removes its earlier files, its table too, though it may be too large to have one.
TEST_F(SameNames, OfAMapAndAFileOfNoMap) {
  makeScenes({"m"});
  expectOthersKept(kMakeMap,
                   {"out/m.npy", "out/m.png", "out/m.svg", "out/m.pdf", "out/m.plain.png"},
                   " is no map's, and would be replaced");
  fs::remove_all(folder() / "out");
  for (const char* name :
       {"out/m.csv", "out/m.json", "out/m.png", "out/m.pdf", "out/m.plain.png"}) {
    write(name, "t,wx,wy,wz\n");
    const ChildResult result = run(kMakeMap);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.error, HasSubstr(std::string(name) + " is no map's, and would be replaced"));
    EXPECT_EQ(read(name), "t,wx,wy,wz\n");
    fs::remove(folder() / name);
  }
}

}  // namespace
}  // namespace rotatebook::cli::testing
