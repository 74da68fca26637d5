#include "base/nearest_name.h"

#include <array>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

constexpr std::array<std::string_view, 4> kNames{"substeps", "stiffness", "fps", "x"};

std::string nearest(std::string_view word) {
  return std::string(nearestName(word, kNames).value_or("none"));
}

TEST(NearestName, ForgivesASlipOfEveryKind) {
  EXPECT_EQ(nearest("substep"), "substeps");
  EXPECT_EQ(nearest("sub_steps"), "substeps");
  EXPECT_EQ(nearest("subsreps"), "substeps");
  EXPECT_EQ(nearest("fsp"), "fps");
}

TEST(NearestName, CountsSwappedNeighboursAsOneSlip) {
  // Three letters allow one slip; as two changes it would be refused.
  EXPECT_EQ(nearest("pfs"), "fps");
  EXPECT_EQ(nearest("spf"), "none");
}

TEST(NearestName, TakesTheNearestOfSeveral) {
  constexpr std::array<std::string_view, 3> kSimilar{"faster", "fast", "fasted"};
  EXPECT_EQ(nearestName("fastr", kSimilar), "faster");
  EXPECT_EQ(nearestName("fas", kSimilar), "fast");
}

TEST(NearestName, IgnoresCase) {
  EXPECT_EQ(nearest("X"), "x");
  EXPECT_EQ(nearest("SUBSTEPS"), "substeps");
}

TEST(NearestName, SuggestsNothingForAnotherWord) {
  EXPECT_EQ(nearest("y"), "none");
  EXPECT_EQ(nearest("colour"), "none");
  EXPECT_EQ(nearest(""), "none");
  EXPECT_EQ(nearest(std::string(10'000, 's')), "none");
}

TEST(NearestName, CompletesWhatOneAloneBeginsWith) {
  constexpr std::array<std::string_view, 3> kOptions{"output", "overwrite", "overview"};
  const auto meant = [&](std::string_view word) { return nearestName(word, kOptions); };
  EXPECT_EQ(meant("out"), "output");
  EXPECT_EQ(meant("overw"), "overwrite");
  EXPECT_EQ(meant("over"), std::nullopt);
  EXPECT_EQ(meant("ou"), std::nullopt);
}

TEST(NearestName, KnowsOtherWordsOfTheSameMeaning) {
  constexpr std::array<std::string_view, 6> kMeant{"front", "step", "deg", "s", "middle", "german"};
  const auto meant = [&](std::string_view word) { return nearestName(word, kMeant); };
  EXPECT_EQ(meant("cover"), "front");
  EXPECT_EQ(meant("dt"), "step");
  EXPECT_EQ(meant("Degrees"), "deg");
  EXPECT_EQ(meant("sec"), "s");
  EXPECT_EQ(meant("median"), "middle");
  EXPECT_EQ(meant("deutsch"), "german");
  EXPECT_EQ(nearest("cover"), "none");
}

TEST(DidYouMean, EndsAMessageOrAddsNothing) {
  EXPECT_EQ(didYouMean("substep", kNames), "; did you mean \"substeps\"?");
  EXPECT_EQ(didYouMean("colour", kNames), "");
  const std::vector<std::string_view> commands{"still", "check", "new"};
  EXPECT_EQ(didYouMean("sheet", commands), "; did you mean \"still\"?");
}

TEST(QuotedList, JoinsWithCommasAndAWord) {
  EXPECT_EQ(quotedList(kNames, "and"), R"("substeps", "stiffness", "fps" and "x")");
  EXPECT_EQ(quotedList(std::span(kNames).first(2), "or"), R"("substeps" or "stiffness")");
  EXPECT_EQ(quotedList(std::span(kNames).first(1), "or"), R"("substeps")");
}

}  // namespace
}  // namespace rotatebook
