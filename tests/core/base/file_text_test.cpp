#include "base/file_text.h"

#include <string>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

std::string fileText(const std::string& bytes) {
  std::string decoded;
  return std::string(textOfFile(bytes, decoded));
}

TEST(FileText, IsWithoutItsMark) {
  EXPECT_EQ(fileText("a"), "a");
  EXPECT_EQ(fileText("\xEF\xBB\xBF\xC2\xB0"), "\xC2\xB0");
  EXPECT_EQ(fileText(""), "");
}

TEST(FileText, IsDecodedFromUtf16) {
  // a, a degree sign, a euro sign, and a face beyond the first 65,536 letters
  const std::string little(
      "\xFF\xFE"
      "a\0\xB0\0\xAC\x20\x3D\xD8\x00\xDE",
      12);
  const std::string big("\xFE\xFF\0a\0\xB0\x20\xAC\xD8\x3D\xDE\x00", 12);
  for (const std::string& bytes : {little, big}) {
    EXPECT_EQ(fileText(bytes), "a\xC2\xB0\xE2\x82\xAC\xF0\x9F\x98\x80");
    // Without its other half the face is no letter; a byte alone is none.
    EXPECT_EQ(fileText(bytes.substr(0, 11)), "a\xC2\xB0\xE2\x82\xAC\xEF\xBF\xBD");
  }
  EXPECT_EQ(fileText("\xFF\xFE"), "");
}

}  // namespace
}  // namespace rotatebook
