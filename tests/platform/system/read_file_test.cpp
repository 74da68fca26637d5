#include "system/read_file.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>

#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook {
namespace {

namespace fs = std::filesystem;

class ReadFile : public testing::Test {
 protected:
  ReadFile() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  fs::path write(const std::string& content) const {
    std::ofstream(folder_ / "file") << content;
    return folder_ / "file";
  }

  const fs::path folder_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "read_file";
};

std::string refusalOf(const fs::path& path, std::uintmax_t most = 100) {
  try {
    system::readFile(path, most);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST_F(ReadFile, ReadsEveryByte) {
  const std::string content("a\0\xff\n", 4);
  EXPECT_EQ(system::readFile(write(content), 4), content);
  EXPECT_EQ(system::readFile(write(""), 0), "");
  const std::string blocks(200'001, 'x');
  EXPECT_EQ(system::readFile(write(blocks), 200'001), blocks);
}

TEST_F(ReadFile, RefusesWhatIsTooLong) {
  EXPECT_EQ(refusalOf(write("12345"), 5), "");
  EXPECT_EQ(refusalOf(write("123456"), 5), "it has 6 bytes; the limit is 5");
  // Linux says that its length is 0.
  EXPECT_EQ(refusalOf("/proc/self/status", 5), "it has over 5 bytes; the limit is 5");
}

// A file with a hole, as long as none is: reading it would take hours.
TEST_F(ReadFile, RefusesItUnread) {
  fs::resize_file(write(""), 4'000'000'000'000);
  EXPECT_EQ(refusalOf(folder_ / "file"), "it has 4000000000000 bytes; the limit is 100");
}

TEST_F(ReadFile, WaitsForNothing) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusalOf(folder_ / "pipe"), "it is a pipe, not a file");
  EXPECT_EQ(refusalOf("/dev/zero"), "it is a device, not a file");
  EXPECT_EQ(refusalOf(folder_), "Is a directory");
  EXPECT_EQ(refusalOf(folder_ / "missing"), "No such file or directory");
}

TEST_F(ReadFile, OrEmptyForgivesAll) {
  EXPECT_EQ(system::readFileOrEmpty(write("abc")), "abc");
  EXPECT_EQ(system::readFileOrEmpty(folder_ / "missing"), "");
  EXPECT_EQ(system::readFileOrEmpty("/dev/zero"), "");
}

}  // namespace
}  // namespace rotatebook
