#include "timeline/fitted_start.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Cholesky>

#include "recording/gyroscope.h"
#include "rigid/exact_rotation.h"

namespace rotatebook::timeline {
namespace {

using physics::Sample;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The first `count` samples, or every few of them.
struct Part {
  const std::vector<Sample>& samples;
  std::size_t count, stride;
};

/// The equations of one step: of the attitude, by a turn in the world, and of the spin.
struct Equations {
  Matrix6 matrix = Matrix6::Zero();
  Vector6 right = Vector6::Zero();

  void add(const Eigen::Matrix<double, 3, 6>& slopes, const Eigen::Vector3d& residual) {
    matrix += slopes.transpose() * slopes;
    right -= slopes.transpose() * residual;
  }
};

/// Returns the step that lessens the turns from the exact attitudes to those of the samples.
Vector6 stepOf(const rigid::PrincipalAxes& inertia, const FittedStart& start, const Part& part) {
  const double nudge = 1e-6 * start.angularVelocity.norm();
  std::vector<rigid::ExactRotation> motions{{inertia, start.angularVelocity}};
  for (int k = 0; k < 3; ++k)
    motions.emplace_back(inertia, start.angularVelocity + nudge * Eigen::Vector3d::Unit(k));
  Equations equations;
  for (std::size_t i = 0; i < part.count; i += part.stride) {
    const Sample& sample = part.samples[i];
    const auto exact = [&](std::size_t k) {
      return start.attitude * Eigen::Quaterniond(motions[k].at(sample.time).worldFromBody);
    };
    const auto residual = [&](std::size_t k) {
      return recording::turnOf(exact(k).conjugate() * sample.attitude);
    };
    const Eigen::Vector3d here = residual(0);
    Eigen::Matrix<double, 3, 6> slopes;
    slopes.leftCols<3>() = -exact(0).conjugate().toRotationMatrix();
    for (int k = 0; k < 3; ++k)
      slopes.col(3 + k) = (residual(static_cast<std::size_t>(k) + 1) - here) / nudge;
    equations.add(slopes, here);
  }
  return equations.matrix.ldlt().solve(equations.right);
}

constexpr std::size_t kFirst = 12;  // samples of the smallest fit

double turnBetween(const Sample& before, const Sample& sample) {
  return before.angularVelocity.norm() * (sample.time - before.time);
}

}  // namespace

FittedStart fitStart(const rigid::PrincipalAxes& inertia, const std::vector<Sample>& samples) {
  constexpr std::size_t kMaxAtOnce = 200;
  constexpr int kIterations = 4;
  const Sample& first = samples.front();
  FittedStart start{first.attitude, first.attitude.conjugate() * first.angularVelocity};
  for (std::size_t count = kFirst;; count += count / 2) {
    count = std::min(count, samples.size());
    const Part part{samples, count, (count + kMaxAtOnce - 1) / kMaxAtOnce};
    for (int i = 0; i < kIterations; ++i) {
      const Vector6 step = stepOf(inertia, start, part);
      const Eigen::Vector3d spin = start.angularVelocity + step.tail<3>();
      if (!step.allFinite() || spin.isZero(0)) return start;
      start.attitude = (recording::rotationBy(step.head<3>()) * start.attitude).normalized();
      start.angularVelocity = spin;
    }
    if (count == samples.size()) return start;
  }
}

FittedStart fitFirst(const rigid::PrincipalAxes& inertia, const std::vector<Sample>& samples,
                     double turn) {
  std::size_t count = 1;
  for (double turned = 0; count < samples.size() && (count < kFirst || turned < turn); ++count)
    turned += turnBetween(samples[count - 1], samples[count]);
  return fitStart(inertia, {samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count)});
}

FittedStart fitLast(const rigid::PrincipalAxes& inertia, const std::vector<Sample>& samples,
                    double turn) {
  std::size_t first = samples.size() - 1;
  for (double turned = 0; first > 0 && (samples.size() - first < kFirst || turned < turn); --first)
    turned += turnBetween(samples[first - 1], samples[first]);
  std::vector<Sample> part{samples.begin() + static_cast<std::ptrdiff_t>(first), samples.end()};
  const double start = part.front().time;
  for (Sample& sample : part) sample.time -= start;
  return fitStart(inertia, part);
}

}  // namespace rotatebook::timeline
