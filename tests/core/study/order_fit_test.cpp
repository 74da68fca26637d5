#include "study/order_fit.h"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::study {
namespace {

constexpr double kFitBound = 1e-13;   // measured 2e-15
constexpr double kFloorEffect = 0.1;  // of an order of 4 or 6; measured 0.015
constexpr double kLongest = 0.5;      // [s]

/// Errors of runs whose steps are halved again and again.
std::vector<ErrorAtStep> runsOf(int count, const std::function<double(double)>& error) {
  std::vector<ErrorAtStep> runs;
  for (int i = 0; i < count; ++i) {
    const double h = std::ldexp(kLongest, -i);
    runs.push_back({h, error(h)});
  }
  return runs;
}

TEST(FitOrder, FindsAPowerLawExactly) {
  for (const double order : {0.5, 1.0, 2.0, 4.0, 6.0}) {
    const OrderFit fit = fitOrder(runsOf(8, [&](double h) { return 3 * std::pow(h, order); }));
    EXPECT_NEAR(fit.order, order, kFitBound);
    EXPECT_EQ(fit.runs, 8);
    EXPECT_EQ(fit.longest, kLongest);
    EXPECT_EQ(fit.shortest, kLongest / 128);
  }
}

TEST(FitOrder, TakesRunsInAnyOrder) {
  std::vector<ErrorAtStep> runs{{0.1, 0.01}, {0.4, 0.16}, {0.2, 0.04}};
  EXPECT_NEAR(fitOrder(runs).order, 2, kFitBound);
}

TEST(FitOrder, IsTheLeastSquaresLine) {
  // log2 of the errors is 0, 1, 1, so that the slope is 1/2 and not that of any two.
  EXPECT_NEAR(fitOrder(std::vector<ErrorAtStep>{{1, 1}, {2, 2}, {4, 2}}).order, 0.5, kFitBound);
}

TEST(FitOrder, LeavesOutSaturatedErrorsAndWhatLiesBeyond) {
  const auto error = [](double h) {
    // The longest steps happen to end near the truth.
    return h > 0.3 ? 1.0 : h > 0.1 ? 170.0 : 400 * std::pow(h, 4);
  };
  const OrderFit fit = fitOrder(runsOf(8, error));
  EXPECT_NEAR(fit.order, 4, kFitBound);
  EXPECT_EQ(fit.longest, kLongest / 8);
  EXPECT_EQ(fit.runs, 5);
}

TEST(FitOrder, LeavesOutAFloor) {
  for (const double order : {4.0, 6.0}) {
    const OrderFit fit =
        fitOrder(runsOf(16, [&](double h) { return 2 * std::pow(h, order) + 1e-10; }));
    EXPECT_NEAR(fit.order, order, kFloorEffect);
    EXPECT_GE(fit.runs, 4);
    EXPECT_GT(2 * std::pow(fit.shortest, order), 8e-10);
  }
}

TEST(FitOrder, LeavesOutRoundingThatGrowsWithTheSteps) {
  const OrderFit fit = fitOrder(runsOf(18, [](double h) { return 2 * h * h + 1e-13 / h; }));
  EXPECT_NEAR(fit.order, 2, kFloorEffect);
  EXPECT_GE(fit.runs, 10);
}

TEST(FitOrder, LeavesNothingOutBesideAGentleBend) {
  const OrderFit fit = fitOrder(runsOf(6, [](double h) { return 2 * h * (1 + h); }));
  EXPECT_EQ(fit.runs, 6);
  EXPECT_NEAR(fit.order, 1, 0.15);  // measured 0.107
}

TEST(FitOrder, FindsNoneInTooFewRuns) {
  EXPECT_TRUE(std::isnan(fitOrder({}).order));
  const OrderFit fit = fitOrder(runsOf(2, [](double h) { return h; }));
  EXPECT_TRUE(std::isnan(fit.order));
  EXPECT_EQ(fit.runs, 2);
  EXPECT_TRUE(std::isnan(fitOrder(runsOf(9, [](double) { return 90.0; })).order));
  EXPECT_EQ(fitOrder(runsOf(9, [](double) { return 90.0; })).runs, 0);
}

TEST(FitOrder, FindsNoneInErrorsThatAreNoneOrNoNumbers) {
  EXPECT_TRUE(std::isnan(fitOrder(runsOf(9, [](double) { return 0.0; })).order));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(fitOrder(runsOf(9, [&](double) { return nan; })).order));
}

TEST(FitOrder, FindsNoneInRoundingAlone) {
  const OrderFit fit = fitOrder(runsOf(11, [](double h) { return 1e-14 / std::sqrt(h); }));
  EXPECT_TRUE(std::isnan(fit.order));
}

}  // namespace
}  // namespace rotatebook::study
