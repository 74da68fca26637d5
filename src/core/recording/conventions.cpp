#include "recording/conventions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "base/number_text.h"
#include "base/text.h"
#include "recording/gyroscope.h"
#include "recording/rate_fit.h"
#include "recording/swapped_axes.h"

namespace rotatebook::recording {
namespace {

constexpr double kFits = 0.01;
// A mistake is recognised if the rates fit so well without it, and so much better than with it.
// Measured: 1e-6 for exact tables at 60 Hz, 0.03 with noise of 0.1 degrees, 0.095 with 0.35.
constexpr double kMaxLeft = 0.1;
constexpr double kMuchBetter = 5;
constexpr double kLargestTurn = 1;  // between moments whose slopes are compared [rad]
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

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

/// A reading of the table, and how the rates fit the slopes with it.
struct Reading {
  const Order* order = nullptr;
  bool isInverse = false;     // quaternions of body from world
  bool areAlongBody = false;  // the rates
  Multiple multiple{};
};

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

std::string mistakeText(const Reading& reading, bool areAlongBody, const TableUnits& units) {
  std::vector<std::string> mistakes;
  if (!reading.order->remedy.empty()) mistakes.emplace_back(reading.order->remedy);
  if (reading.isInverse) {
    mistakes.emplace_back(
        "the attitudes turn the world into the body; give their inverses, w, -x, -y, -z of "
        "quaternions");
  }
  if (reading.areAlongBody != areAlongBody) {
    mistakes.push_back(alongText(reading.areAlongBody) +
                       (reading.isInverse ? "; or else wx, wy, wz have the other sign" : ""));
  }
  const double factor = std::abs(reading.multiple.factor);
  if (!isOne(factor)) mistakes.push_back(factorText(factor, units));
  return joined(mistakes, "; and ");
}

std::string fitText(const std::string& mistake, double left) {
  return mistake + " (the rates then fit the attitudes' slopes to " + roundedText(100 * left, 2) +
         " %)";
}

bool isRecognised(double left, double difference) {
  return difference > kFits && left < kMaxLeft && left * kMuchBetter < difference;
}

/// The table at moments far enough apart.
struct Thinned {
  std::vector<RecordedMoment> moments;
  bool areAlongBody;
  Vectors rates{}, alongBody{}, alongWorld{};  // the slopes

  Thinned(std::vector<RecordedMoment> kept, bool along)
      : moments(std::move(kept)), areAlongBody(along) {
    std::vector<RecordedMoment> slopes = moments;
    differentiateAttitudes(slopes);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const Eigen::Quaterniond& attitude = moments[i].attitude;
      rates.push_back(alongAxes(attitude, moments[i].angularVelocity));
      alongBody.push_back(slopes[i].angularVelocity);
      alongWorld.push_back(attitude * slopes[i].angularVelocity);
    }
  }

  const Vectors& slopes() const { return areAlongBody ? alongBody : alongWorld; }

 private:
  Eigen::Vector3d alongAxes(const Eigen::Quaterniond& attitude, const Eigen::Vector3d& rate) const {
    return areAlongBody ? rate : attitude * rate;
  }
};

/// Returns the mistake of attitudes that are inverse or in another order, of other axes of the
/// rates, and of units; empty without.
std::string mistakeOfReading(const Thinned& table, double difference, const TableUnits& units) {
  std::vector<Reading> readings;
  for (const Order& order : kOrders) {
    for (const Reading& reading : readingsIn(order, table.moments, table.rates))
      readings.push_back(reading);
  }
  const Reading best = bestOf(readings, table.areAlongBody);
  if (best.order == nullptr || mistakesIn(best, table.areAlongBody) == 0 ||
      !isRecognised(best.multiple.left, difference))
    return "";
  return fitText(mistakeText(best, table.areAlongBody, units), best.multiple.left);
}

/// A mistake, and what the rates then differ by, relative to the slopes; empty without.
struct Mistake {
  std::string text{};
  double left = std::numeric_limits<double>::infinity();
};

/// Returns the mistake of columns that are swapped or negated or, of rates that contradict the
/// attitudes, of axes that are turned.
Mistake mistakeOfAxes(const Thinned& table, double difference, const TableUnits& units) {
  const RatesAndSlopes all{table.rates, table.alongBody, table.alongWorld, table.areAlongBody,
                           units.haveQuaternions};
  std::optional<AxesMistake> found = swappedColumns(all);
  if (!isRecognised(found->multiple.left, difference)) {
    // Steps that lag behind turn the slopes, too, by less.
    found = difference > kContradicts ? turnedAxes(all) : std::nullopt;
    if (!found || !isRecognised(found->multiple.left, difference)) return {};
  }
  if (!isOne(found->multiple.factor))
    found->text += "; and " + factorText(found->multiple.factor, units);
  return {found->text, found->multiple.left};
}

/// Returns the mistake of rates with a bias that contradict the attitudes.
Mistake mistakeOfBias(const RateFitted& fitted, double difference) {
  const bool isOff = fitted.fit.factor != 1 || !fitted.fit.bias.isZero(0);
  if (difference <= kContradicts || !isOff || !isRecognised(fitted.left, difference)) return {};
  return {"the rates " + textOf(fitted.fit) + "; undo that", fitted.left};
}

/// Turns of a body over pieces of its motion, in all. [rad]
struct Turns {
  double byAttitudes = 0, byRates = 0;
  double difference = 0;  // root mean square, relative to that of the larger [-]
};

/// Returns the turns by attitudes and by rates, from half a radian to the next by either, so that
/// noise of both matters little.
Turns turnsOf(const std::vector<RecordedMoment>& moments) {
  constexpr double kPiece = 0.5;  // [rad]
  std::vector<Rate> rates;
  for (const RecordedMoment& moment : moments)
    rates.push_back({moment.time, moment.angularVelocity});
  const std::vector<RecordedMoment> integrated = integrateRates(rates);
  Turns turns;
  double attitudes = 0, integrals = 0, differences = 0;
  std::size_t from = 0;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const Eigen::Vector3d one = turnOf(moments[from].attitude.conjugate() * moments[i].attitude);
    const Eigen::Vector3d other =
        turnOf(integrated[from].attitude.conjugate() * integrated[i].attitude);
    if (one.norm() < kPiece && other.norm() < kPiece) continue;
    from = i;
    turns.byAttitudes += one.norm();
    turns.byRates += other.norm();
    attitudes += one.squaredNorm();
    integrals += other.squaredNorm();
    differences += (one - other).squaredNorm();
  }
  const double larger = std::max(attitudes, integrals);
  if (larger > 0) turns.difference = std::sqrt(differences / larger);
  return turns;
}

/// Returns that the attitudes stay the same, and how to leave them out.
std::string stillText(const Eigen::Quaterniond& attitude, const std::string& turn,
                      bool areQuaternions) {
  const auto part = [](double number) { return roundedText(number, 3); };
  const std::string stay = areQuaternions ? "the quaternions stay (" + part(attitude.w()) + ", " +
                                                part(attitude.x()) + ", " + part(attitude.y()) +
                                                ", " + part(attitude.z()) + ")"
                                          : "the matrices stay the same";
  const std::string column = areQuaternions ? "qw" : "r11";
  return stay + " in all rows, though the rates turn the body by " + turn +
         " degrees; if nothing measured them, leave them out: state simulation.columns = { " +
         column + " = \"\" }, or --column " + column + "=";
}

/// Returns that few attitudes are apart though the rates turn the body; empty if they don't.
std::string mistakeOfFew(const std::vector<RecordedMoment>& moments, bool areQuaternions) {
  constexpr double kLeastPath = 1;  // [rad]
  double path = 0;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    path += (moments[i].time - moments[i - 1].time) *
            (moments[i - 1].angularVelocity + moments[i].angularVelocity).norm() / 2;
  }
  const Eigen::Quaterniond& first = moments.front().attitude;
  const bool areSame = std::ranges::all_of(
      moments, [&](const auto& one) { return one.attitude.coeffs() == first.coeffs(); });
  const double largest = kLargestTurn * static_cast<double>(moments.size() - 1);
  if (path < kLeastPath || (path > largest && !areSame)) return "";
  const Turns turns = turnsOf(moments);
  if (turns.difference <= kContradicts) return "";
  const auto text = [](double angle) {
    return shortestText(std::round(angle * kDegreesPerRadian));
  };
  if (areSame) return stillText(first, text(turns.byRates), areQuaternions);
  return "the attitudes turn by " + text(turns.byAttitudes) + " degrees in all, and the rates by " +
         text(turns.byRates) + "; are both of the same body and moment?";
}

/// Returns the fit of the rates, with a bias along the world's axes or the body's.
RateFitted fitByFactorOrBias(const Thinned& table) {
  constexpr double kBetter = 0.8;
  RateFitted best = fitRates(table.rates, table.slopes());
  best.fit.isAlongBody = table.areAlongBody;
  if (table.areAlongBody) return best;
  Vectors alongBody;
  for (const RecordedMoment& moment : table.moments) alongBody.push_back(moment.angularVelocity);
  RateFitted other = fitRates(alongBody, table.alongBody);
  other.fit.isAlongBody = true;
  return other.left < kBetter * best.left ? other : best;
}

/// Returns the turn that may be meant by the bias of a spin that hardly leaves its axis; 0 if that
/// doesn't explain the bias. [rad]
Eigen::Vector3d turnInPlaceOf(const Eigen::Vector3d& bias, const Thinned& table) {
  constexpr double kSame = 0.1;
  Eigen::Vector3d from{0, 0, 0}, to{0, 0, 0};
  for (std::size_t i = 0; i < table.rates.size(); ++i) {
    from += table.slopes()[i];
    to += table.rates[i];
  }
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(from, to);
  const Eigen::Vector3d left = (to - turn * from) / static_cast<double>(table.rates.size());
  return left.norm() < kSame * bias.norm() ? turnOf(turn) : Eigen::Vector3d::Zero();
}

/// Returns the fit of the rates, by slopes that are turned if that leaves much less than others.
RateFitted fitOf(const Thinned& table, bool haveQuaternions) {
  constexpr double kLeastTurn = 1e-3, kSigmas = 10;
  RateFitted simple = fitByFactorOrBias(table);
  const auto turned = turnedAxes(
      {table.rates, table.alongBody, table.alongWorld, table.areAlongBody, haveQuaternions});
  const bool isBias = !simple.fit.bias.isZero(0) && simple.fit.factor == 1;
  const bool areSameAxes = simple.fit.isAlongBody == table.areAlongBody;
  if (!turned && isBias && areSameAxes) simple.fit.turn = turnInPlaceOf(simple.fit.bias, table);
  if (!turned || turned->multiple.left * kMuchBetter > simple.left) return simple;
  const double left = turned->multiple.left;
  if (turned->turn.norm() < kLeastTurn + kSigmas * left) return simple;
  RateFit fit{.turn = turned->turn, .isAlongBody = table.areAlongBody};
  if (std::abs(turned->multiple.factor - 1) > kLeastTurn + left)
    fit.factor = turned->multiple.factor;
  return {fit, left};
}

std::string contradictionText(double difference) {
  return "the rates aren't the attitudes' slopes: they differ by " +
         roundedText(100 * difference, 2) +
         " %, with no other axes, order or unit by less; are both of the same body and moment?";
}

/// Returns the mistake in a table whose rates differ so much from the slopes; empty without.
std::string mistakeIn(const Thinned& table, const std::vector<RecordedMoment>& all,
                      double difference, const RateFitted& fitted, const TableUnits& units) {
  std::string mistake = mistakeOfReading(table, difference, units);
  if (!mistake.empty()) return mistake;
  const Mistake axes = mistakeOfAxes(table, difference, units);
  const Mistake bias = mistakeOfBias(fitted, difference);
  const Mistake& better = bias.left < axes.left ? bias : axes;
  if (!better.text.empty()) return fitText(better.text, better.left);
  // Noise of the attitudes makes slopes that differ.
  const bool areOthers = difference > kContradicts && turnsOf(all).difference > kContradicts;
  return areOthers ? contradictionText(difference) : "";
}

}  // namespace

std::string textOf(const RateFit& fit) {
  constexpr int kDigits = 3, kDigitsOfFactor = 5;
  constexpr double kRounding = 1e-3;
  const auto vectorOf = [](const Eigen::Vector3d& vector) {
    const auto part = [&](int i) {
      const bool isRounding = std::abs(vector[i]) < kRounding * vector.norm();
      return roundedText(isRounding ? 0 : vector[i], kDigits);
    };
    return "(" + part(0) + ", " + part(1) + ", " + part(2) + ")";
  };
  const std::string axes = fit.isAlongBody ? "the body's axes" : "the world's axes";
  const double angle = fit.turn.norm();
  const std::string factor =
      "are " + roundedText(fit.factor, kDigitsOfFactor) + " times the attitudes' slopes";
  const std::string turn = "turned from " +
                           std::string(fit.factor == 1 ? "the attitudes' slopes" : "them") +
                           " by " + roundedText(angle * kDegreesPerRadian, kDigits) +
                           " degrees about " + vectorOf(fit.turn / angle) + " along " + axes +
                           ", as along axes that aren't aligned, or of other moments";
  const std::string bias = "a bias of " + vectorOf(fit.bias) + " rad/s along " + axes;
  if (fit.bias.isZero(0) && angle > 0) return (fit.factor == 1 ? "are " : factor + ", ") + turn;
  if (fit.factor == 1) return "have " + bias + (angle > 0 ? ", or are " + turn : "");
  return factor + (fit.bias.isZero(0) ? "" : ", with " + bias);
}

RateComparison compareRates(const std::vector<RecordedMoment>& moments, bool areAlongBody,
                            const TableUnits& units) {
  constexpr std::size_t kMinMoments = 10;
  if (moments.size() < 2) return {};
  const std::vector<RecordedMoment> kept = thinned(moments);
  if (kept.size() < kMinMoments) return {.mistake = mistakeOfFew(moments, units.haveQuaternions)};
  if (meanTurn(kept) > kLargestTurn) return {};
  const Thinned table(kept, areAlongBody);
  RateComparison result{.difference = relativeDifference(table.rates, table.slopes())};
  const RateFitted fitted = fitOf(table, units.haveQuaternions);
  result.fit = fitted.fit;
  result.mistake = mistakeIn(table, moments, result.difference, fitted, units);
  return result;
}

}  // namespace rotatebook::recording
