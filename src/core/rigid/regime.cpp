#include "rigid/regime.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rotatebook::rigid {
namespace {

// A sum without error (Shewchuk's expansion, 1997): terms that don't overlap, smallest first, none
// of them 0.
using ExactTerms = std::vector<double>;

constexpr std::size_t kUsualTerms = 32;  // at most, of numbers that aren't chosen for it

void addTo(ExactTerms& terms, double number) {
  std::size_t kept = 0;
  for (const double term : terms) {
    const DoubleDouble sum = exactSum(number, term);
    if (sum.low != 0) terms[kept++] = sum.low;
    number = sum.high;
  }
  terms.resize(kept);
  if (number != 0) terms.push_back(number);
}

ExactTerms product(const std::array<DoubleDouble, 4>& factors) {
  ExactTerms terms{1.0}, longer;
  terms.reserve(kUsualTerms);
  longer.reserve(kUsualTerms);
  for (const DoubleDouble& factor : factors) {
    longer.clear();
    for (const double term : terms) {
      for (const double number : {factor.low, factor.high}) {
        if (number == 0) continue;
        const DoubleDouble part = exactProduct(term, number);
        addTo(longer, part.low);
        addTo(longer, part.high);
      }
    }
    terms.swap(longer);
  }
  return terms;
}

// Spins in a smaller ratio are far from the separatrix, and its square would underflow.
constexpr double kNegligibleSpin = 1e-90;

DoubleDouble middleInvariant(const DoubleDouble3& moments, DoubleDouble w1, DoubleDouble w3) {
  const auto [i1, i2, i3] = moments;
  const std::array<std::array<DoubleDouble, 4>, 4> products{
      {{i3, i3, w3, w3}, {-i3, i2, w3, w3}, {i1, i1, w1, w1}, {-i1, i2, w1, w1}}};
  ExactTerms sum;
  for (const std::array<DoubleDouble, 4>& factors : products) {
    for (const double term : product(factors)) addTo(sum, term);
  }
  DoubleDouble rounded;
  for (const double term : sum) rounded = rounded + term;
  return rounded;
}

}  // namespace

std::array<int, 3> axesByInertia(const Eigen::Vector3d& inertia) {
  return axesByInertia(DoubleDouble3{inertia[0], inertia[1], inertia[2]});
}

std::array<int, 3> axesByInertia(const DoubleDouble3& inertia) {
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
    return inertia[static_cast<std::size_t>(a)] < inertia[static_cast<std::size_t>(b)];
  });
  return axes;
}

DoubleDouble middleInvariantRoot(const DoubleDouble3& moments, DoubleDouble w1, DoubleDouble w3) {
  if (moments[0] == moments[1]) w1 = 0.0;
  if (moments[2] == moments[1]) w3 = 0.0;
  const double larger = std::max(std::fabs(w1.high), std::fabs(w3.high));
  if (larger == 0) return 0.0;
  const int spin = std::ilogb(larger), inertia = std::ilogb(moments[2].high);
  const auto ratio = [&](DoubleDouble w) {
    const DoubleDouble part = scaled(w, -spin);
    return std::fabs(part.high) < kNegligibleSpin ? 0.0 : part;
  };
  const DoubleDouble n2 = middleInvariant(
      {scaled(moments[0], -inertia), scaled(moments[1], -inertia), scaled(moments[2], -inertia)},
      ratio(w1), ratio(w3));
  const DoubleDouble root = scaled(squareRoot(absolute(n2)), spin + inertia);
  return n2.high < 0 ? -root : root;
}

Regime regimeOf(const Eigen::Vector3d& inertia, const Eigen::Vector3d& angularVelocityBody) {
  const Eigen::Vector3d& w = angularVelocityBody;
  return preciseRegimeOf(DoubleDouble3{inertia[0], inertia[1], inertia[2]},
                         DoubleDouble3{w[0], w[1], w[2]});
}

Regime preciseRegimeOf(const DoubleDouble3& inertia, const DoubleDouble3& angularVelocityBody) {
  const auto axes = axesByInertia(inertia);
  const auto sorted = [&axes](const DoubleDouble3& values, std::size_t i) {
    return values[static_cast<std::size_t>(axes[i])];
  };
  const DoubleDouble w1 = sorted(angularVelocityBody, 0), w3 = sorted(angularVelocityBody, 2);
  const double larger = std::max(std::fabs(w1.high), std::fabs(w3.high));
  if (larger == 0) return Regime::Separatrix;
  // Scale the spins, because the root would underflow if they were tiny.
  const int spin = std::ilogb(larger);
  const double root =
      middleInvariantRoot({sorted(inertia, 0), sorted(inertia, 1), sorted(inertia, 2)},
                          scaled(w1, -spin), scaled(w3, -spin))
          .high;
  return static_cast<Regime>((root > 0) - (root < 0));
}

}  // namespace rotatebook::rigid
