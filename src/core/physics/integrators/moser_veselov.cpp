#include "physics/integrators/moser_veselov.h"

#include <string>

#include "base/number_text.h"
#include "physics/integrators/step_error.h"

namespace rotatebook::physics {
namespace {

// The series of dmv4 and dmv6 are trusted to change a moment of inertia by no more than this
// factor.
constexpr double kMaxRatio = 2;

constexpr int kDigits = 4;  // of numbers in messages

// Returns the ratio that is farthest out of reach; one below zero is farther than any other.
double farthest(const Eigen::Array3d& ratios) {
  const double low = ratios.minCoeff(), high = ratios.maxCoeff();
  return low * high < 1 ? low : high;
}

// The preprocessed inertia J: 1/J = scale/I + shift.
struct Correction {
  double scale = 1;
  double shift = 0;
};

Correction correctionOf(const RigidConstants& body, double h, int order) {
  if (order < 4) return {};
  const Eigen::Vector3d& inertia = body.inertia;
  const Eigen::Vector3d& inverse = body.inverseInertia;
  const double c = h * h * body.momentum.squaredNorm() / 2;
  const double e = h * h * body.momentum.dot(inverse.cwiseProduct(body.momentum)) / 2;
  const double d = inertia.prod();
  const double s1 = inertia.sum(), x1 = inverse.sum();
  Correction result{1 + s1 * c / (6 * d) - x1 * e / 3, -c / (3 * d) + s1 * e / (6 * d)};
  if (order < 6) return result;

  const double s2 = inertia.squaredNorm(), x2 = inverse.squaredNorm();
  // Sum of (I1+I2)/I3 and its cyclic permutations.
  const double xs = s1 * x1 - 3;
  result.scale += (s2 / d - x1) / (30 * d) * c * c + (1 - xs) / (30 * d) * c * e +
                  (3 * s1 / d + 2 * x2) / 60 * e * e;
  result.shift += -s1 / (60 * d * d) * c * c + (x1 / (10 * d) - s2 / (60 * d * d)) * c * e -
                  (9 + xs) / (60 * d) * e * e;
  return result;
}

}  // namespace

Eigen::Vector3d preprocessedInertia(const RigidConstants& body, double h, int order) {
  const auto [scale, shift] = correctionOf(body, h, order);
  const Eigen::Array3d inertia = (scale * body.inverseInertia.array() + shift).inverse();
  const Eigen::Array3d ratios = inertia / body.inertia.array();
  if (ratios.minCoeff() >= 1 / kMaxRatio && ratios.maxCoeff() <= kMaxRatio) {
    return inertia.matrix();
  }
  throw StepTooLong("a step of " + roundedText(h, kDigits) + " s is too long for dmv" +
                    std::to_string(order) +
                    ": its series changes a moment of inertia by the factor " +
                    roundedText(farthest(ratios), kDigits) +
                    ", where 1/2 to 2 is its reach; use shorter steps (more substeps)");
}

}  // namespace rotatebook::physics
