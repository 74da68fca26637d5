// `rotatebook watch`, and `check --schema`.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class WatchTest : public ProgramTest {};

TEST_F(WatchTest, DrawsAnewAtEachSaveUntilItIsInterrupted) {
  int step = 0;
  std::string first, second;
  ChildSettings settings;
  settings.signal = SIGINT;
  constexpr auto kEnough = std::chrono::seconds(3);  // To print a mistake; measured 0.1 s.
  std::chrono::steady_clock::time_point end;
  settings.signalWhen = [&] {
    if (!fs::exists(folder() / "tiny.png")) return false;
    const std::string picture = read("tiny.png");
    if (step == 0) {  // As editors save: by another file of that name.
      first = picture;
      write("new", std::string(kTiny) + "\n[look]\nbackground = \"white\"\n");
      fs::rename(folder() / "new", folder() / "tiny.toml");
      step = 1;
    } else if (step == 1 && picture != first) {
      second = picture;
      write("tiny.toml", std::string(kTiny) + "\n[body]\nmaas = 1\n");
      step = 2;
      end = std::chrono::steady_clock::now() + kEnough;
    }
    return step == 2 && std::chrono::steady_clock::now() > end;
  };
  const ChildResult result = run({"watch", "tiny.toml"}, settings);
  EXPECT_EQ(result.status, 130) << result.error;
  EXPECT_EQ(result.output, "tiny: wrote frame 6 to tiny.png\ntiny: wrote frame 6 to tiny.png\n");
  EXPECT_THAT(result.error, HasSubstr("unknown key \"maas\" in [body]; did you mean \"mass\"?"));
  EXPECT_EQ(step, 2);
  EXPECT_EQ(read("tiny.png"), second);
}

TEST_F(WatchTest, TellsTheLiveBookOfEachSaveAndMistake) {
  write("play.html", "<!doctype html>\n<section class=\"rb-live\"></section>\n");
  write("tiny.toml", std::string(kTiny) + "\n[body]\nmaas = 1\n");
  ChildSettings settings;
  settings.signal = SIGINT;
  int step = 0;
  std::string mistake, scene;
  settings.signalWhen = [&] {
    if (!fs::exists(folder() / "tiny.live.js")) return false;
    const std::string script = read("tiny.live.js");
    if (step == 0) {  // A scene that begins with a mistake is watched, too.
      mistake = script;
      write("tiny.toml", kTiny);
      step = 1;
    } else if (step == 1 && script != mistake) {
      scene = script;
      step = 2;
    }
    return step == 2 && fs::exists(folder() / "tiny.png");
  };
  const ChildResult result = run({"watch", "tiny.toml", "--live", "play.html"}, settings);
  EXPECT_EQ(result.status, 130) << result.error;
  EXPECT_THAT(result.output, StartsWith("tiny: open tiny.live.html in a browser\n"));
  EXPECT_THAT(mistake, HasSubstr("unknown key \\\"maas\\\" in [body]"));
  EXPECT_THAT(scene, HasSubstr("rotatebookFollows({\"text\":\""));
  const std::string page = read("tiny.live.html");
  EXPECT_THAT(page, HasSubstr(read("play.html")));
  EXPECT_THAT(page, HasSubstr("follow(\"tiny.live.js\");"));
  EXPECT_EQ(run({"watch", "tiny.toml", "--live", "tiny.toml"}).status, 2);
  EXPECT_THAT(
      run({"watch", "tiny.toml", "--live", "none.html"}).error,
      HasSubstr("there is no file of the live book; name play.html, which make play makes"));
  write("tiny.live.js", "somebody's");
  EXPECT_EQ(run({"watch", "tiny.toml", "--live", "play.html"}).status, 2);
  EXPECT_EQ(read("tiny.live.js"), "somebody's");
}

TEST_F(WatchTest, FindsTheLiveBookThatIsInstalledWithTheProgram) {
  fs::create_directory(folder() / "bin");
  fs::copy_file(ROTATEBOOK_PROGRAM, folder() / "bin/rotatebook");
  ChildSettings settings;
  settings.folder = folder();
  settings.signal = SIGINT;
  settings.signalWhen = [&] { return fs::exists(folder() / "tiny.png"); };
  const auto watch = [&] {
    return runChild(folder() / "bin/rotatebook", {"watch", "--live", "tiny.toml"}, settings);
  };
  EXPECT_EQ(watch().error,
            "rotatebook: --live: no live book is installed with the program; name play.html, which "
            "make play makes: --live PLAY.html\n");
  write("share/rotatebook/play.html", "<!doctype html>\n<section class=\"rb-live\"></section>\n");
  EXPECT_EQ(watch().status, 130);
  EXPECT_THAT(read("tiny.live.html"), HasSubstr(read("share/rotatebook/play.html")));
}

TEST_F(WatchTest, RefusesWhatCannotBeWatched) {
  EXPECT_EQ(run({"watch", "-"}).status, 2);
  EXPECT_EQ(run({"watch", "none.toml"}).status, 2);
  EXPECT_EQ(run({"watch", "tiny.toml", "-o", "tiny.toml"}).status, 2);
}

TEST_F(WatchTest, SchemaIsPrintedInPlaceOfAFile) {
  const ChildResult result = run({"-q", "check", "--schema"});
  EXPECT_EQ(result.status, 0) << result.error;
  const auto schema = nlohmann::json::parse(result.output);
  EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-04/schema#");
  EXPECT_TRUE(schema["properties"]["body"]["properties"].contains("mass"));
  EXPECT_EQ(run({"check", "--schema", "tiny.toml"}).status, 2);
  EXPECT_THAT(run({"check"}).error, StartsWith("rotatebook: name the scenes to check"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
