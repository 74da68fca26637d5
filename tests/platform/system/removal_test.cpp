#include "system/removal.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "system/atomic_file.h"

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

/// A folder that every user may enter, with a file in it; removed at the end.
class Removal : public ::testing::Test {
 protected:
  Removal() {
    chmod(top_.c_str(), 0755);
    fs::create_directory(folder_);
    writeFileAtomically(folder_ / "file", "x");
  }
  ~Removal() override {
    chmod(folder_.c_str(), 0755);
    fs::remove_all(top_);
  }

  const fs::path top_ = [] {
    std::string name = (fs::temp_directory_path() / "rotatebook-test-XXXXXX").string();
    return fs::path(mkdtemp(name.data()));
  }();
  const fs::path folder_ = top_ / "folder";
};

/// Prints what `obstacle` returns to a user who isn't the superuser, and ends the process.
template <typename Obstacle>
[[noreturn]] void printAsUser(const Obstacle& obstacle) {
  constexpr uid_t kNobody = 65534;
  const bool dropped = geteuid() != 0 || setuid(kNobody) == 0;
  std::cerr << (dropped ? "[" + obstacle() + "]" : "can't be another user") << std::endl;
  _exit(0);
}

TEST_F(Removal, OfOwnFilesIsPossible) {
  EXPECT_EQ(obstacleToRemoval(folder_), "");
  EXPECT_EQ(obstacleToRemoval(folder_ / "file"), "");
  EXPECT_EQ(obstacleToRemoval(folder_ / "missing"), "");
  EXPECT_EQ(obstacleToEmptying(folder_), "");
}

TEST_F(Removal, FromAFolderThatMayNotBeChangedIsNotPossible) {
  chmod(folder_.c_str(), 0555);
  const auto obstacles = [&] {
    return obstacleToEmptying(folder_) + "|" + obstacleToRemoval(folder_ / "file");
  };
  const std::string obstacle = "Permission denied; " + folder_.string() + " belongs to [^|]+";
  EXPECT_EXIT(printAsUser(obstacles), ::testing::ExitedWithCode(0),
              "\\[" + obstacle + "\\|" + obstacle + "\\]");
}

TEST_F(Removal, OfAFolderThatMayNotBeChangedIsPossibleWhereItStays) {
  fs::create_directory(folder_ / "inner");
  chmod((folder_ / "inner").c_str(), 0555);
  chmod(folder_.c_str(), 0777);
  const auto obstacles = [&] {
    return obstacleToEmptying(folder_) + "|" + obstacleToMovingFolders(folder_);
  };
  EXPECT_EXIT(printAsUser(obstacles), ::testing::ExitedWithCode(0),
              "\\[\\|Permission denied; .*inner belongs to .*\\]");
  chmod((folder_ / "inner").c_str(), 0777);
  EXPECT_EQ(obstacleToMovingFolders(folder_), "");
}

TEST_F(Removal, OfAnotherUsersFileFromAStickyFolderIsNotPossible) {
  if (geteuid() != 0) GTEST_SKIP() << "there is no other user";
  chmod(folder_.c_str(), 01777);
  const auto obstacle = [&] { return obstacleToEmptying(folder_); };
  EXPECT_EXIT(printAsUser(obstacle), ::testing::ExitedWithCode(0),
              "file belongs to root, and .* lets users remove only their own files");
  ASSERT_EQ(chown((folder_ / "file").c_str(), 65534, 65534), 0);
  EXPECT_EXIT(printAsUser(obstacle), ::testing::ExitedWithCode(0), "\\[\\]");
}

}  // namespace
}  // namespace rotatebook::system
