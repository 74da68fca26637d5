// rotatebook new, which writes the scene that everybody begins with.
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "scene/scene_text.h"
#include "store/scene_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class New : public ProgramTest {
 protected:
  /// Expects that `path` is refused with `message`, and that nothing is written.
  void expectRefused(const std::string& path, const std::string& message, int status = 2) const {
    const auto before = files();
    const ChildResult result = run({"new", path});
    EXPECT_EQ(result.status, status) << path;
    EXPECT_EQ(result.error, "rotatebook: " + message + '\n');
    EXPECT_EQ(files(), before);
  }
};

TEST_F(New, WritesTheStarterWithATitleOfItsOwn) {
  const ChildResult result = run({"new", "my-first_throw.toml"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output,
            "wrote my-first_throw.toml\nnext: change a number in it, and run\n"
            "  rotatebook render my-first_throw.toml\n");
  EXPECT_THAT(read("my-first_throw.toml"),
              AllOf(StartsWith("# A first scene."), HasSubstr("\ntitle = \"My first throw\"\n"),
                    HasSubstr("\ntilt = [\"1 deg\", \"z\"]  ")));

  // But for its title it is scenes/starter.toml, whose motion is tested in starter_test.cpp.
  scene::Scene made = store::readScene(folder() / "my-first_throw.toml");
  const scene::Scene starter =
      store::readScene(fs::path(ROTATEBOOK_SOURCE) / "scenes/starter.toml");
  made.title = starter.title;
  EXPECT_EQ(sceneText(made), sceneText(starter));
}

TEST_F(New, NamesTheSchemaThatIsInstalled) {
  fs::create_directories(folder() / "my prefix/bin");
  const fs::path program = folder() / "my prefix/bin/rotatebook";
  fs::copy_file(ROTATEBOOK_PROGRAM, program);
  write("my prefix/share/rotatebook/scene.schema.json", run({"check", "--schema"}).output);
  ASSERT_EQ(runChild(program.string(), {"new", "my.toml"}, {.folder = folder()}).status, 0);
  EXPECT_THAT(
      read("my.toml"),
      AllOf(StartsWith("#:schema file:///"),
            HasSubstr("/my%20prefix/share/rotatebook/scene.schema.json\n# A first scene.")));
  EXPECT_EQ(run({"check", "my.toml"}).status, 0);
}

TEST_F(New, WritesASceneThatIsCheckedAndRendered) {
  ASSERT_EQ(run({"new", "a \"b\" ü.toml"}).status, 0);
  const ChildResult check = run({"check", "a \"b\" ü.toml"});
  EXPECT_EQ(check.status, 0);
  EXPECT_EQ(check.error, "");
  const ChildResult render = run(
      {"render", "a \"b\" ü.toml", "--size", "64x36", "--no-png", "--set", "clip.duration=0.5 s"});
  EXPECT_EQ(render.status, 0) << render.error;
  EXPECT_TRUE(has("out/a \"b\" ü.mp4"));
  EXPECT_THAT(render.output, HasSubstr("A \"b\" ü"));
}

TEST_F(New, OverwritesNothing) {
  const std::string tiny = read("tiny.toml");
  const std::string remedy = " exists, and isn't overwritten; choose another name, or remove it";
  expectRefused("tiny.toml", "tiny.toml" + remedy);
  EXPECT_EQ(read("tiny.toml"), tiny);
  fs::create_symlink("nowhere", folder() / "link.toml");
  expectRefused("link.toml", "link.toml" + remedy);
  fs::create_directory(folder() / "folder.toml");
  expectRefused("folder.toml", "folder.toml" + remedy);
}

TEST_F(New, RefusesNamesThatNoSceneCanHave) {
  expectRefused("my", "my: the name of a scene's file ends in .toml, as my.toml does");
  expectRefused("my.txt", "my.txt: the name of a scene's file ends in .toml, as my.toml does");
  expectRefused(
      ".my.toml",
      ".my.toml: the scene's name \".my\" begins with a dot, as names of hidden files do; "
      "choose another");
  expectRefused("no/such/folder.toml",
                "no/such/folder.toml: there is no folder no/such; make it, or choose another");
}

TEST_F(New, PrintsNothingIfItIsToBeQuiet) {
  const ChildResult result = run({"new", "-q", "x.toml"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "");
  EXPECT_TRUE(has("x.toml"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
