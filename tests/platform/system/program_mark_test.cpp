#include "system/program_mark.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace rotatebook::system {
namespace {

using std::string_literals::operator""s;

const std::string kPngEnd = "\0\0\0\0IEND\xae\x42\x60\x82"s;

std::filesystem::path fileWith(const std::string& bytes) {
  const std::filesystem::path file = std::filesystem::path(ROTATEBOOK_TEST_OUTPUT) / "program-mark";
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

TEST(ProgramMark, IsBeforeTheEndOfAPictureAndChangesNothingElse) {
  for (const std::string& end : {kPngEnd, ";"s, "</svg>\n"s, "%%EOF\n"s}) {
    for (const std::size_t length : {0U, 10U, 1000U}) {
      const std::string start(length, 'x');
      std::string bytes = start + end;
      addProgramMark(bytes);
      EXPECT_TRUE(bytes.starts_with(start) && bytes.ends_with(end));
      EXPECT_NE(bytes.find("rotatebook", length), bytes.npos);
      EXPECT_TRUE(hasProgramMark(fileWith(bytes)));
      EXPECT_TRUE(hasProgramMark(fileWith(bytes + "x"))) << "a damaged file is the program's";
      const auto file = fileWith(start + end);
      EXPECT_FALSE(hasProgramMark(file));
      addProgramMark(file);
      std::ifstream stream(file, std::ios::binary);
      EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), bytes);
    }
  }
}

TEST(ProgramMark, IsInNoOtherFile) {
  EXPECT_FALSE(hasProgramMark(fileWith("")));
  EXPECT_FALSE(hasProgramMark(fileWith("rotatebook")));
  EXPECT_FALSE(hasProgramMark("/no/such/file"));
  std::string text = "text";
  EXPECT_THROW(addProgramMark(text), std::logic_error);
}

}  // namespace
}  // namespace rotatebook::system
