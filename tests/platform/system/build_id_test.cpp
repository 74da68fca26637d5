#include "system/build_id.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "system/file_checksum.h"

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

TEST(BuildId, DISABLED_IsPrinted) {
  std::printf("> %s\n", buildId().c_str());
}

/// Returns what the test above prints as a process of its own, begun with `words`.
std::string printedBy(const std::string& words) {
  const fs::path output = fs::path(ROTATEBOOK_TEST_OUTPUT) / "build_id.txt";
  const std::string command =
      words + " --gtest_also_run_disabled_tests --gtest_filter=BuildId.DISABLED_IsPrinted" +
      " | sed -n 's/^> //p' > '" + output.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(output);
  std::string line;
  std::getline(file, line);
  return line;
}

TEST(BuildId, IsTheProgramsWhoeverLoadsIt) {
  const std::string own = "'" + fs::read_symlink("/proc/self/exe").string() + "'";
  EXPECT_EQ(printedBy(own), buildId());
  EXPECT_EQ(printedBy("/lib64/ld-linux-x86-64.so.2 " + own), buildId());
  EXPECT_NE(buildId(), checksumOfFile("/lib64/ld-linux-x86-64.so.2"));
}

TEST(BuildId, StaysWhenTheFileIsStripped) {
  const fs::path copy = fs::path(ROTATEBOOK_TEST_OUTPUT) / "stripped_test";
  const std::string strip = "strip -o '" + copy.string() + "' /proc/$PPID/exe";
  ASSERT_EQ(std::system(strip.c_str()), 0);
  EXPECT_NE(checksumOfFile(copy), checksumOfFile("/proc/self/exe"));
  EXPECT_EQ(printedBy("'" + copy.string() + "'"), buildId());
}

// As readelf shows it: a linker that writes none is a program without a build id, and a checksum.
TEST(BuildId, IsTheLinkers) {
  const fs::path output = fs::path(ROTATEBOOK_TEST_OUTPUT) / "build_id_notes.txt";
  const std::string command = "readelf -n /proc/$PPID/exe > '" + output.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(output);
  const std::string notes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(notes.find("Build ID: " + buildId()), std::string::npos) << notes;
}

}  // namespace
}  // namespace rotatebook::system
