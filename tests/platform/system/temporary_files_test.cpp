#include "system/temporary_files.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "system/file_descriptor.h"

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

/// The number of a process that has ended.
pid_t deadProcess() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

class TemporaryFiles : public ::testing::Test {
 protected:
  TemporaryFiles() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::smatch match;
    const std::string name = processName();
    if (std::regex_match(name, match, std::regex("([0-9a-f]{8})-([0-9a-f]{12})-([0-9]+)"))) {
      host_ = match[1];
      boot_ = match[2];
    }
  }

  /// Makes a temporary file of `host`, `boot` and `process`, changed `age` ago; returns its path.
  fs::path make(const std::string& host, const std::string& boot, pid_t process,
                std::chrono::hours age = std::chrono::hours(0)) const {
    const fs::path path =
        folder_ / (".a.mp4.rotatebook-" + host + '-' + boot + '-' + std::to_string(process));
    std::ofstream(path) << "half";
    fs::last_write_time(path, fs::file_time_type::clock::now() - age);
    return path;
  }

  /// Returns whether the file is removed as a stale one.
  bool isRemoved(const fs::path& path) const {
    removeStaleTemporaries(folder_);
    return !fs::exists(path);
  }

  static constexpr std::chrono::hours kYears{24 * 365 * 20};
  const std::string otherHost_ = "01234567", otherBoot_ = "0123456789ab";
  std::string host_, boot_;
  const fs::path folder_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "temporary_files" /
                           ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(TemporaryFiles, NameHostStartAndProcess) {
  EXPECT_EQ(processName(), host_ + '-' + boot_ + '-' + std::to_string(getpid()));
  EXPECT_EQ(temporaryNameFor("out/a.mp4"), "out/.a.mp4.rotatebook-" + processName());
  EXPECT_EQ(lockNameFor("out/a"), "out/.a.rotatebook-0");
  for (const std::string name :
       {".a.rotatebook-0", ".a.rotatebook-01234567-0123456789ab-1", ".a.rotatebook-0.rotatebook-0"})
    EXPECT_TRUE(isTemporaryName(name)) << name;
  for (const std::string name :
       {".a.rotatebook-", ".a.rotatebook-1", ".a.rotatebook-01234567-0123456789ab-",
        ".a.rotatebook-01234567-0123456789ab-0", "a.rotatebook-0", ".a.rotatebook-00"})
    EXPECT_FALSE(isTemporaryName(name)) << name;
}

TEST_F(TemporaryFiles, OfADeadProcessAreRemoved) {
  EXPECT_TRUE(isRemoved(make(host_, boot_, deadProcess())));
  EXPECT_TRUE(isRemoved(make(otherHost_, boot_, deadProcess()))) << "a machine may be renamed";
}

// Though nobody seems to hold it: locks of other machines may not be seen.
TEST_F(TemporaryFiles, OfALivingProcessStay) {
  EXPECT_FALSE(isRemoved(make(host_, boot_, getpid())));
  EXPECT_FALSE(isRemoved(make(host_, boot_, getppid())));
}

TEST_F(TemporaryFiles, OfAnotherMachineStay) {
  EXPECT_FALSE(isRemoved(make(otherHost_, otherBoot_, deadProcess())));
  EXPECT_FALSE(isRemoved(make(otherHost_, otherBoot_, deadProcess(), kYears)));
}

TEST_F(TemporaryFiles, OfAnEarlierStartOfThisMachineAreRemoved) {
  EXPECT_TRUE(isRemoved(make(host_, otherBoot_, deadProcess(), kYears)));
  EXPECT_TRUE(isRemoved(make(host_, otherBoot_, getpid(), kYears)));
  EXPECT_FALSE(isRemoved(make(host_, otherBoot_, deadProcess())))
      << "it is newer than this start, so another machine of the same names wrote it";
}

TEST_F(TemporaryFiles, ThatAreLockedStay) {
  const fs::path path = make(host_, boot_, deadProcess());
  const FileDescriptor file = createLocked(path, Lock::Shared);
  ASSERT_TRUE(file.isOpen());
  EXPECT_FALSE(isRemoved(path));
}

}  // namespace
}  // namespace rotatebook::system
