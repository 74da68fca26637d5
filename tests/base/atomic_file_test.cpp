#include "base/atomic_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class AtomicFileTest : public testing::Test {
 protected:
  AtomicFileTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  std::ptrdiff_t filesInFolder() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  // Tests run beside each other: each has a folder of its own.
  const fs::path folder_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "atomic_file" /
                           testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(AtomicFileTest, AppearsWholeOnCommit) {
  writeFileAtomically(folder_ / "a.txt", "first");
  writeFileAtomically(folder_ / "a.txt", "second");
  EXPECT_EQ(contentOf(folder_ / "a.txt"), "second");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFileTest, LeavesTheOldFileAndNothingElseWithoutCommit) {
  writeFileAtomically(folder_ / "a.txt", "kept");
  {
    AtomicFile file(folder_ / "a.txt");
    std::ofstream(file.temporaryPath()) << "half";
    EXPECT_EQ(filesInFolder(), 2);
  }
  EXPECT_EQ(contentOf(folder_ / "a.txt"), "kept");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFileTest, NamesTheMissingFolderAndTheCause) {
  try {
    AtomicFile file(folder_ / "missing" / "a.txt");
    FAIL() << "no error";
  } catch (const MachineError& error) {
    EXPECT_THAT(error.what(), HasSubstr("missing/a.txt: No such file or directory"));
  }
}

TEST_F(AtomicFileTest, RefusesAFolderOfThatName) {
  EXPECT_THROW(AtomicFile file(folder_), MachineError);
}

TEST_F(AtomicFileTest, RefusesToReplaceAPipe) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(AtomicFile file(pipe), MachineError);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(AtomicFileTest, FoldersStopAtAFileInTheWay) {
  writeFileAtomically(folder_ / "file", "");
  EXPECT_THROW(createFolders(folder_ / "file" / "below"), MachineError);
  EXPECT_THROW(createFolders(folder_ / "file"), MachineError);
  EXPECT_NO_THROW(createFolders(folder_ / "a" / "b"));
}

}  // namespace
}  // namespace rotatebook
