// Verdicts on recordings: right motions, however they were measured, and wrong ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "timeline/recorded_table.h"

namespace rotatebook::timeline {
namespace {

using physics::Integrator;
using ::testing::AllOf;
using ::testing::HasSubstr;

const Table kAttitudesAlone{.rates = ""};

Eigen::Vector3d bookWith(double factorOfX) {
  return {factorOfX * kThrownBook.x(), kThrownBook.y(), kThrownBook.z()};
}

TEST(VerdictOnRecordings, ExactTablesAgree) {
  for (const Table& table : {Table{}, kAttitudesAlone}) {
    const Verdict verdict = verdictOnText(textOf(exactBook(), table));
    EXPECT_TRUE(verdict.errs == Errs::Hardly || verdict.errs == Errs::HardlyAsFitted)
        << methodThat(verdict);
    EXPECT_LT(verdict.errorDeg, 0.2);  // measured 0.07 of slopes
    EXPECT_EQ(verdict.halfTurns, verdict.halfTurnsDue);
  }
}

TEST(VerdictOnRecordings, StepsThatKeepEnergyArentAccusedOfGainingItByTheirSlopes) {
  const Verdict alone = verdictOnText(textOf(thrownBook(Integrator::Midpoint), kAttitudesAlone));
  EXPECT_TRUE(alone.errs == Errs::HardlyAsFitted || alone.errs == Errs::InPhase)
      << methodThat(alone);
  EXPECT_NEAR(alone.spins.uncertainty, 3.44e-4, 1e-5);
  EXPECT_EQ(verdictOnText(textOf(thrownBook(Integrator::Midpoint), {})).errs, Errs::InPhase);
}

TEST(VerdictOnRecordings, AnInertiaThatIsStatedWrongSwings) {
  for (const double factor : {1.01, 0.99, 1.05}) {
    const Verdict verdict = verdictOnText(textOf(exactBook(), {}), bookWith(factor));
    EXPECT_EQ(verdict.errs, Errs::Swings) << factor << ": " << methodThat(verdict);
  }
  const Verdict alone = verdictOnText(textOf(exactBook(), kAttitudesAlone), bookWith(1.001));
  EXPECT_TRUE(alone.errs == Errs::HardlyAsFitted || alone.errs == Errs::InPhase)
      << methodThat(alone);
}

TEST(VerdictOnRecordings, AnInertiaThatIsStatedWrongIsSaidWhereChangesAreSmall) {
  for (const Errs errs : {Errs::GainsBoth, Errs::LosesBoth, Errs::InPhase}) {
    Verdict verdict{.isRecorded = true, .energyDrift = 0.01, .errs = errs};
    EXPECT_MESSAGE(methodThat(verdict));
    verdict.isRecorded = false;  // A scene's inertia is its own.
    EXPECT_MESSAGE(methodThat(verdict));
  }
  EXPECT_TRUE(verdictOnText(textOf(exactBook(), {})).isRecorded);
  // Steps of a method change more.
  const auto explicitBook = thrownBook(Integrator::ExplicitGyroscopic, 60);
  EXPECT_MESSAGE(methodThat(verdictOnText(textOf(explicitBook, {}))));
}

TEST(VerdictOnRecordings, NoiseIsNoFaultOfTheMotion) {
  for (const double noise : {1e-4, 1e-3}) {
    Table table = kAttitudesAlone;
    table.noise = 2 * noise;  // as noise of each part of the quaternion makes it [rad]
    const Verdict verdict = verdictOnText(textOf(exactBook(), table));
    EXPECT_EQ(verdict.errs, Errs::HardlyAsFitted) << noise << ": " << methodThat(verdict);
    EXPECT_LT(verdict.errorDeg, 1000 * noise);  // measured 402
    table = {.noise = 2 * noise, .rateNoise = 10 * noise};
    const Verdict rated = verdictOnText(textOf(exactBook(), table));
    EXPECT_TRUE(rated.errs == Errs::Hardly || rated.errs == Errs::HardlyAsFitted)
        << noise << ": " << methodThat(rated);
  }
}

TEST(VerdictOnRecordings, NoiseHidesNoWrongSteps) {
  for (const bool hasRates : {false, true}) {
    Table table{.noise = 2e-4, .rateNoise = 1e-3};
    if (!hasRates) table.rates = "";
    EXPECT_EQ(verdictOnText(textOf(thrownBook(Integrator::ExplicitGyroscopic), table)).errs,
              Errs::GainsBoth);
    EXPECT_EQ(verdictOnText(textOf(thrownBook(Integrator::ImplicitGyroscopic), table)).errs,
              Errs::LosesBoth);
    EXPECT_EQ(verdictOnText(textOf(thrownBook(Integrator::Euler), table)).errs, Errs::GainsEnergy);
  }
}

TEST(VerdictOnRecordings, AMomentumThatTurnsIsNoMethods) {
  Table inverse = kAttitudesAlone;
  inverse.isInverse = true;
  const Verdict conjugated = verdictOnText(textOf(exactBook(), inverse));
  EXPECT_EQ(conjugated.errs, Errs::TurnsMomentum) << methodThat(conjugated);
  EXPECT_GT(conjugated.momentumTurnDeg, 90);
  const Eigen::Vector3d swapped{kThrownBook.x(), kThrownBook.z(), kThrownBook.y()};
  const Verdict other = verdictOnText(textOf(exactBook(), {}), swapped);
  EXPECT_EQ(other.errs, Errs::TurnsMomentum) << methodThat(other);
  EXPECT_MESSAGE(methodThat(other));
}

TEST(VerdictOnRecordings, CoarseExplicitStepsAreStillExplicit) {
  const Verdict verdict = verdictOnText(textOf(thrownBook(Integrator::ExplicitGyroscopic, 25), {}));
  EXPECT_EQ(verdict.errs, Errs::GainsBoth);
  EXPECT_GT(verdict.momentumTurnDeg, kTurnsDeg);  // measured 11.6
}

TEST(VerdictOnRecordings, AttitudesTooFarApartArentJudged) {
  const Verdict verdict = verdictOnText(textOf(exactBook(5), kAttitudesAlone));
  EXPECT_EQ(verdict.errs, Errs::TooFewAttitudes) << methodThat(verdict);
  EXPECT_GT(verdict.spins.uncertainty, 0.03);  // measured 0.046
  EXPECT_MESSAGE(methodThat(verdict));
  EXPECT_EQ(verdictOnText(textOf(exactBook(10), kAttitudesAlone)).errs, Errs::HardlyAsFitted);
}

TEST(VerdictOnRecordings, NoiseMakesNoFlip) {
  const Eigen::Vector3d moments{0.0053132, 0.0046304, 0.0028877};
  physics::MotionSettings motion = exactBook();
  motion.inertia = moments.asDiagonal();
  motion.initial.value = {-3.1083, -1.9114, -1.7279};  // Tilted by 117 degrees: 120 count as far.
  Table table = kAttitudesAlone;
  table.noise = 0.003;  // 0.17 degrees [rad]
  table.seconds = 6;
  for (table.seed = 1; table.seed <= 20; ++table.seed) {
    const Verdict verdict = verdictOnText(textOf(motion, table), moments);
    EXPECT_EQ(verdict.errs, Errs::HardlyAsFitted) << table.seed << ": " << methodThat(verdict);
  }
}

TEST(VerdictOnRecordings, AttitudesWithNoiseAreToBeFartherApart) {
  Table noisy = kAttitudesAlone;
  noisy.noise = 0.004;  // of attitudes, 0.23 degrees [rad]
  const Verdict verdict = verdictOnText(textOf(exactBook(480), noisy));
  EXPECT_EQ(verdict.errs, Errs::TooFewAttitudes) << methodThat(verdict);
  EXPECT_MESSAGE(methodThat(verdict));
  EXPECT_EQ(verdictOnText(textOf(exactBook(36), noisy)).errs, Errs::HardlyAsFitted);
}

/// Returns a gyroscope's table of the exact motion, without `missing` rows of each 60.
std::string gyroscopeText(int missing, const Eigen::Vector3d& factors = {1, 1, 1}) {
  std::string text = "time_s,gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)\n";
  int row = 0;
  for (const physics::Sample& sample : physics::simulate(exactBook(), std::int64_t{600}).samples) {
    if (++row % 60 < missing) continue;
    text += shortestText(sample.time);
    const Eigen::Vector3d rate = sample.attitude.conjugate() * sample.angularVelocity;
    for (const double one : rate.cwiseProduct(factors).eval()) text += "," + shortestText(one);
    text += "\n";
  }
  return text;
}

// Gaps of 0.4 s in each second, in which the body turns by 2.5 rad: the readings are right.
TEST(VerdictOnRecordings, ReadingsTooFarApartArentJudged) {
  EXPECT_EQ(verdictOnText(gyroscopeText(0)).errs, Errs::Hardly);
  const Verdict verdict = verdictOnText(gyroscopeText(24));
  EXPECT_EQ(verdict.errs, Errs::TooFewReadings) << methodThat(verdict);
  EXPECT_FALSE(isJudged(verdict));
  EXPECT_MESSAGE(methodThat(verdict));
  EXPECT_GT(verdict.errorDeg, kAgreesDeg);
  // Energy tells all the same that a scale is wrong
  EXPECT_TRUE(isJudged(verdictOnText(gyroscopeText(24, {1, 1.1, 1}))));
}

TEST(VerdictOnRecordings, RatesOfAnotherMomentAreNoMotionsFault) {
  const Verdict verdict = verdictOnText(textOf(exactBook(), {.ratesDelay = 1}));
  EXPECT_EQ(verdict.errs, Errs::RatesAreOff) << methodThat(verdict);
  EXPECT_MESSAGE(methodThat(verdict));
  EXPECT_LT(verdict.errorDeg, 0.2);  // measured 0.07 of slopes
}

TEST(VerdictOnRecordings, RatesOfAnotherMomentAreNoLongSteps) {
  // Off by enough that energy and L are kept, but the pace isn't.
  physics::MotionSettings motion = exactBook();
  motion.initial.value = {6.28, 0.3, 0.06};
  for (const auto* rates : {"wx,wy,wz", "gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)"}) {
    const Table table{.rates = rates, .areAlongBody = rates[0] == 'g', .ratesDelay = 1};
    const Verdict verdict = verdictOnText(textOf(motion, table));
    EXPECT_EQ(verdict.errs, Errs::RatesAreOff) << methodThat(verdict);
  }
}

// Rates of the row before, which are off by less than a hundredth.
TEST(VerdictOnRecordings, RatesAShortStepLateAreNoMotionsFault) {
  Table table{.rates = "gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)", .areAlongBody = true};
  table.ratesDelay = 1;
  const Verdict verdict = verdictOnText(textOf(exactBook(160), table));
  EXPECT_EQ(verdict.errs, Errs::RatesAreOff) << methodThat(verdict);
  EXPECT_LT(verdict.spins.difference, 0.01);  // measured 0.0094
}

TEST(VerdictOnRecordings, RoundedRatesAreNoMotionsFault) {
  for (const double step : {0.01, 0.03, 0.1}) {
    const Verdict verdict = verdictOnText(textOf(exactBook(240), {.rateStep = step}));
    EXPECT_MESSAGE(methodThat(verdict));
    EXPECT_LT(verdict.errorDeg, 0.2);  // measured 1.7e-5
  }
}

TEST(VerdictOnRecordings, AMomentumThatTurnsALittleIsntKept) {
  const auto drifting = [](std::vector<physics::Sample>& samples) {
    for (physics::Sample& sample : samples) {
      const Eigen::Vector3d turn{0, 0, kDegree * sample.time};  // a degree a second
      sample.attitude = recording::rotationBy(turn) * sample.attitude;
    }
  };
  Table table = kAttitudesAlone;
  table.spoil = drifting;
  const Verdict drift = verdictOnText(textOf(exactBook(), table));
  EXPECT_EQ(drift.errs, Errs::TurnsSlightly) << methodThat(drift);
  EXPECT_MESSAGE(methodThat(drift));
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(4 * kDegree, Eigen::Vector3d::UnitY()));
  const Table turned{.rates = "gyro_x (rad/s),gyro_y (rad/s),gyro_z (rad/s)",
                     .areAlongBody = true,
                     .bodyTurn = turn};
  const Verdict verdict = verdictOnText(textOf(exactBook(), turned));
  EXPECT_EQ(verdict.errs, Errs::TurnsSlightly) << methodThat(verdict);
  EXPECT_MESSAGE(methodThat(verdict));
}

TEST(VerdictOnRecordings, AFactorOfTheRatesIsNoMotionsFault) {
  for (const double factor : {0.98, 0.995, 0.998, 1.002, 1.005, 1.02, 1.04}) {
    const Verdict verdict = verdictOnText(textOf(exactBook(), {.ratesPerUnit = 1 / factor}));
    EXPECT_EQ(verdict.errs, Errs::RatesAreOff) << factor << ": " << methodThat(verdict);
    EXPECT_NEAR(verdict.spins.fit.factor, factor, 1e-5);  // measured 6e-8
    EXPECT_LT(verdict.errorDeg, 0.2);
    EXPECT_MESSAGE(methodThat(verdict));
  }
}

TEST(VerdictOnRecordings, ABiasOfTheRatesIsNoMotionsFault) {
  for (const double bias : {0.01, 0.1}) {
    for (const bool isGyroscope : {false, true}) {
      const Table table{
          .rates = isGyroscope ? "gyrX (rad/s),gyrY (rad/s),gyrZ (rad/s)" : "wx,wy,wz",
          .areAlongBody = isGyroscope,
          .bias = {0, bias, -bias / 2}};
      const Verdict verdict = verdictOnText(textOf(exactBook(), table));
      EXPECT_EQ(verdict.errs, Errs::RatesAreOff) << bias << ": " << methodThat(verdict);
      EXPECT_NEAR((verdict.spins.fit.bias - table.bias).norm(), 0, 1e-5);  // measured 3.1e-7
      EXPECT_EQ(verdict.spins.fit.factor, 1);
      EXPECT_MESSAGE(methodThat(verdict));
    }
  }
}

TEST(VerdictOnRecordings, TurnedAxesOfTheRatesAreNoMotionsFault) {
  for (const double degrees : {0.5, 3.0, 15.0}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 2) / 3;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(degrees * kDegree, axis));
    const Table table{.rates = "gyrX (rad/s),gyrY (rad/s),gyrZ (rad/s)",
                      .areAlongBody = true,
                      .columns = turn.toRotationMatrix()};
    const Verdict verdict = verdictOnText(textOf(exactBook(), table));
    EXPECT_EQ(verdict.errs, Errs::RatesAreOff) << degrees << ": " << methodThat(verdict);
    // measured 1e-6
    EXPECT_LT((verdict.spins.fit.turn - degrees * kDegree * axis).norm(), 1e-4 * degrees);
    EXPECT_MESSAGE(methodThat(verdict));
  }
}

TEST(VerdictOnRecordings, ASteadySpinDoesntTellABiasFromTurnedAxes) {
  physics::MotionSettings steady = exactBook();
  steady.initial.value = {0.1, 6, 0.05};
  const auto textWith = [&](const Eigen::Matrix3d& columns) {
    const Table table{.rates = "gyrX (rad/s),gyrY (rad/s),gyrZ (rad/s)",
                      .areAlongBody = true,
                      .columns = columns};
    return methodThat(verdictOnText(textOf(steady, table)));
  };
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(5 * kDegree, Eigen::Vector3d::UnitZ()));
  EXPECT_THAT(textWith(turn.toRotationMatrix()),
              AllOf(HasSubstr("have a bias of (-0.523, "),
                    HasSubstr("along the body's axes, or are turned from the attitudes' slopes by "
                              "5 degrees about (0, 0, 1)")));
  // Nor a scale of one axis
  const Eigen::Vector3d scales(1.03, 1, 1);
  EXPECT_EQ(textWith(scales.asDiagonal()), "agrees with the exact motion");
}

TEST(VerdictOnRecordings, AFactorThatLongStepsMakeMayBeTheirs) {
  const Verdict verdict = verdictOnText(textOf(thrownBook(Integrator::Midpoint, 25), {}));
  EXPECT_EQ(verdict.errs, Errs::InPhase) << methodThat(verdict);
  EXPECT_NEAR(verdict.spins.fit.factor, 1 + 0.2512 * 0.2512 / 12, 1e-3);  // measured 6e-4
  EXPECT_MESSAGE(methodThat(verdict));
}

TEST(VerdictOnRecordings, NoiseChangesNoWords) {
  for (const Integrator integrator :
       {Integrator::NoGyroscopic, Integrator::ExplicitGyroscopic, Integrator::ImplicitGyroscopic}) {
    const Verdict exact = verdictOnText(textOf(thrownBook(integrator), {}));
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      for (const char* const rates : {"", "wx,wy,wz"}) {
        const Table table{.rates = rates, .noise = 2e-3, .rateNoise = 1e-2, .seed = seed};
        const Verdict noisy = verdictOnText(textOf(thrownBook(integrator), table));
        EXPECT_EQ(noisy.errs, exact.errs) << methodThat(exact) << ": " << methodThat(noisy);
        EXPECT_EQ(noisy.start, exact.start);
        EXPECT_EQ(noisy.halfTurnsDue, exact.halfTurnsDue);
      }
    }
  }
}

TEST(VerdictOnRecordings, NoiseChangesNoRegimeOfAMotionThatAgrees) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Table table{.rates = "", .noise = 2e-3, .seed = seed};
    const Verdict verdict = verdictOnText(textOf(exactBook(), table));
    EXPECT_EQ(verdict.errs, Errs::HardlyAsFitted) << methodThat(verdict);
    EXPECT_EQ(verdict.start, rigid::Regime::AboutLargest);
    EXPECT_EQ(verdict.end, rigid::Regime::AboutLargest);
    EXPECT_EQ(verdict.halfTurnsDue, 3);
  }
}

TEST(VerdictOnRecordings, AFewRowsTellNothing) {
  for (const double seconds : {1.0 / 60, 2.0 / 60, 10.0 / 60}) {
    const Verdict verdict = verdictOnText(textOf(exactBook(), {.seconds = seconds}));
    EXPECT_EQ(verdict.errs, Errs::TooFewRows);
    EXPECT_FALSE(isJudged(verdict));
    EXPECT_MESSAGE(methodThat(verdict));
  }
  EXPECT_EQ(verdictOnText(textOf(exactBook(), {.seconds = 11.0 / 60})).errs, Errs::Hardly);
}

TEST(VerdictOnRecordings, AFixedSpinIsFoundInNoise) {
  for (const char* const rates : {"", "wx,wy,wz"}) {
    const Table table{.rates = rates, .noise = 2e-4, .rateNoise = 1e-3};
    const Verdict verdict = verdictOnText(textOf(thrownBook(Integrator::NoGyroscopic), table));
    EXPECT_EQ(verdict.errs, Errs::SpinIsFixed) << methodThat(verdict);
  }
}

TEST(VerdictOnRecordings, LongStepsMayBeWithinTheUncertaintyOfTheirSlopes) {
  const Verdict verdict =
      verdictOnText(textOf(thrownBook(Integrator::Midpoint, 25), kAttitudesAlone));
  EXPECT_EQ(verdict.errs, Errs::HardlyAsFitted) << methodThat(verdict);
  EXPECT_NEAR(verdict.spins.uncertainty, 0.002, 2e-4);
  EXPECT_LT(verdict.fittedBy.value_or(1), 3 * verdict.spins.uncertainty);
}

}  // namespace
}  // namespace rotatebook::timeline
