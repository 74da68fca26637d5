#include "recording/conventions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

#include "base/number_text.h"
#include "base/text.h"
#include "recording/gyroscope.h"

namespace rotatebook::recording {
namespace {

using Vectors = std::vector<Eigen::Vector3d>;

constexpr double kFits = 0.01;
// A mistake is recognised if the rates fit so well without it, and so much better than with it.
// Measured: 1e-6 for exact tables at 60 Hz, 0.03 with noise of 0.1 degrees, 0.095 with 0.35.
constexpr double kMaxLeft = 0.1;
constexpr double kMuchBetter = 5;
constexpr double kSameFactor = 0.05;

/// An order of a quaternion's parts: what the columns of w, x, y, z hold.
struct Order {
  std::array<int, 4> columns;  // of w, x, y, z: 0 to 3 for the columns of w, x, y, z
  std::string_view remedy;
};

constexpr std::array<Order, 3> kOrders{{
    {{0, 1, 2, 3}, ""},
    {{3, 0, 1, 2},
     "the columns called qw, qx, qy, qz hold x, y, z, w; name them in simulation.columns, or with "
     "--column"},
    {{1, 2, 3, 0},
     "the columns called qx, qy, qz, qw hold w, x, y, z; name them in simulation.columns, or with "
     "--column"},
}};

/// A factor by which rates or times are wrong.
struct Factor {
  double value;
  std::string_view remedy;
};

constexpr double kDegrees = 57.29577951308232;
constexpr double kWholeTurn = 6.283185307179586;
constexpr std::array<Factor, 13> kFactors{{
    {kDegrees, R"(deg/s? State simulation.rates = "deg/s", or --rates deg/s)"},
    {1 / kDegrees, R"(rad/s? State simulation.rates = "rad/s", or --rates rad/s)"},
    {1e3, R"(are the times in ms? State simulation.time_unit = "ms", or --time-unit ms)"},
    {1e6, R"(are the times in us? State simulation.time_unit = "us", or --time-unit us)"},
    {1e9, R"(are the times in ns? State simulation.time_unit = "ns", or --time-unit ns)"},
    {1e-3, R"(are the times in s? State simulation.time_unit = "s", or --time-unit s)"},
    {1e-6, R"(are the times in s? State simulation.time_unit = "s", or --time-unit s)"},
    {1e-9, R"(are the times in s? State simulation.time_unit = "s", or --time-unit s)"},
    {1e3 * kDegrees,
     "deg/s, and the times in ms? State --rates deg/s and --time-unit ms, or simulation.rates and "
     "time_unit"},
    {1e6 * kDegrees,
     "deg/s, and the times in us? State --rates deg/s and --time-unit us, or simulation.rates and "
     "time_unit"},
    {1 / kWholeTurn, "turns a second? Write them in rad/s or deg/s"},
    {60 / kWholeTurn, "turns a minute? Write them in rad/s or deg/s"},
    {60 / kWholeTurn / kDegrees, "turns a minute? Write them in rad/s or deg/s"},
}};

/// The attitudes that a turn of 0.1 rad or a row lies between, without rates' unit or axes.
std::vector<RecordedMoment> thinned(const std::vector<RecordedMoment>& moments) {
  constexpr double kHalfTurn = 0.05;  // [rad]
  std::vector<RecordedMoment> kept;
  for (const RecordedMoment& moment : moments) {
    const bool isFar =
        kept.empty() ||
        (kept.back().attitude.conjugate() * moment.attitude).vec().norm() > kHalfTurn;
    if (isFar) kept.push_back(moment);
  }
  return kept;
}

/// Returns the mean turn from each moment to the next. [rad]
double meanTurn(const std::vector<RecordedMoment>& moments) {
  double sum = 0;
  for (std::size_t i = 1; i < moments.size(); ++i)
    sum += turnOf(moments[i - 1].attitude.conjugate() * moments[i].attitude).norm();
  return sum / static_cast<double>(moments.size() - 1);
}

Eigen::Quaterniond ordered(const Eigen::Quaterniond& q, const Order& order) {
  const std::array<double, 4> parts{q.w(), q.x(), q.y(), q.z()};
  const auto part = [&](std::size_t i) {
    return parts[static_cast<std::size_t>(order.columns[i])];
  };
  return {part(0), part(1), part(2), part(3)};
}

/// Rates as a multiple of slopes.
struct Multiple {
  double factor = 0;
  double left = std::numeric_limits<double>::infinity();  // relative to the multiple
};

/// Fits the rates inside, without the two at each end, whose slopes are one-sided.
Multiple multipleOf(const Vectors& rates, const Vectors& slopes) {
  double product = 0, square = 0;
  for (std::size_t i = 2; i + 2 < rates.size(); ++i) {
    product += rates[i].dot(slopes[i]);
    square += slopes[i].squaredNorm();
  }
  Multiple fit;
  if (square > 0) fit.factor = product / square;
  if (fit.factor == 0) return fit;
  double left = 0;
  for (std::size_t i = 2; i + 2 < rates.size(); ++i)
    left += (rates[i] - fit.factor * slopes[i]).squaredNorm();
  fit.left = std::sqrt(left / square) / std::abs(fit.factor);
  return fit;
}

double relativeDifference(const Vectors& rates, const Vectors& slopes) {
  double left = 0, square = 0;
  for (std::size_t i = 2; i + 2 < rates.size(); ++i) {
    left += (rates[i] - slopes[i]).squaredNorm();
    square += slopes[i].squaredNorm();
  }
  return square > 0 ? std::sqrt(left / square) : 0;
}

/// A reading of the table, and how the rates fit the slopes with it.
struct Reading {
  const Order* order = nullptr;
  bool isInverse = false;     // quaternions of body from world
  bool areAlongBody = false;  // the rates
  Multiple multiple{};
};

bool isOne(double factor) {
  return std::abs(factor - 1) <= kSameFactor;
}

/// Returns the number of mistakes in a table that is to be read so.
int mistakesIn(const Reading& reading, bool areAlongBody) {
  return (reading.order != kOrders.data()) + reading.isInverse +
         (reading.areAlongBody != areAlongBody) + !isOne(std::abs(reading.multiple.factor));
}

/// Returns the readings in an order of the quaternions' parts: with the rates as multiples of the
/// slopes along the body's axes, and along the world's. A negative multiple is of the inverse
/// attitudes, whose slopes along the world's axes are the body's, negative.
std::array<Reading, 2> readingsIn(const Order& order, std::vector<RecordedMoment> moments,
                                  const Vectors& rates) {
  for (RecordedMoment& moment : moments) moment.attitude = ordered(moment.attitude, order);
  differentiateAttitudes(moments);
  Vectors alongBody, alongWorld;
  for (const RecordedMoment& moment : moments) {
    alongBody.push_back(moment.angularVelocity);
    alongWorld.push_back(moment.attitude * moment.angularVelocity);
  }
  const Multiple body = multipleOf(rates, alongBody), world = multipleOf(rates, alongWorld);
  return {{{&order, body.factor<0, body.factor> 0, body},
           {&order, world.factor < 0, world.factor < 0, world}}};
}

/// Returns the reading that fits best or, of those that fit as well, has the fewest mistakes.
Reading bestOf(const std::vector<Reading>& readings, bool areAlongBody) {
  constexpr double kAsWell = 2, kRounding = 1e-3;
  double least = readings.front().multiple.left;
  for (const Reading& reading : readings) least = std::min(least, reading.multiple.left);
  Reading best;
  for (const Reading& reading : readings) {
    if (!(reading.multiple.left <= kAsWell * least + kRounding)) continue;
    const bool isFirst = best.order == nullptr;
    if (isFirst || mistakesIn(reading, areAlongBody) < mistakesIn(best, areAlongBody))
      best = reading;
  }
  return best;
}

std::string factorText(double factor) {
  const std::string times =
      "the rates are " + roundedText(factor, 4) + " times the attitudes' slopes";
  for (const Factor& known : kFactors) {
    if (isOne(factor / known.value)) return times + ": " + std::string(known.remedy);
  }
  return times + "; scale them";
}

std::string mistakeText(const Reading& reading, bool areAlongBody) {
  std::vector<std::string> mistakes;
  if (!reading.order->remedy.empty()) mistakes.emplace_back(reading.order->remedy);
  if (reading.isInverse) {
    mistakes.emplace_back(
        "the attitudes turn the world into the body; give their inverses, w, -x, -y, -z of "
        "quaternions");
  }
  if (reading.areAlongBody != areAlongBody) {
    const std::string axes = reading.areAlongBody ? "body" : "world";
    mistakes.push_back("the rates are along the " + axes +
                       "'s axes; state simulation.rates_along = \"" + axes +
                       "\", or --rates-along " + axes);
  }
  const double factor = std::abs(reading.multiple.factor);
  if (!isOne(factor)) mistakes.push_back(factorText(factor));
  return joined(mistakes, "; and ") + " (the rates then fit the attitudes' slopes to " +
         roundedText(100 * reading.multiple.left, 2) + " %)";
}

}  // namespace

RateComparison compareRates(const std::vector<RecordedMoment>& moments, bool areAlongBody) {
  constexpr std::size_t kMinMoments = 10;
  constexpr double kLargestTurn = 1;  // [rad]
  const std::vector<RecordedMoment> kept = thinned(moments);
  if (kept.size() < kMinMoments || meanTurn(kept) > kLargestTurn) return {};
  Vectors rates;
  for (const RecordedMoment& moment : kept) {
    rates.push_back(areAlongBody ? moment.angularVelocity
                                 : moment.attitude * moment.angularVelocity);
  }
  std::vector<Reading> readings;
  for (const Order& order : kOrders) {
    for (const Reading& reading : readingsIn(order, kept, rates)) readings.push_back(reading);
  }
  std::vector<RecordedMoment> asRead = kept;
  differentiateAttitudes(asRead);
  Vectors slopes;
  for (const RecordedMoment& moment : asRead) {
    slopes.push_back(areAlongBody ? moment.angularVelocity
                                  : moment.attitude * moment.angularVelocity);
  }
  RateComparison result{relativeDifference(rates, slopes), ""};
  const Reading best = bestOf(readings, areAlongBody);
  const bool isRecognised = result.difference > kFits && best.order != nullptr &&
                            best.multiple.left < kMaxLeft &&
                            best.multiple.left * kMuchBetter < result.difference;
  if (isRecognised && mistakesIn(best, areAlongBody) > 0)
    result.mistake = mistakeText(best, areAlongBody);
  return result;
}

}  // namespace rotatebook::recording
