#include "recording/gyroscope.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"

namespace rotatebook::recording {
namespace {

// Points of Gauss's rule of order 4 are this part of a step from its middle: sqrt(3)/6.
constexpr double kGauss = 0.28867513459481287;

/// The rates at the Gauss points of a gap.
struct GaussRates {
  double interval;  // of the gap [s]
  Eigen::Vector3d first, second;
};

GaussRates gaussRates(const std::vector<Rate>& rates, std::size_t index) {
  const double start = rates[index].time;
  const double h = rates[index + 1].time - start;
  const auto timeOf = [&](std::size_t i) { return rates[i].time; };
  const Stencil stencil = stencilAround(index, rates.size(), timeOf);
  const auto rateAt = [&](double fraction) {
    return polynomialAt(start + fraction * h, stencil, timeOf,
                        [&](std::size_t i) { return rates[i].angularVelocity; });
  };
  return {h, rateAt(0.5 - kGauss), rateAt(0.5 + kGauss)};
}

/// Returns the turn of the body in the gap after reading `index`, in the body's axes at its start.
Eigen::Vector3d turnInGap(const std::vector<Rate>& rates, std::size_t index) {
  const auto [h, first, second] = gaussRates(rates, index);
  return h / 2 * (first + second) + kGauss / 2 * h * h * first.cross(second);
}

}  // namespace

Eigen::Quaterniond rotationBy(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  const double half = angle / 2;
  // sin(x)/x = 1 to rounding there.
  constexpr double kSmall = 1e-8;
  const double scale = angle < kSmall ? 0.5 : sine(half) / angle;
  const Eigen::Vector3d vector = scale * turn;
  return {cosine(half), vector.x(), vector.y(), vector.z()};
}

Eigen::Vector3d turnOf(const Eigen::Quaterniond& rotation) {
  const double sign = rotation.w() < 0 ? -1 : 1;
  const double length = rotation.vec().norm();
  if (length == 0) return Eigen::Vector3d::Zero();
  const double angle = 2 * arcTangent(length, sign * rotation.w());
  return sign * angle / length * rotation.vec();
}

std::vector<RecordedMoment> integrateRates(const std::vector<Rate>& rates) {
  std::vector<RecordedMoment> moments;
  moments.reserve(rates.size());
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (i > 0) attitude = (attitude * rotationBy(turnInGap(rates, i - 1))).normalized();
    moments.push_back({rates[i].time, attitude, rates[i].angularVelocity});
  }
  return moments;
}

Eigen::Vector3d meanTurnInGap(const std::vector<Rate>& rates, std::size_t index) {
  const auto [h, first, second] = gaussRates(rates, index);
  return h / 2 * (first + second);
}

void differentiateAttitudes(std::vector<RecordedMoment>& moments, std::size_t neighbours) {
  const std::size_t count = std::min(2 * neighbours + 1, moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const std::size_t first = std::min(i < neighbours ? 0 : i - neighbours, moments.size() - count);
    const double here = moments[i].time;
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (std::size_t k = first; k < first + count; ++k) {
      if (k == i) continue;  // No turn.
      // The slope of the Lagrange polynomial that is 1 at k and 0 at the others.
      const double toThere = moments[k].time - here;
      double weight = 1 / toThere;
      for (std::size_t j = first; j < first + count; ++j) {
        if (j == i || j == k) continue;
        weight *= (here - moments[j].time) / (moments[k].time - moments[j].time);
      }
      slope += weight * turnOf(moments[i].attitude.conjugate() * moments[k].attitude);
    }
    moments[i].angularVelocity = slope;
  }
}

}  // namespace rotatebook::recording
