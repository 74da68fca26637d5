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
    EXPECT_THAT(result.error, HasSubstr(" is " + what + ", which would be lost; name another "));
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
  EXPECT_FALSE(has("tiny.mp4"));
}

TEST_F(LostInput, IsNoTexture) {
  makeCover();
  fs::create_symlink("book.png", folder() / "link.png");
  const std::string texture = "a texture of the scene";
  for (const char* output : {"book.png", "link.png"}) {
    expectKept("book.png", texture, {"still", "covered.toml", "--time", "0", "-o", output});
    expectKept("book.png", texture, {"sheet", "tiny.toml", "covered.toml", "-o", output});
  }
  fs::rename(folder() / "book.png", folder() / "covered.poster.png");
  expectKept("covered.poster.png", texture,
             {"render", "covered.toml", "-o", ".", "--set", "book.back=covered.poster.png"});
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
