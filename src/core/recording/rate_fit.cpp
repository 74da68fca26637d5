#include "recording/rate_fit.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace rotatebook::recording {
namespace {

/// Sums over the rates inside.
struct Sums {
  double count = 0;
  Eigen::Vector3d rates{0, 0, 0}, slopes{0, 0, 0};
  double product = 0, square = 0;

  Sums(const Vectors& allRates, const Vectors& allSlopes) {
    for (std::size_t i = 2; i + 2 < allRates.size(); ++i) {
      ++count;
      rates += allRates[i];
      slopes += allSlopes[i];
      product += allRates[i].dot(allSlopes[i]);
      square += allSlopes[i].squaredNorm();
    }
  }
};

/// Returns what a factor and a bias leave, relative to the slopes.
double leftBy(const RateFit& fit, const Vectors& rates, const Vectors& slopes, double square) {
  double left = 0;
  for (std::size_t i = 2; i + 2 < rates.size(); ++i)
    left += (rates[i] - fit.factor * slopes[i] - fit.bias).squaredNorm();
  return std::sqrt(left / square);
}

RateFit factorAlone(const Sums& sums) {
  return {.factor = sums.product / sums.square};
}

RateFit biasAlone(const Sums& sums) {
  return {.bias = (sums.rates - sums.slopes) / sums.count};
}

/// Returns the fit by both; by a bias alone where the slopes hardly vary, so that a factor, a bias
/// along them and others' errors are alike.
RateFit factorAndBias(const Sums& sums) {
  constexpr double kVary = 0.01;
  const Eigen::Vector3d mean = sums.slopes / sums.count;
  const double variance = sums.square - mean.dot(sums.slopes);
  RateFit fit;
  if (variance > kVary * sums.square) fit.factor = (sums.product - mean.dot(sums.rates)) / variance;
  fit.bias = (sums.rates - fit.factor * sums.slopes) / sums.count;
  return fit;
}

/// Leaves out a factor or a bias that chance may make of what is left.
void leaveOutChance(RateFitted& fitted, const Sums& sums) {
  // The remainder of ten rows may have one cause.
  constexpr double kSigmas = 4, kRowsOfOneCause = 10, kLeast = 5e-4;
  const double bound = kLeast + kSigmas * fitted.left * std::sqrt(kRowsOfOneCause / sums.count);
  RateFit& fit = fitted.fit;
  if (std::abs(fit.factor - 1) < bound) fit.factor = 1;
  if (fit.bias.norm() < bound * std::sqrt(sums.square / sums.count)) fit.bias.setZero();
  for (double& part : fit.bias) {
    if (std::abs(part) < kLeast * fit.bias.norm()) part = 0;
  }
}

}  // namespace

bool isOne(double factor) {
  return std::abs(factor - 1) <= kSameFactor;
}

Multiple multipleOf(const Vectors& rates, const Vectors& slopes) {
  const Sums sums(rates, slopes);
  Multiple multiple;
  if (sums.square > 0) multiple.factor = sums.product / sums.square;
  if (multiple.factor == 0) return multiple;
  multiple.left =
      leftBy({.factor = multiple.factor}, rates, slopes, sums.square) / std::abs(multiple.factor);
  return multiple;
}

double relativeDifference(const Vectors& rates, const Vectors& slopes) {
  const Sums sums(rates, slopes);
  return sums.square > 0 ? leftBy({}, rates, slopes, sums.square) : 0;
}

RateFitted fitRates(const Vectors& rates, const Vectors& slopes) {
  constexpr double kAsWell = 1.2, kRounding = 1e-4;
  const Sums sums(rates, slopes);
  if (!(sums.square > 0)) return {};
  const auto fitted = [&](const RateFit& fit) {
    return RateFitted{fit, leftBy(fit, rates, slopes, sums.square)};
  };
  RateFitted best = fitted(factorAndBias(sums));
  const double enough = kAsWell * best.left + kRounding;
  for (const RateFitted& simpler : {fitted(biasAlone(sums)), fitted(factorAlone(sums))}) {
    if (simpler.left <= enough) best = simpler;
  }
  leaveOutChance(best, sums);
  return best;
}

}  // namespace rotatebook::recording
