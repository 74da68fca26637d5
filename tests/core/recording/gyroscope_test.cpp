#include "recording/gyroscope.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "recording/tumbling.h"

namespace rotatebook::recording {
namespace {

double largestError(const rigid::ExactRotation& motion, const std::vector<RecordedMoment>& all) {
  double largest = 0;
  for (const RecordedMoment& moment : all) largest = std::max(largest, errorOf(motion, moment));
  return largest;
}

TEST(Gyroscope, IntegratesASteadySpinToRounding) {
  const Eigen::Vector3d spin{0, 0, 5};
  const std::vector<RecordedMoment> all = integrateRates({{0, spin}, {0.1, spin}, {0.35, spin}});
  EXPECT_NEAR(turnOf(all.back().attitude).z(), 1.75, 1e-15);  // measured 0
}

TEST(Gyroscope, IntegratesInOrderFour) {
  const rigid::ExactRotation motion = tumbling();
  const double coarse = largestError(motion, integrateRates(ratesOf(motion, 201, 0.02)));
  const double fine = largestError(motion, integrateRates(ratesOf(motion, 401, 0.01)));
  EXPECT_LT(coarse, 1e-5);                   // measured 4.4e-6 rad
  EXPECT_GT(std::log2(coarse / fine), 3.8);  // measured 3.995
}

TEST(Gyroscope, IntegratesUnevenTimesAsWell) {
  const rigid::ExactRotation motion = tumbling();
  const double coarse = largestError(motion, integrateRates(ratesOf(motion, 201, 0.02, 0.4)));
  const double fine = largestError(motion, integrateRates(ratesOf(motion, 401, 0.01, 0.4)));
  EXPECT_LT(coarse, 1e-5);                   // measured 5.5e-6 rad
  EXPECT_GT(std::log2(coarse / fine), 3.8);  // measured 3.995
}

TEST(Gyroscope, DoesntSwingWhereTimesNearlyAgree) {
  const rigid::ExactRotation motion = tumbling();
  std::vector<Rate> rates = ratesOf(motion, 201, 0.01);
  // Readings a microsecond after others, with noise
  for (std::size_t i = 10; i < rates.size(); i += 10) {
    Rate twin = rates[i];
    twin.time += 1e-6;
    twin.angularVelocity += Eigen::Vector3d(1e-3, -1e-3, 1e-3);
    rates.insert(rates.begin() + static_cast<std::ptrdiff_t>(++i), twin);
  }
  EXPECT_LT(largestError(motion, integrateRates(rates)), 2e-3);
}

TEST(Gyroscope, TurnsAreTheInverseOfRotations) {
  for (const Eigen::Vector3d& turn : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e-9, 0, 0),
                                      Eigen::Vector3d(0.3, -2, 1), Eigen::Vector3d(0, 3.1, 0)}) {
    EXPECT_LT((turnOf(rotationBy(turn)) - turn).norm(), 1e-14) << turn.transpose();
  }
}

std::vector<RecordedMoment> exactMoments(const rigid::ExactRotation& motion, int count,
                                         double interval) {
  std::vector<RecordedMoment> moments;
  for (int i = 0; i < count; ++i) {
    const double time = i * interval;
    moments.push_back({time, Eigen::Quaterniond(motion.at(time).worldFromBody),
                       motion.angularVelocityBodyAt(time)});
  }
  return moments;
}

TEST(Attitudes, AreDifferentiatedInOrderFour) {
  const rigid::ExactRotation motion = tumbling();
  const auto errorAt = [&](int count, double interval) {
    std::vector<RecordedMoment> moments = exactMoments(motion, count, interval);
    differentiateAttitudes(moments);
    double largest = 0;
    for (const RecordedMoment& moment : moments) {
      const Eigen::Vector3d exact = motion.angularVelocityBodyAt(moment.time);
      largest = std::max(largest, (moment.angularVelocity - exact).norm());
    }
    return largest;
  };
  const double coarse = errorAt(201, 0.02), fine = errorAt(401, 0.01);
  EXPECT_LT(coarse, 2e-4);                   // measured 5.7e-5 of 6.3 rad/s
  EXPECT_GT(std::log2(coarse / fine), 3.6);  // measured 4.16
}

TEST(RecordedMotion, IsBetweenItsMomentsOfOrderFour) {
  const rigid::ExactRotation motion = tumbling();
  const auto errorAt = [&](int count, double interval) {
    const RecordedMotion recorded(exactMoments(motion, count, interval));
    double largest = 0;
    for (int i = 0; i + 1 < count; ++i) {
      largest = std::max(largest, errorOf(motion, recorded.at((i + 0.4) * interval)));
    }
    return largest;
  };
  const double coarse = errorAt(101, 0.04), fine = errorAt(201, 0.02);
  EXPECT_LT(coarse, 2e-5);                   // measured 8e-6 rad
  EXPECT_GT(std::log2(coarse / fine), 3.8);  // measured 3.997
}

TEST(RecordedMotion, HasItsMomentsThemselves) {
  const rigid::ExactRotation motion = tumbling();
  const std::vector<RecordedMoment> moments = exactMoments(motion, 20, 0.1);
  const RecordedMotion recorded(moments);
  for (const RecordedMoment& moment : recorded.moments()) {
    EXPECT_EQ(recorded.at(moment.time).attitude.coeffs(), moment.attitude.coeffs());
    EXPECT_EQ(recorded.at(moment.time).angularVelocity, moment.angularVelocity);
  }
}

TEST(RecordedMotion, BeginsUnturnedAtTimeZero) {
  const rigid::ExactRotation motion = tumbling();
  std::vector<RecordedMoment> moments = exactMoments(motion, 20, 0.1);
  const Eigen::Quaterniond turn = rotationBy({1, 2, 0.5});
  for (RecordedMoment& moment : moments) {
    moment.time += 7;
    moment.attitude = turn * moment.attitude;
    moment.attitude.coeffs() *= moment.time > 7.55 ? -1 : 1;  // The other sign is the same.
  }
  const RecordedMotion recorded(moments);
  EXPECT_EQ(recorded.moments().front().attitude.coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_NEAR(recorded.duration(), 1.9, 1e-14);
  for (const RecordedMoment& moment : recorded.moments()) {
    EXPECT_LT(errorOf(motion, moment), 1e-13);
  }
}

TEST(RecordedMotion, HasParts) {
  const rigid::ExactRotation motion = tumbling();
  const RecordedMotion part = RecordedMotion(exactMoments(motion, 51, 0.02)).part(0.31, 0.69);
  EXPECT_NEAR(part.duration(), 0.38, 1e-15);
  EXPECT_EQ(part.moments().size(), 21U);  // 19 within, and the ends
  const rigid::ExactRotation rest = tumbling(part.moments().front().angularVelocity);
  for (const RecordedMoment& moment : part.moments()) {
    EXPECT_LT(errorOf(rest, moment), 1e-4);
  }
}

}  // namespace
}  // namespace rotatebook::recording
