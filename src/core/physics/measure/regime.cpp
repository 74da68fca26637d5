#include "physics/measure/regime.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rotatebook::physics {
namespace {

// A sum that is kept without error: terms that don't overlap, the smallest first (Shewchuk 1997).
using ExactTerms = std::vector<double>;

void addTo(ExactTerms& terms, double number) {
  for (double& term : terms) {
    const DoubleDouble sum = exactSum(number, term);
    term = sum.low;
    number = sum.high;
  }
  terms.push_back(number);
}

ExactTerms product(std::array<double, 4> factors) {
  ExactTerms terms{factors[0]};
  for (int i = 1; i < 4; ++i) {
    ExactTerms longer;
    for (const double term : terms) {
      const DoubleDouble part = exactProduct(term, factors[i]);
      addTo(longer, part.low);
      addTo(longer, part.high);
    }
    terms = std::move(longer);
  }
  return terms;
}

// Two spins of a smaller ratio aren't near the separatrix; the square of the ratio would underflow.
constexpr double kNegligibleSpin = 1e-90;

DoubleDouble medianInvariant(const std::array<double, 3>& moments, double w1, double w3) {
  const auto [i1, i2, i3] = moments;
  const std::array<std::array<double, 4>, 4> products{
      {{i3, i3, w3, w3}, {-i3, i2, w3, w3}, {i1, i1, w1, w1}, {-i1, i2, w1, w1}}};
  ExactTerms sum;
  for (const std::array<double, 4>& factors : products) {
    for (const double term : product(factors)) addTo(sum, term);
  }
  DoubleDouble rounded;
  for (const double term : sum) rounded = rounded + term;
  return rounded;
}

}  // namespace

std::array<int, 3> axesByInertia(const Eigen::Vector3d& inertia) {
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return inertia[a] < inertia[b]; });
  return axes;
}

DoubleDouble medianInvariantRoot(const std::array<double, 3>& moments, double w1, double w3) {
  if (moments[0] == moments[1]) w1 = 0;
  if (moments[2] == moments[1]) w3 = 0;
  const double larger = std::max(std::fabs(w1), std::fabs(w3));
  if (larger == 0) return 0.0;
  const double spin = powerOfTwoBelow(larger);
  const double inertia = powerOfTwoBelow(moments[2]);
  const auto ratio = [&](double w) { return std::fabs(w) < kNegligibleSpin * spin ? 0 : w / spin; };
  const DoubleDouble n2 = medianInvariant(
      {moments[0] / inertia, moments[1] / inertia, moments[2] / inertia}, ratio(w1), ratio(w3));
  const DoubleDouble root = squareRoot(absolute(n2)) * spin * inertia;
  return n2.high < 0 ? -root : root;
}

Regime regimeOf(const Eigen::Vector3d& inertia, const Eigen::Vector3d& angularVelocityBody) {
  const auto [first, second, third] = axesByInertia(inertia);
  const double w1 = angularVelocityBody[first], w3 = angularVelocityBody[third];
  const double larger = std::max(std::fabs(w1), std::fabs(w3));
  if (larger == 0) return Regime::Separatrix;
  // Of the smallest spins the root would underflow.
  const double spin = powerOfTwoBelow(larger);
  const double root =
      medianInvariantRoot({inertia[first], inertia[second], inertia[third]}, w1 / spin, w3 / spin)
          .high;
  return static_cast<Regime>((root > 0) - (root < 0));
}

}  // namespace rotatebook::physics
