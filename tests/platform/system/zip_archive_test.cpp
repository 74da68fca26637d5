#include "system/zip_archive.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"

namespace rotatebook {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string bytesOf(system::MemoryZip& archive) {
  std::string bytes;
  archive.finish([&](std::string_view piece) { bytes += piece; });
  return bytes;
}

TEST(MemoryZip, HoldsFilesAsTheyAreWithoutTheirTimes) {
  const std::filesystem::path file =
      std::filesystem::path(ROTATEBOOK_TEST_OUTPUT) / "zip_archive_test.txt";
  std::string first;
  for (const int hours : {1, 9}) {
    std::ofstream(file) << std::string(99, 'x');
    std::filesystem::last_write_time(
        file, std::filesystem::file_time_type::clock::now() - std::chrono::hours(hours));
    system::MemoryZip archive("can't make it");
    archive.addFile(file.string(), "a.txt");
    archive.addBytes("yyyyy", "b.txt", 0x1986, std::string(7, '\0'));
    const std::string bytes = bytesOf(archive);
    EXPECT_THAT(bytes, StartsWith("PK\x03\x04"));
    EXPECT_THAT(bytes, HasSubstr(std::string(99, 'x')));
    EXPECT_THAT(bytes, HasSubstr("yyyyy"));
    if (first.empty()) first = bytes;
    EXPECT_EQ(bytes, first);
  }
}

TEST(MemoryZip, SaysWhatFailed) {
  system::MemoryZip archive("can't make it");
  archive.addFile("/nonexistent", "a.txt");
  try {
    bytesOf(archive);
    FAIL() << "there is no such file";
  } catch (const MachineError& error) {
    EXPECT_MESSAGE(error.what());
  }
}

}  // namespace
}  // namespace rotatebook
