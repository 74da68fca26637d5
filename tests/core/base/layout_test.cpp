#include "base/layout.h"

#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Returns the message about a program that was built with `layout`; "" if there is none.
std::string refusal(const Layout& layout) {
  try {
    requireSameLayout(layout);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Layout, IsTheSameHere) {
  EXPECT_EQ(refusal(layoutHere()), "");
  EXPECT_TRUE(noteLayout(kLayoutHere));
  EXPECT_NO_THROW(requireSameLayout());
}

TEST(Layout, OfAnotherVersionIsRefused) {
  Layout other = layoutHere();
  other.version = "9.8.7";
  other.fastMath = !other.fastMath;  // Not read: another version may have other members.
  EXPECT_EQ(refusal(other), "this is rotatebook " + std::string(kVersion) +
                                ", but this program was built with the headers of 9.8.7; build it "
                                "with the headers of the library that it links");
}

TEST(Layout, WithAnotherFlagIsRefusedByItsName) {
  for (const auto& [flag, name] :
       {std::pair{&Layout::eigenDoesNotVectorize, "-DEIGEN_DONT_VECTORIZE"},
        std::pair{&Layout::eigenIsRowMajor, "-DEIGEN_DEFAULT_TO_ROW_MAJOR"},
        std::pair{&Layout::contractionIsOff, "-ffp-contract=off"},
        std::pair{&Layout::fastMath, "-ffast-math"},
        std::pair{&Layout::associativeMath, "-fassociative-math"},
        std::pair{&Layout::reciprocalMath, "-freciprocal-math"},
        std::pair{&Layout::noSignedZeros, "-fno-signed-zeros"},
        std::pair{&Layout::finiteMathOnly, "-ffinite-math-only"}}) {
    Layout other = layoutHere();
    const std::string here = other.*flag ? "with " : "without ";
    const std::string there = other.*flag ? "without" : "with";
    other.*flag = !(other.*flag);
    EXPECT_THAT(refusal(other), AllOf(HasSubstr("rotatebook was built " + here + name +
                                                ", this program " + there + " it; "),
                                      testing::ContainsRegex("; (link|build)")));
  }
}

}  // namespace
}  // namespace rotatebook
