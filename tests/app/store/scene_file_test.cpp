#include "store/scene_file.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/parse.h"
#include "scene/scene_text.h"
#include "system/atomic_file.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

class SceneFileTest : public testing::Test {
 protected:
  SceneFileTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  fs::path write(const std::string& name, const std::string& content) const {
    system::writeFileAtomically(folder_ / name, content);
    return folder_ / name;
  }

  /// The message without the folder's path, which is the machine's.
  std::string errorOfFile(const fs::path& path) const {
    try {
      readScene(path);
      return "no error";
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string prefix = folder_.string() + "/";
      for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
        message.erase(at, prefix.size());
      }
      return message;
    }
  }

  const fs::path folder_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "scene_file";
};

TEST_F(SceneFileTest, IsReadAndNamedAfterItsFile) {
  const scene::Scene scene =
      readScene(write("fig 3.v2.toml", "title = 'T'\n" + std::string(scene::kSpin)));
  EXPECT_EQ(scene.title, "T");
  EXPECT_EQ(scene.name, "fig 3.v2");
  EXPECT_EQ(scene.folder, folder_);
}

TEST_F(SceneFileTest, TakesOverrides) {
  const fs::path path = write("a.toml", scene::kSpin);
  EXPECT_EQ(readScene(path, std::vector<std::string>{"video.crf=3"}).video.crf, 3);
}

std::string sceneWithWords(const std::string& file) {
  return std::string(scene::kSpin) + "[overlay]\nwords = \"" + file + "\"\n";
}

TEST_F(SceneFileTest, HasTheWordsOfTheFileThatItNames) {
  fs::create_directories(folder_ / "words");
  const fs::path words = write("words/french.toml", "decimal_mark = \",\"\nEnergy = \"Énergie\"\n");
  const scene::Scene scene = readScene(write("a.toml", sceneWithWords("words/french.toml")));
  EXPECT_EQ(scene.overlay.words[scene::Word::Energy], "Énergie");
  EXPECT_EQ(scene.overlay.words.decimalMark, ",");
  EXPECT_EQ(scene.wordsFile, words);
  // A record has the words themselves.
  const std::string text = scene::sceneText(scene);
  EXPECT_EQ(scene::parseScene(text, "b.toml").overlay, scene.overlay);
  EXPECT_EQ(text.find("french"), text.npos);
}

TEST_F(SceneFileTest, NamesTheFileOfAProblemWithItsWords) {
  const fs::path path = write("a.toml", sceneWithWords("a.words"));
  EXPECT_EQ(errorOfFile(path), "a.toml:4:9: can't read a.words: No such file or directory");
  write("a.words", "\n  Enrgy = \"Énergie\"\nError = 3\n");
  EXPECT_EQ(errorOfFile(path),
            "a.words:2:3: unknown key \"Enrgy\" in [overlay.words]; did you mean \"Energy\"?\n"
            "  a.words:3:9: overlay.words.Error must be a string in quotes, not 3");
}

TEST_F(SceneFileTest, HasNoWordsFromOutsideItsFolderUnlessThatIsAllowed) {
  fs::create_directories(folder_ / "inner");
  write("a.words", "Energy = \"Énergie\"\n");
  const fs::path path = write("inner/a.toml", sceneWithWords("../a.words"));
  EXPECT_EQ(errorOfFile(path),
            "inner/a.toml:4:9: can't read inner/../a.words: it leads outside the scene's folder, "
            "which --allow-outside allows");
  const scene::Scene scene = readScene(path, {}, /*allowOutside=*/true);
  EXPECT_EQ(scene.overlay.words[scene::Word::Energy], "Énergie");
  EXPECT_TRUE(scene.allowOutside);
}

TEST_F(SceneFileTest, NamesTheFileOfAProblem) {
  EXPECT_EQ(errorOfFile(write("a.toml", "\n  titel = 3\n")),
            "a.toml:2:3: unknown key \"titel\"; did you mean \"title\"?");
}

TEST_F(SceneFileTest, SuggestsTheNearestNameForAMissingOne) {
  write("tumble.toml", scene::kSpin);
  write("sumble.toml~", scene::kSpin);  // As near as the scene, and earlier in the alphabet.
  EXPECT_EQ(errorOfFile(folder_ / "sumble.toml"),
            "sumble.toml: scene not found; did you mean \"tumble.toml\"?");
  EXPECT_EQ(errorOfFile(folder_ / "tumble"),
            "tumble: scene not found; did you mean \"tumble.toml\"?");
  write("s.toml", scene::kSpin);
  EXPECT_EQ(errorOfFile(folder_ / "q"), "q: scene not found");
  EXPECT_EQ(errorOfFile(folder_ / "spin.toml"), "spin.toml: scene not found");
  EXPECT_EQ(errorOfFile(folder_ / "missing" / "a.toml"), "missing/a.toml: scene not found");
}

TEST_F(SceneFileTest, RefusesAFolder) {
  fs::create_directories(folder_ / "a.toml");
  EXPECT_EQ(errorOfFile(folder_ / "a.toml"), "a.toml: a folder, not a scene");
}

TEST_F(SceneFileTest, RefusesAFileThatIsTooLong) {
  EXPECT_EQ(errorOfFile(write("long.toml", std::string(32'769, '#'))),
            "long.toml: can't be read: it has 32769 bytes; the limit is 32768");
  // Without reading it.
  fs::resize_file(folder_ / "long.toml", 100'000'000);
  EXPECT_EQ(errorOfFile(folder_ / "long.toml"),
            "long.toml: can't be read: it has 100000000 bytes; the limit is 32768");
}

TEST_F(SceneFileTest, RefusesDevicesAndPipes) {
  EXPECT_EQ(errorOfFile("/dev/zero"), "/dev/zero: can't be read: it is a device, not a file");
}

TEST_F(SceneFileTest, SaysWhyAFileCannotBeRead) {
  // A file that even the superuser may open but not read from its beginning.
  try {
    readScene("/proc/self/mem");
    FAIL() << "no error";
  } catch (const MachineError& error) {
    EXPECT_STREQ(error.what(), "can't read /proc/self/mem: Input/output error");
  }
}

// A printed scene states a mesh's numbers, as records do, and not what it looks like.
TEST_F(SceneFileTest, APrintedSceneHasItsMesh) {
  write("tetrahedron.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string text =
      "[body]\nmesh = 'tetrahedron.obj'\ndensity = 700\n[initial]\nangular_velocity = [0, 4, 0]\n";
  std::string printed = scene::sceneText(readScene(write("stated.toml", text)));
  const scene::Scene again = readScene(write("printed.toml", printed));
  EXPECT_NE(again.motions[0].solid.mesh.content, nullptr);
  EXPECT_EQ(scene::sceneText(again), printed);
  const std::string volume = "volume = 0.16666666666666666";
  ASSERT_NE(printed.find(volume), std::string::npos) << printed;
  printed.replace(printed.find(volume), volume.size(), "volume = 0.2");
  EXPECT_THAT(errorOfFile(write("false.toml", printed)),
              testing::EndsWith(": the file \"tetrahedron.obj\" has changed: it is another body"));
}

}  // namespace
}  // namespace rotatebook::store
