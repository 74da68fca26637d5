#include "timeline/drift.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "timeline/recorded_table.h"

namespace rotatebook::timeline {
namespace {

struct Series {
  std::vector<double> times, values;
};

template <typename ValueAt>
Series seriesOf(const ValueAt& valueAt, double unevenness = 0) {
  Series series;
  for (int i = 0; i < 400; ++i) {
    series.times.push_back(0.01 * (i + (i % 3 == 1 ? unevenness : 0)));
    series.values.push_back(valueAt(series.times.back()));
  }
  return series;
}

Drift driftOf(const Series& series) {
  return timeline::driftOf(series.values);
}

double scatterOf(const Series& series) {
  return timeline::scatterOf(series.values, series.times);
}

TEST(Drift, GrowthIsATrendThoughItWavers) {
  const Drift drift = driftOf(seriesOf([](double t) { return t + 0.3 * std::sin(9 * t); }));
  EXPECT_TRUE(drift.isTrend());
  EXPECT_GT(drift.change, 3);
  EXPECT_NEAR(drift.range, drift.rise, 1e-12);
}

TEST(Drift, ASwingIsNoTrendWhereverItEnds) {
  for (const double phase : {0.0, 0.5, 1.0, 1.6}) {
    const Drift drift = driftOf(seriesOf([&](double t) { return std::cos(3 * t + phase); }));
    EXPECT_FALSE(drift.isTrend()) << phase;
    EXPECT_NEAR(drift.range, 2, 1e-3);
  }
}

TEST(Drift, ScatterIsTheNoiseAlone) {
  for (const double unevenness : {0.0, 0.4}) {
    const auto smooth = [](double t) { return std::sin(3 * t); };
    EXPECT_LT(scatterOf(seriesOf(smooth, unevenness)), 1e-6);  // measured 4.2e-8
    Noise noise;
    Series noisy = seriesOf([&](double t) { return smooth(t) + 0.01 * noise.next(); }, unevenness);
    const double scatter = scatterOf(noisy);
    EXPECT_NEAR(scatter, 0.01, 0.0015) << unevenness;
    noisy.values[200] += 100;  // a single one that is wrong
    EXPECT_NEAR(scatterOf(noisy), scatter, 0.3 * scatter);
  }
}

TEST(Drift, AFewValuesHaveNoScatter) {
  EXPECT_EQ(timeline::scatterOf(std::vector<double>{1, 2, 1, 2}, std::vector<double>{0, 1, 2, 3}),
            0);
}

}  // namespace
}  // namespace rotatebook::timeline
