#include "page/pack_folder.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "page/made_folder.h"
#include "system/read_file.h"
#include "system/temporary_files.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::touch;

std::vector<std::string> namesInFolder(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

TEST(PackMark, ReadsBackWhatItWrites) {
  const PackFiles files{{"a b.mp4", {{"0a", "1b"}, {"0c", ""}}}, {"index.html", {{"0d", ""}}}};
  EXPECT_EQ(parsePackMark(packMarkText(files)), files);
  EXPECT_FALSE(parsePackMark("mine\n"));
  EXPECT_FALSE(parsePackMark(""));
}

TEST(PackFolder, IsMarkedBeforeItsFirstFile) {
  const fs::path folder = emptyFolder() / "site";
  const PackFolder pack(folder, {"a.txt"});
  EXPECT_THAT(namesInFolder(folder), ElementsAre(kPackMark));
  EXPECT_NO_THROW(PackFolder(folder, {"a.txt"}));
}

TEST(PackFolder, TakesOneInWhichAProcessWasKilledBeforeTheMark) {
  const fs::path folder = emptyFolder() / "site";
  fs::create_directories(folder);
  touch(system::temporaryNameFor(folder / kPackMark).string() + "7");
  EXPECT_NO_THROW(PackFolder(folder, {"a.txt"}));
}

// Whatever the instant, the mark knows the file that is there: the earlier one or the new one.
TEST(PackFolder, IsNoLinkToAnother) {
  const fs::path folder = emptyFolder();
  fs::create_directories(folder / "theirs");
  fs::create_directory_symlink("theirs", folder / "site");
  EXPECT_THROW(PackFolder(folder / "site", {"a.txt"}), InputError);
  EXPECT_THROW(PackFolder(folder / "site/", {"a.txt"}), InputError);
  EXPECT_TRUE(fs::is_empty(folder / "theirs"));
}

TEST(PackFolder, KnowsAFileBeforeItIsThere) {
  const fs::path folder = emptyFolder() / "site";
  PackFolder pack(folder, {"a.txt"});
  pack.write("a.txt", "one");
  const std::string markOfOne = system::readFileOrEmpty(folder / kPackMark);
  pack.write("a.txt", "two");
  EXPECT_NO_THROW(PackFolder::requireUsable(folder, {"a.txt"}));
  system::writeFileAtomically(folder / "a.txt", "one");
  EXPECT_NO_THROW(PackFolder::requireUsable(folder, {"a.txt"})) << "killed before the new one";
  pack.finish();
  EXPECT_THROW(PackFolder::requireUsable(folder, {"a.txt"}), InputError) << "but not later";
}

TEST(PackFolder, KeepsWhatIsMadeFromTheSame) {
  const fs::path folder = emptyFolder() / "site";
  PackFolder pack(folder, {"a.txt"});
  pack.write("a.txt", "source", [](system::AtomicFile& file) { file.write("one"); });
  EXPECT_TRUE(PackFolder(folder, {"a.txt"}).has("a.txt", "source"));
  EXPECT_FALSE(pack.has("a.txt", "another"));
  EXPECT_FALSE(pack.has("b.txt", "source"));
  touch(folder / "a.txt");
  EXPECT_FALSE(pack.has("a.txt", "source"));
}

TEST(PackFolder, RemovesOnlyWhatItWrote) {
  const fs::path folder = emptyFolder() / "site";
  PackFolder pack(folder, {"a.txt", "b.txt"});
  pack.write("a.txt", "one");
  pack.write("b.txt", "two");
  touch(folder / "b.txt");
  touch(folder / "mine.txt");
  pack.remove();
  EXPECT_THAT(namesInFolder(folder), ElementsAre("b.txt", "mine.txt"));
  fs::remove(folder / "b.txt");
  fs::remove(folder / "mine.txt");
  PackFolder(folder, {"a.txt"}).remove();
  EXPECT_FALSE(fs::exists(folder));
}

}  // namespace
}  // namespace rotatebook::page
