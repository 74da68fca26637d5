#include "store/manifest.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/small_clip.h"
#include "system/atomic_file.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::emptyFolder;

const Manifest::Entries kOne{{"scene", "1"}}, kTwo{{"scene", "2"}};

TEST(Manifest, IsReadAsItWasWritten) {
  const fs::path folder = emptyFolder();
  const Manifest written{{{{"renderer", "a \"GPU\"\n\\"}, {"book.front", "x"}}, {{"a.mp4", "12"}}},
                         true,
                         {{kOne, {{"a.gif", "34"}}}, {kTwo, {{"a.webm", "56"}, {"a.apng", "78"}}}}};
  writeManifest(folder, written);
  EXPECT_EQ(readManifest(folder), written);
}

TEST(Manifest, IsReplacedOnlyIfItIsTheOneThatWasRead) {
  const fs::path folder = emptyFolder();
  const Manifest first{.own = {kOne, {}}}, second{.own = {kTwo, {}}};
  EXPECT_TRUE(replaceManifest(folder, {}, first));
  EXPECT_FALSE(replaceManifest(folder, {}, second));
  EXPECT_EQ(readManifest(folder), first);
  EXPECT_TRUE(replaceManifest(folder, first, second));
  EXPECT_FALSE(replaceManifest(folder, first, first)) << "it has been replaced meanwhile";
  EXPECT_EQ(readManifest(folder), second);
  fs::remove(folder / "frames.manifest");
  EXPECT_FALSE(replaceManifest(folder, second, first)) << "it has been taken away meanwhile";
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(Manifest, KnowsAFinishedRenderThoughOthersHaveReplacedItsFiles) {
  const fs::path folder = emptyFolder();
  writeManifest(folder, {.own = {kOne, {}}, .finished = true});
  EXPECT_TRUE(readManifest(folder)->finished);
  writeManifest(folder, {.own = {kOne, {}}, .finished = false});
  EXPECT_FALSE(readManifest(folder)->finished);
}

TEST(Manifest, HasEachFileWithTheLastRenderThatWroteIt) {
  Manifest manifest{.own = {kOne, {{"a.mp4", "1"}, {"a.csv", "1"}}}, .finished = true};
  manifest.add(kTwo, {{"a.gif", "2"}, {"a.csv", "2"}});
  EXPECT_EQ(*manifest.filesOf(kOne), (Manifest::Entries{{"a.mp4", "1"}}));
  EXPECT_EQ(*manifest.filesOf(kTwo), (Manifest::Entries{{"a.gif", "2"}, {"a.csv", "2"}}));
  manifest.add(kOne, {{"a.csv", "3"}, {"a.gif", "3"}});
  EXPECT_EQ(manifest.own.files,
            (Manifest::Entries{{"a.mp4", "1"}, {"a.csv", "3"}, {"a.gif", "3"}}));
  EXPECT_EQ(manifest.filesOf(kTwo), nullptr);
}

TEST(Manifest, BecomesThatOfAnotherRenderAndForgetsNoFile) {
  Manifest manifest{.own = {kOne, {{"a.mp4", "1"}}}, .finished = true};
  manifest.become(kTwo);
  EXPECT_EQ(manifest.own, (Manifest::Render{kTwo, {}}));
  EXPECT_EQ(*manifest.filesOf(kOne), (Manifest::Entries{{"a.mp4", "1"}}));
  manifest.become(kOne);
  EXPECT_EQ(manifest, (Manifest{{kOne, {{"a.mp4", "1"}}}, true, {}}));
}

TEST(Manifest, ThatIsMissingOrNoneIsNone) {
  const fs::path folder = emptyFolder();
  EXPECT_FALSE(readManifest(folder));
  system::writeFileAtomically(folder / kManifestName, "[made\n");
  EXPECT_FALSE(readManifest(folder));
  system::writeFileAtomically(folder / kManifestName, std::string(1'000'000, '#'));
  EXPECT_FALSE(readManifest(folder));
}

TEST(Manifest, TakesNothingButStrings) {
  const fs::path folder = emptyFolder();
  system::writeFileAtomically(
      folder / kManifestName,
      "files = 1\nother = [1, {}]\n[made]\na = 1\nb = \"x\"\nc = [\"y\"]\n");
  const auto read = readManifest(folder);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->own.made, (Manifest::Entries{{"b", "x"}}));
  EXPECT_FALSE(read->finished);
}

TEST(Manifest, ListsTheFilesBesideUnfinishedFrames) {
  Manifest manifest{.own = {{{"program", "1"}}, {{"a.mp4", "0123"}}}};
  EXPECT_EQ(parseManifest(manifestText(manifest), "text"), manifest);
  manifest.finished = true;
  EXPECT_EQ(parseManifest(manifestText(manifest), "text"), manifest);
}

}  // namespace
}  // namespace rotatebook::store
