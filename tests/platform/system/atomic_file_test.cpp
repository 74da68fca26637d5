#include "system/atomic_file.h"

#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "system/file_descriptor.h"
#include "system/temporary_files.h"

namespace rotatebook {
namespace {

namespace fs = std::filesystem;

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
  system::writeFileAtomically(folder_ / "a.txt", "first");
  system::writeFileAtomically(folder_ / "a.txt", "second");
  EXPECT_EQ(contentOf(folder_ / "a.txt"), "second");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFileTest, LeavesTheOldFileAndNothingElseWithoutCommit) {
  system::writeFileAtomically(folder_ / "a.txt", "kept");
  {
    system::AtomicFile file(folder_ / "a.txt");
    std::ofstream(file.temporaryPath()) << "half";
    EXPECT_EQ(filesInFolder(), 2);
  }
  EXPECT_EQ(contentOf(folder_ / "a.txt"), "kept");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFileTest, OfAProcessThatIsKilledIsRemovedByTheNext) {
  const pid_t child = fork();
  if (child == 0) {
    const system::AtomicFile file(folder_ / "a.txt");
    _exit(0);  // As good as a kill: no destructor runs.
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  ASSERT_EQ(filesInFolder(), 1) << "nothing was left";
  const system::AtomicFile mine(folder_ / "b.txt");
  EXPECT_EQ(filesInFolder(), 1);
  system::removeStaleTemporaries(folder_);
  EXPECT_TRUE(fs::exists(mine.temporaryPath())) << "a file was taken from who writes it";
}

TEST_F(AtomicFileTest, NothingElseIsTakenForOneThatWasLeft) {
  for (const char* name : {".a.rotatebook-", ".a.rotatebook-1", "a.rotatebook-0", ".a.tmp-1"}) {
    std::ofstream(folder_ / name) << "kept";
  }
  ASSERT_EQ(mkfifo((folder_ / ".pipe").c_str(), 0600), 0);
  system::removeStaleTemporaries(folder_);
  EXPECT_EQ(filesInFolder(), 5);
  system::removeStaleTemporaries(folder_ / "missing");
}

TEST_F(AtomicFileTest, ReplacesNothingThatIsNew) {
  EXPECT_TRUE(system::createFileAtomically(folder_ / "a.txt", "first"));
  EXPECT_FALSE(system::createFileAtomically(folder_ / "a.txt", "second"));
  EXPECT_EQ(contentOf(folder_ / "a.txt"), "first");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFileTest, OfSeveralProcessesOneMakesAFile) {
  for (int round = 0; round < 20; ++round) {
    const fs::path path = folder_ / std::to_string(round);
    int made = 0;
    std::vector<pid_t> children;
    for (int i = 0; i < 4; ++i) {
      children.push_back(fork());
      if (children.back() != 0) continue;
      _exit(system::createFileAtomically(path, std::to_string(i)) ? 1 : 0);
    }
    for (const pid_t child : children) {
      int status = 0;
      ASSERT_EQ(waitpid(child, &status, 0), child);
      made += WEXITSTATUS(status);
    }
    EXPECT_EQ(made, 1);
  }
  EXPECT_EQ(filesInFolder(), 20);
}

// One may open the file under its temporary name before another gives it its final one, and lock it
// after: it mustn't empty it then.
TEST_F(AtomicFileTest, OfSeveralThreadsNoneTakesAnothersFinishedFile) {
  constexpr int kTimes = 50'000;
  const fs::path path = folder_ / ".tile", finished = folder_ / "tile";
  const auto writeOften = [&] {
    int lost = 0;
    for (int i = 0; i < kTimes; ++i) {
      const system::FileDescriptor file = system::createLocked(path, system::Lock::Exclusive);
      if (file.isOpen() && std::rename(path.c_str(), finished.c_str()) != 0) ++lost;
    }
    return lost;
  };
  std::vector<std::future<int>> threads;
  for (int i = 0; i < 8; ++i) threads.push_back(std::async(std::launch::async, writeOften));
  for (auto& thread : threads) EXPECT_EQ(thread.get(), 0);
}

TEST_F(AtomicFileTest, UseIsSharedOrNot) {
  const fs::path clip = folder_ / "clip";
  {
    const system::AdvisoryLock one(clip, system::Lock::Shared), other(clip, system::Lock::Shared);
    EXPECT_THROW(system::AdvisoryLock(clip, system::Lock::Exclusive), MachineError);
  }
  EXPECT_EQ(filesInFolder(), 0);
  {
    const system::AdvisoryLock alone(clip, system::Lock::Exclusive);
    EXPECT_THROW(system::AdvisoryLock(clip, system::Lock::Shared), MachineError);
    system::removeStaleTemporaries(folder_);
    EXPECT_EQ(filesInFolder(), 1) << "a lock in use was removed";
  }
  EXPECT_EQ(filesInFolder(), 0);
}

TEST_F(AtomicFileTest, NamesTheMissingFolderAndTheCause) {
  try {
    system::AtomicFile file(folder_ / "missing" / "a.txt");
    FAIL() << "no error";
  } catch (const MachineError& error) {
    EXPECT_MESSAGE(error.what());
  }
}

TEST_F(AtomicFileTest, RefusesAFolderOfThatName) {
  EXPECT_THROW(system::AtomicFile file(folder_), MachineError);
}

TEST_F(AtomicFileTest, SaysWhyANameIsNone) {
  const fs::path path = folder_ / std::string(300, 'x');
  try {
    const system::AtomicFile file(path);
    FAIL();
  } catch (const MachineError& error) {
    EXPECT_EQ(error.what(), "can't write " + path.string() + ": File name too long");
  }
}

TEST_F(AtomicFileTest, RefusesToReplaceAPipe) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(system::AtomicFile file(pipe), MachineError);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(AtomicFileTest, WaitsForNoPipeInThePlaceOfItsOwnFiles) {
  ASSERT_EQ(mkfifo((folder_ / ".a.txt.rotatebook-0").c_str(), 0600), 0);
  EXPECT_THROW(system::AdvisoryLock(folder_ / "a.txt", system::Lock::Shared), MachineError);
  const fs::path own = system::temporaryNameFor(folder_ / "a.txt");
  system::writeFileAtomically(folder_ / "b.txt", "");  // Has tidied up.
  ASSERT_EQ(mkfifo(own.c_str(), 0600), 0);
  const system::FileDescriptor reader(open(own.c_str(), O_RDONLY | O_NONBLOCK));
  EXPECT_THROW(system::AtomicFile file(folder_ / "a.txt"), MachineError);
}

// Who tidies up holds it for an instant.
TEST_F(AtomicFileTest, IsWrittenThoughAnotherTidiesUp) {
  const fs::path own = system::temporaryNameFor(folder_ / "a.txt");
  system::writeFileAtomically(folder_ / "b.txt", "");
  system::FileDescriptor other = system::createLocked(own, system::Lock::Exclusive);
  std::thread tidier([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    fs::remove(own);
    other = {};
  });
  EXPECT_NO_THROW(system::writeFileAtomically(folder_ / "a.txt", "whole"));
  tidier.join();
  EXPECT_EQ(contentOf(folder_ / "a.txt"), "whole");
}

TEST_F(AtomicFileTest, FoldersStopAtAFileInTheWay) {
  system::writeFileAtomically(folder_ / "file", "");
  EXPECT_THROW(system::createFolders(folder_ / "file" / "below"), MachineError);
  EXPECT_THROW(system::createFolders(folder_ / "file"), MachineError);
  EXPECT_NO_THROW(system::createFolders(folder_ / "a" / "b"));
}

}  // namespace
}  // namespace rotatebook
