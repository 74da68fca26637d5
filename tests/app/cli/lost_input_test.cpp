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
    write("covered.toml", "book.back = \"book.png\"\n" + std::string(kTiny));
  }
};

TEST_F(LostInput, IsNoScene) {
  const std::string scene = "the scene itself";
  fs::create_directory(folder() / "in");
  fs::create_hard_link(folder() / "tiny.toml", folder() / "in/hard.toml");
  for (const char* output : {"tiny.toml", "./in/../tiny.toml", "in/hard.toml"}) {
    expectKept("tiny.toml", scene, {"still", "tiny.toml", "--time", "0", "-o", output});
    expectKept("tiny.toml", scene, {"still", "tiny.toml", "-o", output, "--count", "2"});
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

TEST_F(LostInput, IsNoFileOfAnotherFormat) {
  write("clip.mp4", "a clip");
  const auto expectRefused = [this](const std::vector<std::string>& arguments,
                                    const std::string& message) {
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, "rotatebook: " + message + '\n');
    EXPECT_EQ(read("clip.mp4"), "a clip");
  };
  const std::string png = "-o clip.mp4: the name of the file must end in .png";
  expectRefused({"still", "tiny.toml", "-o", "clip.mp4"}, png);
  expectRefused({"still", "tiny.toml", "-o", "clip.mp4", "--count", "2"}, png);
  expectRefused({"diff", "a.png", "b.png", "-o", "clip.mp4"}, png);
  expectRefused({"simulate", "tiny.toml", "--csv", "clip.mp4"},
                "--csv clip.mp4: the name of the file must end in .csv");
}

TEST_F(LostInput, IsNoTexture) {
  makeCover();
  fs::create_symlink("book.png", folder() / "link.png");
  const std::string texture = "a texture of the scene covered";
  for (const char* output : {"book.png", "link.png"}) {
    expectKept("book.png", texture, {"still", "covered.toml", "--time", "0", "-o", output});
    expectKept("book.png", texture, {"still", "tiny.toml", "covered.toml", "-o", output});
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

// Whatever a render writes, moves or removes: unfinished videos, folders that it fills and
// replaces, their records, and temporary files that it takes for stale ones.
TEST_F(LostInput, IsNoTextureUnderAnyNameOfARender) {
  makeCover();
  for (const std::string name :
       {"covered.partial.mp4", "covered.partial.gif", "covered.gif", "covered/frames.manifest",
        "covered/frames.xxh128", "covered.replaced/frame_00000.png", "covered.replaced/cover.png",
        "covered.partial/frame_00000.png", "covered.partial/more/cover.png",
        "covered/.x.rotatebook-0", "covered/frames.xyz.xxh128",
        ".covered.mp4.rotatebook-01234567-0123456789ab-99999"}) {
    fs::create_directories((folder() / name).parent_path());
    fs::copy_file(folder() / "book.png", folder() / name);
    expectKept(name, "a texture of the scene covered",
               {"render", "covered.toml", "-o", ".", "--overwrite", "--format", "mp4,gif", "--set",
                "book.back=" + name});
    fs::remove(folder() / name);
  }
}

TEST_F(LostInput, IsNoTextureBehindALink) {
  makeCover();
  fs::create_directory(folder() / "covered.partial");
  fs::copy_file(folder() / "book.png", folder() / "covered.partial/frame_00000.png");
  fs::create_symlink("covered.partial", folder() / "folder");
  fs::create_symlink("folder/frame_00000.png", folder() / "first.png");
  fs::create_symlink("first.png", folder() / "second.png");
  for (const char* name : {"folder/frame_00000.png", "second.png"}) {
    expectKept(name, "a texture of the scene covered",
               {"render", "covered.toml", "-o", ".", "--overwrite", "--set",
                std::string("book.back=") + name});
  }
}

TEST_F(LostInput, IsNoTableOfWords) {
  for (const char* name : {"tiny/scene.toml", "tiny.partial/french.words"}) {
    write(name, "Energy = \"Énergie\"\n");
    expectKept(name, "a table of words of the scene tiny",
               {"render", "tiny.toml", "-o", ".", "--set", std::string("overlay.words=") + name});
  }
}

TEST_F(LostInput, IsNoSceneUnderAnyNameOfARender) {
  for (const char* name :
       {"scene.partial/scene.toml", "scene.replaced/scene.toml", "tiny.partial/tiny.toml"}) {
    write(name, kTiny);
    expectKept(name, "the scene itself", {"render", name, "-o", "."});
  }
}

TEST_F(LostInput, MayLieBesideTheFrames) {
  makeCover();
  fs::create_directory(folder() / "covered");
  fs::copy_file(folder() / "book.png", folder() / "covered/cover.png");
  for (int time = 0; time < 2; ++time) {
    const ChildResult result =
        run({"render", "covered.toml", "-o", ".", "--set", "book.back=covered/cover.png"});
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_TRUE(read("covered/cover.png") == read("book.png"));
  }
}

TEST_F(LostInput, IsNoPartOfAStudyOrAPage) {
  makeCover();
  fs::copy_file(folder() / "book.png", folder() / "covered-study.png");
  expectKept(
      "covered-study.png", "a texture of the scene covered",
      {"study", "covered.toml", "tiny.toml", "-o", ".", "--set", "book.back=covered-study.png"});
  write("index.html", kTiny);
  expectKept("index.html", "the scene itself", {"page", "index.html", "-o", "."});
}

TEST_F(LostInput, IsNoClipThatWasInterrupted) {
  ASSERT_EQ(run({"render", "tiny.toml", "-o", ".", "--no-png"}).status, 0);
  fs::rename(folder() / "tiny.mp4", folder() / "tiny.partial.mp4");
  for (const char* flag : {"--overwrite", "--resume", "--png"}) {
    expectKept("tiny.partial.mp4", "the clip itself",
               {"verify", "tiny.partial.mp4", "--again", ".", flag});
  }
}

TEST_F(LostInput, IsNoFrameToAssemble) {
  ASSERT_EQ(run({"render", "tiny.toml", "-o", ".", "--no-mp4"}).status, 0);
  fs::create_symlink("tiny/frame_00003.png", folder() / "tiny.apng");
  expectKept("tiny/frame_00003.png", "one of the frames", {"assemble", "tiny", "-o", "tiny.apng"});
}

TEST_F(LostInput, IsNoTextureOfAnotherScene) {
  makeCover();
  fs::rename(folder() / "book.png", folder() / "tiny.poster.png");
  write("covered.toml", "book.back = \"tiny.poster.png\"\n" + std::string(kTiny));
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
             {"verify", "first/covered.mp4", "--again", ".", "--scene-folder", "."});
}

TEST_F(LostInput, IsNoPictureToCompare) {
  makeCover();
  fs::copy_file(folder() / "book.png", folder() / "copy.png");
  for (const char* output : {"book.png", "./copy.png"}) {
    expectKept(output, "one of the pictures to compare",
               {"diff", "book.png", "copy.png", "-o", output});
  }
}

TEST_F(LostInput, IsNoTableOfAnotherClipNorAFileOfAnotherKind) {
  write("tiny_exact.toml", kTiny);
  const std::string panel = std::string(kTiny) + "[[panel]]\nlabel = \"Exact\"\nbody.mass = 2\n";
  write("panels.toml", panel + "[[panel]]\nlabel = \"b\"\n");
  const ChildResult scene = run({"simulate", "panels.toml", "--csv", "tiny.toml"});
  EXPECT_EQ(scene.status, 2);
  EXPECT_THAT(scene.error, HasSubstr("tiny_exact.toml: the name of the file must end in .csv"));
  EXPECT_EQ(read("tiny_exact.toml"), kTiny);

  ASSERT_EQ(run({"render", "tiny_exact.toml", "--no-png", "--no-mp4"}).status, 0);
  const std::string table = read("out/tiny_exact.csv");
  const ChildResult other = run({"simulate", "panels.toml", "--csv", "out/tiny.csv"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.error, HasSubstr("out/tiny_exact.csv belongs to the clip tiny_exact, and the "
                                     "table would replace it; name another file with --csv"));
  EXPECT_TRUE(read("out/tiny_exact.csv") == table);
  EXPECT_EQ(run({"simulate", "panels.toml", "--csv", "t.csv"}).status, 0);
  EXPECT_EQ(run({"simulate", "panels.toml", "--csv", "t.csv"}).status, 0) << "its own tables";
}

TEST_F(LostInput, IsNoTableUnderTheNameOfAnotherClip) {
  const std::string name = "tiny-study";
  write(name + ".toml", kTiny);
  ASSERT_EQ(run({"render", name + ".toml", "--no-png", "--no-mp4"}).status, 0);
  const std::string table = read("out/" + name + ".csv");
  const std::string problem = "out/tiny-study.csv belongs to the clip tiny-study, and the ";
  const ChildResult study = run({"study", "tiny.toml", "--steps", "1,2", "--integrators", "rk4"});
  EXPECT_EQ(study.status, 2);
  EXPECT_THAT(study.error, HasSubstr(problem + "study of tiny would replace it; name another"));
  const ChildResult other = run({"simulate", "tiny.toml", "--csv", "out/tiny-study.csv"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.error, HasSubstr(problem + "table would replace it; name another file"));
  EXPECT_TRUE(read("out/" + name + ".csv") == table);
  EXPECT_EQ(run({"simulate", name + ".toml", "--csv", "out/tiny-study.csv"}).status, 0)
      << "its own";
}

}  // namespace
}  // namespace rotatebook::cli::testing
