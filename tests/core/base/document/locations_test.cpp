#include "base/document/locations.h"

#include <gtest/gtest.h>

namespace rotatebook::document {
namespace {

Locations locationsIn(const char* text) {
  return locationsOf(parseToml(text, "a.toml"));
}

TEST(Locations, AreThoseOfAllValues) {
  const Locations locations = locationsIn("a = 1\n[b]\nc = [2, 3]\n[[d]]\ne = 4\n[[d]]\ne = 5\n");
  EXPECT_EQ(locations.of({"a"}), "a.toml:1:5");
  EXPECT_EQ(locations.of({"b.c"}), "a.toml:3:5");
  EXPECT_EQ(locations.of({"b.c.1"}), "a.toml:3:9");
  EXPECT_EQ(locations.of({"d.1.e"}), "a.toml:7:5");
}

TEST(Locations, AreThoseOfTheFirstStatedKey) {
  const Locations locations = locationsIn("a = 1\nb = 2\n");
  EXPECT_EQ(locations.of({"c", "b", "a"}), "a.toml:2:5");
  EXPECT_EQ(locations.of({"c"}), "a.toml:1:1");
  EXPECT_EQ(Locations().of({"c"}), "");
}

TEST(Locations, ArePutBeforeWhatIsWrongThere) {
  const Locations locations = locationsIn("a = 1\nb = 2\n");
  EXPECT_EQ(locations.failAt({"b"}, [] { return 7; }), 7);
  try {
    locations.failAt({"b"}, [] { throw InputError("it is too long"); });
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.toml:2:5: it is too long");
  }
}

}  // namespace
}  // namespace rotatebook::document
