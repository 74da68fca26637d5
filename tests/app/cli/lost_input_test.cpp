// Results that would take the place of what they are made from.
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class LostInput : public ProgramTest {
 protected:
  /// Expects that a command which would write over `input` is refused for it.
  void expectKept(const std::string& input, const std::string& what,
                  const std::vector<std::string>& arguments) const {
    const std::string before = read(input);
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments.front();
    EXPECT_THAT(result.error, HasSubstr(" is " + what));
    EXPECT_THAT(result.error, HasSubstr("; name another "));
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_TRUE(read(input) == before) << arguments.front() << " changed " << input;
  }

  /// book.png, and a scene that has it for a cover.
  void makeCover() const {
    ASSERT_EQ(run({"still", "tiny.toml", "--time", "0", "-o", "book.png"}).status, 0);
    write("covered.toml", std::string(kTiny) + "[book]\nback = \"book.png\"\n");
  }
};

TEST_F(LostInput, IsNoScene) {
  const std::string scene = "the scene itself";
  fs::create_directory(folder() / "in");
  fs::create_hard_link(folder() / "tiny.toml", folder() / "in/hard.toml");
  for (const char* output : {"tiny.toml", "./in/../tiny.toml", "in/hard.toml"}) {
    expectKept("tiny.toml", scene, {"still", "tiny.toml", "--time", "0", "-o", output});
    expectKept("tiny.toml", scene, {"sheet", "tiny.toml", "-o", output});
    expectKept("tiny.toml", scene, {"simulate", "tiny.toml", "--csv", output});
  }
  write("table.csv", kTiny);
  expectKept("table.csv", scene, {"render", "tiny.toml", "table.csv", "-o", "."});
  write("scene/scene.toml", kTiny);
  expectKept("scene/scene.toml", scene, {"render", "scene/scene.toml", "-o", "."});
  expectKept("scene/scene.toml", scene,
             {"render", "scene/scene.toml", "-o", ".", "--frames", "0:2"});
  EXPECT_FALSE(has("tiny.mp4"));
}

TEST_F(LostInput, IsNoTexture) {
  makeCover();
  fs::create_symlink("book.png", folder() / "link.png");
  const std::string texture = "a texture of the scene covered";
  for (const char* output : {"book.png", "link.png"}) {
    expectKept("book.png", texture, {"still", "covered.toml", "--time", "0", "-o", output});
    expectKept("book.png", texture, {"sheet", "tiny.toml", "covered.toml", "-o", output});
  }
}

TEST_F(LostInput, IsNoTextureThatLiesWhereARenderWrites) {
  makeCover();
  const std::string texture = "a texture of the scene covered";
  const auto renderWith = [](const std::string& back, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "render");
    for (const char* word : {"-o", ".", "--set"}) arguments.push_back(word);
    arguments.push_back("book.back=" + back);
    return arguments;
  };
  for (const char* name : {"covered.poster.png", "covered/frame_00001.png"}) {
    fs::create_directories((folder() / name).parent_path());
    fs::copy_file(folder() / "book.png", folder() / name);
    expectKept(name, texture, renderWith(name, {"covered.toml"}));
  }
  // A part has no poster.
  fs::remove_all(folder() / "covered");
  const ChildResult part =
      run(renderWith("covered.poster.png", {"covered.toml", "--frames", "3:5", "--no-png"}));
  EXPECT_EQ(part.status, 0) << part.error;
}

TEST_F(LostInput, IsNoTextureOfAnotherScene) {
  makeCover();
  fs::rename(folder() / "book.png", folder() / "tiny.poster.png");
  write("covered.toml", std::string(kTiny) + "[book]\nback = \"tiny.poster.png\"\n");
  expectKept("tiny.poster.png", "a texture of the scene covered",
             {"render", "tiny.toml", "covered.toml", "-o", "."});
}

TEST_F(LostInput, IsNoTextureOfAClipToMakeAgain) {
  makeCover();
  fs::rename(folder() / "book.png", folder() / "covered.poster.png");
  ASSERT_EQ(run({"render", "covered.toml", "-o", "first", "--set", "book.back=covered.poster.png"})
                .status,
            0);
  expectKept("covered.poster.png", "a texture of the scene covered",
             {"rerun", "first/covered.mp4", "-o", ".", "--scene-folder", "."});
}

TEST_F(LostInput, IsNoPictureToCompare) {
  makeCover();
  fs::copy_file(folder() / "book.png", folder() / "copy.png");
  for (const char* output : {"book.png", "./copy.png"}) {
    expectKept(output, "one of the pictures to compare",
               {"diff", "book.png", "copy.png", "-o", output});
  }
}

}  // namespace
}  // namespace rotatebook::cli::testing
