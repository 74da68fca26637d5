#include "base/document/toml_text.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace rotatebook::document {
namespace {

TEST(TomlNumber, IsAlwaysAFloat) {
  EXPECT_EQ(tomlNumber(2), "2.0");
  EXPECT_EQ(tomlNumber(-0.0), "-0.0");
  EXPECT_EQ(tomlNumber(0.1), "0.1");
  EXPECT_EQ(tomlNumber(1e100), "1e+100");
  // All digits, and too many of them for a TOML integer.
  EXPECT_EQ(tomlNumber(1180591620717411303424.0), "1180591620717411303424.0");
}

TEST(TomlNumber, NamesWhatIsNotFinite) {
  EXPECT_EQ(tomlNumber(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(tomlNumber(std::numeric_limits<double>::quiet_NaN()), "nan");
}

}  // namespace
}  // namespace rotatebook::document
