// Recordings with single rows that are wrong, held or dropped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "timeline/recorded_table.h"

namespace rotatebook::timeline {
namespace {

using physics::Integrator;
using physics::Sample;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Samples = std::vector<Sample>;

/// Returns what turns the attitude of a row.
std::function<void(Samples&)> strayAt(std::size_t row, double degrees) {
  return [=](Samples& samples) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, -1, 2).normalized();
    samples[row].attitude = samples[row].attitude * Eigen::AngleAxisd(degrees * kDegree, axis);
  };
}

/// Returns what repeats the row before at `count` rows of `every` so many.
std::function<void(Samples&)> held(std::size_t first, std::size_t count, std::size_t every) {
  return [=](Samples& samples) {
    for (std::size_t i = first; i + count <= samples.size(); i += every) {
      for (std::size_t k = i; k < i + count; ++k) {
        samples[k].attitude = samples[k - 1].attitude;
        samples[k].angularVelocity = samples[k - 1].angularVelocity;
      }
    }
  };
}

/// Returns what drops rows, though the times go on as before.
std::function<void(Samples&)> dropped(std::size_t first, std::size_t count) {
  return [=](Samples& samples) {
    for (std::size_t i = samples.size() - 1; i >= first + count; --i)
      samples[i].time = samples[i - count].time;
    const auto from = samples.begin() + static_cast<std::ptrdiff_t>(first);
    samples.erase(from, from + static_cast<std::ptrdiff_t>(count));
  };
}

/// Returns the verdicts on a table with rates and without them.
std::vector<Verdict> verdictsOn(const std::function<void(Samples&)>& spoil,
                                const physics::MotionSettings& motion = exactBook()) {
  return {verdictOnText(textOf(motion, {.spoil = spoil})),
          verdictOnText(textOf(motion, {.rates = "", .spoil = spoil}))};
}

TEST(FlawedRecording, ARightOneHasNone) {
  for (const Table& table : {Table{}, Table{.rates = ""}, Table{.noise = 2e-3, .rateNoise = 1e-2},
                             Table{.rates = "", .noise = 2e-3}}) {
    EXPECT_THAT(verdictOnText(textOf(exactBook(), table)).flaws, IsEmpty());
    EXPECT_THAT(verdictOnText(textOf(exactBook(8), table)).flaws, IsEmpty());
    EXPECT_THAT(verdictOnText(textOf(thrownBook(Integrator::ExplicitGyroscopic), table)).flaws,
                IsEmpty());
  }
}

TEST(FlawedRecording, AStrayAttitudeIsNamed) {
  for (const std::size_t row : {std::size_t{0}, std::size_t{3}, std::size_t{300}}) {
    for (const double degrees : {3.0, 40.0, 170.0}) {
      for (const Verdict& verdict : verdictsOn(strayAt(row, degrees))) {
        EXPECT_TRUE(agreesWithExact(verdict)) << row << ": " << methodThat(verdict);
        ASSERT_EQ(verdict.flaws.size(), 1U) << row << ": " << methodThat(verdict);
        EXPECT_MESSAGE(methodThat(verdict));
        EXPECT_NEAR(verdict.errorDeg, degrees, 0.1);  // measured 0.06 at the first row
      }
    }
  }
  EXPECT_THAT(verdictsOn(strayAt(300, 40)).front().flaws,
              ElementsAre("1 row is off its neighbours: the attitude at 5 s, by 40 degrees"));
}

TEST(FlawedRecording, NeighboursMayBeStrayTogether) {
  const auto spoil = [](Samples& samples) {
    strayAt(300, 30)(samples);
    strayAt(301, 50)(samples);
  };
  for (const Verdict& verdict : verdictsOn(spoil)) {
    EXPECT_TRUE(agreesWithExact(verdict)) << methodThat(verdict);
    EXPECT_THAT(verdict.flaws,
                ElementsAre("2 rows are off their neighbours: the attitude at 5 s, by 30 degrees; "
                            "the attitude at 5.0167 s, by 50 degrees"));
  }
}

TEST(FlawedRecording, UncertainTimesAreNoFlaw) {
  const auto spoil = [](Samples& samples) {
    Noise noise;
    for (std::size_t i = 1; i < samples.size(); ++i) samples[i].time += 1e-3 * noise.next();
  };
  for (const Verdict& verdict : verdictsOn(spoil)) {
    EXPECT_TRUE(agreesWithExact(verdict)) << methodThat(verdict);
    EXPECT_THAT(verdict.flaws, IsEmpty());
  }
}

TEST(FlawedRecording, FlawsAreNamedBesideWhatIsWrongWithTheTable) {
  const Table table{.areAlongBody = true, .spoil = strayAt(300, 40)};
  try {
    verdictOnText(textOf(exactBook(), table));
    FAIL() << "is judged";
  } catch (const recording::ContradictionError& error) {
    EXPECT_MESSAGE(error.what());
  }
}

TEST(FlawedRecording, StrayRatesAreNamed) {
  const auto spoil = [](Samples& samples) { samples[300].angularVelocity.x() += 3; };
  const Verdict verdict = verdictsOn(spoil).front();
  EXPECT_TRUE(agreesWithExact(verdict)) << methodThat(verdict);
  EXPECT_THAT(verdict.flaws,
              ElementsAre("1 row is off its neighbours: the rates at 5 s, by 3 rad/s"));
}

TEST(FlawedRecording, HeldRowsAreNamed) {
  for (const Verdict& verdict : verdictsOn(held(1, 1, 2))) {
    EXPECT_TRUE(agreesWithExact(verdict)) << methodThat(verdict);
    EXPECT_THAT(verdict.flaws, ElementsAre("300 rows repeat the attitude of the row before, as "
                                           "held or coarsely rounded readings do, the first at "
                                           "0.01667 s"));
  }
  for (const Verdict& verdict : verdictsOn(held(300, 10, 1000))) {
    EXPECT_TRUE(agreesWithExact(verdict)) << methodThat(verdict);
    EXPECT_MESSAGE(methodThat(verdict));
  }
}

// The rates in it are of the attitudes' slopes: none at first, though the body moves.
TEST(FlawedRecording, HeldRowsAtFirstAreNoRest) {
  const std::string text = textOf(exactBook(), {.rates = "", .spoil = held(1, 9, 10)});
  try {
    verdictOnText(text);
    FAIL() << "is judged";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "m.csv: the body moves, but the first rows repeat one attitude; leave out rows "
                 "that repeat the one before, or state where these end in simulation.from, or with "
                 "--from");
  }
}

TEST(FlawedRecording, DroppedRowsAreNamed) {
  for (const std::size_t count : {1U, 2U}) {
    for (const Verdict& verdict : verdictsOn(dropped(250, count))) {
      EXPECT_TRUE(agreesWithExact(verdict)) << count << ": " << methodThat(verdict);
      EXPECT_THAT(verdict.flaws,
                  ElementsAre("rows seem dropped, as the body turns by a multiple there: " +
                              std::to_string(count) + " after 4.15 s"));
    }
  }
}

TEST(FlawedRecording, NoiseHidesNoFlaw) {
  const Table table{.noise = 2e-3, .rateNoise = 1e-2, .spoil = strayAt(300, 40)};
  const Verdict verdict = verdictOnText(textOf(exactBook(), table));
  EXPECT_TRUE(agreesWithExact(verdict)) << methodThat(verdict);
  EXPECT_MESSAGE(methodThat(verdict));
}

TEST(FlawedRecording, WrongStepsAreStillNamed) {
  for (const Verdict& verdict :
       verdictsOn(strayAt(300, 40), thrownBook(Integrator::ExplicitGyroscopic))) {
    EXPECT_EQ(verdict.errs, Errs::GainsBoth) << methodThat(verdict);
    EXPECT_EQ(verdict.flaws.size(), 1U);
  }
}

}  // namespace
}  // namespace rotatebook::timeline
