#include "store/frame_checksums.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>

#include <gtest/gtest.h>

#include "base/checksum.h"
#include "base/error.h"
#include "messages.h"
#include "pipeline/small_clip.h"
#include "store/clip_files.h"
#include "system/atomic_file.h"
#include "system/file_checksum.h"
#include "system/temporary_files.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;
using pipeline::testing::bytesOf;
using pipeline::testing::emptyFolder;
using pipeline::testing::messageOf;

// Of "abc", by xxh128sum 0.8.1.
constexpr const char* kSumOfAbc = "06b05ab6733a618578af5f94892f3950";

void writeFrame(FrameChecksums& sums, std::int64_t index, const std::string& bytes) {
  system::writeFileAtomically(sums.folder() / frameName(index), bytes);
  sums.add(index, bytes);
}

TEST(Checksum, IsThatOfTheStandardTool) {
  EXPECT_EQ(checksumOf("abc"), kSumOfAbc);
  const fs::path file = emptyFolder() / "abc";
  system::writeFileAtomically(file, "abc");
  EXPECT_EQ(system::checksumOfFile(file), kSumOfAbc);
}

TEST(Checksum, OfAFileIsThatOfItsBytes) {
  const std::string bytes(200'001, 'x');  // More than a block.
  const fs::path file = emptyFolder() / "file";
  system::writeFileAtomically(file, bytes);
  EXPECT_EQ(system::checksumOfFile(file), checksumOf(bytes));
}

TEST(Checksum, IsOfNothingThatCannotBeRead) {
  const fs::path folder = emptyFolder();
  const std::string start = "can't read " + (folder / "file").string() + ": ";
  EXPECT_EQ(messageOf<MachineError>([&] { system::checksumOfFile(folder / "file"); }),
            start + "No such file or directory");
  ASSERT_EQ(mkfifo((folder / "file").c_str(), 0600), 0);
  EXPECT_EQ(messageOf<MachineError>([&] { system::checksumOfFile(folder / "file"); }),
            start + "it is a pipe, not a file");
}

TEST(FrameChecksums, AreNotWrittenIntoAPipe) {
  const fs::path folder = emptyFolder();
  ASSERT_EQ(mkfifo((folder / kFrameChecksumsName).c_str(), 0600), 0);
  FrameChecksums sums(folder);
  EXPECT_EQ(
      messageOf<MachineError>([&] { sums.add(0, "abc"); }),
      "can't write " + (folder / kFrameChecksumsName).string() + ": it is not a regular file");
}

TEST(FrameChecksums, HaveALineForEachFrame) {
  const fs::path folder = emptyFolder();
  FrameChecksums sums(folder);
  writeFrame(sums, 7, "abc");
  EXPECT_EQ(bytesOf(folder / kFrameChecksumsName), std::string(kSumOfAbc) + "  frame_00007.png\n");
}

TEST(FrameChecksums, OfOneProcessHaveAFileOfTheirOwn) {
  const fs::path folder = emptyFolder();
  const fs::path own = folder / partChecksumsName(system::processName());
  const fs::path other = folder / partChecksumsName("another");
  system::writeFileAtomically(folder / frameName(3), "xyz");
  std::ofstream(other) << checksumOf("xyz") + "  frame_00003.png\n";
  FrameChecksums sums(folder, FrameChecksums::File::Own);
  writeFrame(sums, 7, "abc");
  EXPECT_FALSE(fs::exists(folder / kFrameChecksumsName));
  EXPECT_EQ(bytesOf(own), std::string(kSumOfAbc) + "  frame_00007.png\n");
  EXPECT_EQ(FrameChecksums(folder).indices(), (std::vector<std::int64_t>{3, 7}));
  EXPECT_EQ(FrameChecksums(folder).intact(3), "xyz");
  EXPECT_EQ(FrameChecksums::filesIn(folder), folder / "frames*.xxh128");
  FrameChecksums(folder).sort({7, 8});
  EXPECT_EQ(bytesOf(folder / kFrameChecksumsName),
            checksumOf("xyz") + "  frame_00003.png\n" + kSumOfAbc + "  frame_00007.png\n");
  EXPECT_FALSE(fs::exists(own) || fs::exists(other));
  EXPECT_EQ(FrameChecksums::filesIn(folder), folder / kFrameChecksumsName);
}

// A join that doesn't see its lock may take them away while it still draws.
TEST(FrameChecksums, OfOneProcessAreThereAtItsEndUnlessTheyAreJoined) {
  const fs::path folder = emptyFolder();
  const fs::path own = folder / partChecksumsName(system::processName());
  FrameChecksums sums(folder, FrameChecksums::File::Own);
  writeFrame(sums, 7, "abc");
  FrameChecksums(folder).sort({7, 8});
  sums.finishOwn();
  EXPECT_FALSE(fs::exists(own));
  FrameChecksums more(folder, FrameChecksums::File::Own);
  writeFrame(more, 9, "x");
  writeFrame(more, 8, "abc");
  fs::remove(own);
  more.finishOwn();
  EXPECT_EQ(bytesOf(own), std::string(kSumOfAbc) + "  frame_00008.png\n" + checksumOf("x") +
                              "  frame_00009.png\n");
}

TEST(FrameChecksums, KnowWhatAnEarlierRunWrote) {
  const fs::path folder = emptyFolder();
  {
    FrameChecksums first(folder);
    writeFrame(first, 0, "zero");
    writeFrame(first, 1, "one");
    writeFrame(first, 2, "two");
  }
  std::ofstream(folder / frameName(1)) << "onx";
  fs::remove(folder / frameName(2));
  const FrameChecksums sums(folder);
  EXPECT_EQ(sums.intact(0), "zero");
  EXPECT_EQ(sums.intact(1), std::nullopt) << "a damaged frame";
  EXPECT_EQ(sums.intact(2), std::nullopt) << "a missing frame";
  EXPECT_EQ(sums.intact(3), std::nullopt) << "a frame without a line";
}

TEST(FrameChecksums, TakeTheLastLineOfAFrame) {
  const fs::path folder = emptyFolder();
  FrameChecksums first(folder);
  writeFrame(first, 3, "before");
  writeFrame(first, 3, "after");
  EXPECT_EQ(FrameChecksums(folder).intact(3), "after");
}

TEST(FrameChecksums, OutliveALineThatWasCutOff) {
  const fs::path folder = emptyFolder();
  {
    FrameChecksums first(folder);
    writeFrame(first, 0, "zero");
  }
  std::ofstream(folder / kFrameChecksumsName, std::ios::app) << "0123456789abcdef0123";
  {
    FrameChecksums second(folder);
    EXPECT_EQ(second.intact(0), "zero");
    writeFrame(second, 1, "one");
  }
  FrameChecksums third(folder);
  EXPECT_EQ(third.intact(1), "one");
  third.sort({0, 2});
  EXPECT_EQ(bytesOf(folder / kFrameChecksumsName),
            checksumOf("zero") + "  frame_00000.png\n" + checksumOf("one") + "  frame_00001.png\n");
}

TEST(FrameChecksums, OutliveAFirstLineThatWasCutOff) {
  const fs::path folder = emptyFolder();
  std::ofstream(folder / kFrameChecksumsName) << "0123456789abcdef0123";
  FrameChecksums sums(folder);
  writeFrame(sums, 0, "zero");
  sums.sort({0, 1});
  EXPECT_EQ(bytesOf(folder / kFrameChecksumsName), checksumOf("zero") + "  frame_00000.png\n");
}

TEST(FrameChecksums, OutliveTheirFile) {
  const fs::path folder = emptyFolder();
  FrameChecksums sums(folder);
  writeFrame(sums, 0, "zero");
  fs::remove(folder / kFrameChecksumsName);
  writeFrame(sums, 1, "one");
  sums.sort({0, 2});
  EXPECT_EQ(FrameChecksums(folder).intact(0), "zero");
}

TEST(FrameChecksums, NameTheFrameThatIsMissing) {
  const fs::path folder = emptyFolder();
  FrameChecksums sums(folder);
  writeFrame(sums, 0, "zero");
  writeFrame(sums, 2, "two");
  const std::string gone = (folder / "frame_00001.png").string() + " is gone: ";
  EXPECT_MESSAGE(messageOf<MachineError>([&] { sums.sort({0, 3}); }));
  EXPECT_MESSAGE(messageOf<MachineError>([&] { sums.requireUnchanged({0, 3}); }));
}

// As fast as it may happen, and with the size that it had.
TEST(FrameChecksums, NameTheFrameThatWasChanged) {
  const fs::path folder = emptyFolder();
  FrameChecksums sums(folder);
  for (std::int64_t frame = 0; frame < 3; ++frame) writeFrame(sums, frame, "picture");
  EXPECT_NO_THROW(sums.requireUnchanged({0, 3}));
  const auto expectNamed = [&](const FrameChecksums& checked, const std::string& bytes) {
    std::ofstream(folder / frameName(1)) << bytes;
    EXPECT_MESSAGE(messageOf<MachineError>([&] { checked.requireUnchanged({0, 3}); }));
    EXPECT_NO_THROW(checked.requireUnchanged({2, 3}));
  };
  expectNamed(sums, "");
  expectNamed(sums, "a longer one");
  system::writeFileAtomically(folder / frameName(1), "another");
  expectNamed(sums, "another");
  // Frames of an earlier run
  writeFrame(sums, 1, "picture");
  const FrameChecksums later(folder);
  for (std::int64_t frame = 0; frame < 3; ++frame) EXPECT_TRUE(later.intact(frame));
  expectNamed(later, "another");
}

TEST(FrameChecksums, AcceptAFileThatWasTouchedOrReplacedByItsCopy) {
  const fs::path folder = emptyFolder();
  FrameChecksums sums(folder);
  writeFrame(sums, 0, "picture");
  system::writeFileAtomically(folder / frameName(0), "picture");
  EXPECT_NO_THROW(sums.requireUnchanged({0, 1}));
}

TEST(FrameChecksums, TakeNoSecondLineForTheSameBytes) {
  const fs::path folder = emptyFolder();
  {
    FrameChecksums first(folder);
    writeFrame(first, 0, "zero");
    writeFrame(first, 1, "one");
  }
  const std::string before = bytesOf(folder / kFrameChecksumsName);
  FrameChecksums second(folder);
  writeFrame(second, 0, "zero");
  EXPECT_EQ(bytesOf(folder / kFrameChecksumsName), before);
  writeFrame(second, 1, "other");
  EXPECT_EQ(FrameChecksums(folder).intact(1), "other");
}

TEST(FrameChecksums, AreNotReadWhereTheyAreOfNoClip) {
  const fs::path folder = emptyFolder();
  std::ofstream(folder / kFrameChecksumsName) << "x";
  fs::resize_file(folder / kFrameChecksumsName, 300'000'000);  // Sparse.
  FrameChecksums sums(folder);
  writeFrame(sums, 0, "zero");
  EXPECT_LT(fs::file_size(folder / kFrameChecksumsName), 100U);
}

TEST(FrameChecksums, IgnoreWhatIsNoLineOfTheirs) {
  const fs::path folder = emptyFolder();
  std::ofstream(folder / kFrameChecksumsName) << "\n# words\n"
                                              << std::string(32, '0') << "  ../../frame_00001.png\n"
                                              << std::string(33, '0') << "  frame_00001.png\n";
  system::writeFileAtomically(folder / frameName(1), "one");
  EXPECT_EQ(FrameChecksums(folder).intact(1), std::nullopt);
}

}  // namespace
}  // namespace rotatebook::store
