#include "pipeline/manifest.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::emptyFolder;

TEST(Manifest, IsReadAsItWasWritten) {
  const fs::path folder = emptyFolder();
  const Manifest written{{{"renderer", "a \"GPU\"\n\\"}, {"book.front", "x"}}, {{"a.mp4", "12"}}};
  writeManifest(folder, written);
  const auto read = readManifest(folder);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->made, written.made);
  EXPECT_EQ(read->files, written.files);
  EXPECT_TRUE(read->isComplete());
}

TEST(Manifest, ThatIsMissingOrNoneIsNone) {
  const fs::path folder = emptyFolder();
  EXPECT_FALSE(readManifest(folder));
  writeFileAtomically(folder / kManifestName, "[made\n");
  EXPECT_FALSE(readManifest(folder));
  writeFileAtomically(folder / kManifestName, std::string(1'000'000, '#'));
  EXPECT_FALSE(readManifest(folder));
}

TEST(Manifest, TakesNothingButStrings) {
  const fs::path folder = emptyFolder();
  writeFileAtomically(folder / kManifestName, "files = 1\n[made]\na = 1\nb = \"x\"\nc = [\"y\"]\n");
  const auto read = readManifest(folder);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->made, (Manifest::Entries{{"b", "x"}}));
  EXPECT_FALSE(read->isComplete());
}

}  // namespace
}  // namespace rotatebook::pipeline
