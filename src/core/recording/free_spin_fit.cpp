#include "recording/free_spin_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "recording/gaps.h"

namespace rotatebook::recording {
namespace {

using Slopes = Eigen::Matrix<double, Eigen::Dynamic, kParameters>;

/// Free motion of the angular velocity, in body axes, by the classical Runge-Kutta method.
class FreeSpin {
 public:
  /// Spins above `fastest` stay as they are. [rad/s]
  FreeSpin(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& spin, double fastest)
      : tensor_(tensor), inverse_(tensor_.inverse()), spin_(spin), fastest_(fastest) {}

  const Eigen::Vector3d& spin() const { return spin_; }

  void advance(double interval) {
    constexpr double kTurn = 0.05;  // largest of a step [rad]
    constexpr double kMaxSteps = 1000;
    // Parameters by which a body would spin up are refused by their error
    if (!(spin_.norm() <= fastest_)) return;
    const double turn = interval * spin_.norm();
    const double steps = std::clamp(std::ceil(turn / kTurn), 1.0, kMaxSteps);
    const double h = interval / steps;
    for (int i = 0; i < static_cast<int>(steps); ++i) {
      const Eigen::Vector3d k1 = change(spin_), k2 = change(spin_ + h / 2 * k1);
      const Eigen::Vector3d k3 = change(spin_ + h / 2 * k2), k4 = change(spin_ + h * k3);
      spin_ += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  }

 private:
  Eigen::Vector3d change(const Eigen::Vector3d& spin) const {
    return inverse_ * (tensor_ * spin).cross(spin);
  }

  Eigen::Matrix3d tensor_, inverse_;
  Eigen::Vector3d spin_;
  double fastest_;
};

/// Returns a spin that a flight doesn't come near, but for wrong readings: ten times that of a
/// quarter of it. [rad/s]
double unreachedIn(Readings flight) {
  constexpr double kTimes = 10;
  std::vector<double> spins;
  for (const InertialReading& one : flight) spins.push_back(one.rate.angularVelocity.norm());
  const auto quarter = spins.begin() + std::ssize(spins) * 3 / 4;
  std::nth_element(spins.begin(), quarter, spins.end());
  return kTimes * *quarter;
}

/// Returns the rates minus those of the free motion, three for each reading. [rad/s]
Eigen::VectorXd residualsOf(Readings flight, const Parameters& p, double unreached) {
  Eigen::VectorXd residuals(3 * static_cast<Eigen::Index>(flight.size()));
  FreeSpin free(tensorOf(p), p.tail<3>(), unreached);
  for (std::size_t i = 0; i < flight.size(); ++i) {
    if (i > 0) free.advance(flight[i].rate.time - flight[i - 1].rate.time);
    residuals.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        flight[i].rate.angularVelocity - free.spin();
  }
  return residuals;
}

Slopes slopesOf(Readings flight, const Parameters& p, double unreached) {
  constexpr double kStep = 1e-6;
  Slopes slopes(3 * static_cast<Eigen::Index>(flight.size()), kParameters);
  for (int i = 0; i < kParameters; ++i) {
    Parameters up = p, down = p;
    up[i] += kStep;
    down[i] -= kStep;
    slopes.col(i) =
        (residualsOf(flight, up, unreached) - residualsOf(flight, down, unreached)) / (2 * kStep);
  }
  return slopes;
}

/// Returns a^T b, its sums in the order of the readings: that of a product by blocks follows from
/// the processor's caches.
template <typename Columns>
Eigen::Matrix<double, kParameters, Columns::ColsAtCompileTime> productOf(const Slopes& a,
                                                                         const Columns& b) {
  return a.transpose().lazyProduct(b);
}

using SquareOfParameters = Eigen::Matrix<double, kParameters, kParameters>;

/// Returns the inverse of a symmetric matrix; in one place, as Eigen's solvers are slow to compile.
SquareOfParameters inverseOf(const SquareOfParameters& matrix) {
  return matrix.ldlt().solve(SquareOfParameters::Identity());
}

/// Returns the covariance of the parameters: by the noise of the flight's rates, and by the error
/// of the bias, which shifts all of an axis alike.
Eigen::Matrix<double, kParameters, kParameters> covarianceOf(const Slopes& slopes, double variance,
                                                             const Eigen::Vector3d& biasVariance) {
  const SquareOfParameters inverse = inverseOf(productOf(slopes, slopes));
  Eigen::Matrix<double, kParameters, 3> sums = Eigen::Matrix<double, kParameters, 3>::Zero();
  for (Eigen::Index row = 0; row < slopes.rows(); ++row)
    sums.col(row % 3) += slopes.row(row).transpose();
  const Eigen::Matrix<double, kParameters, 3> byBias = inverse * sums;
  return variance * inverse + byBias * biasVariance.asDiagonal() * byBias.transpose();
}

/// Lessens the error of a fit whose Gauss-Newton steps are too long, as where its matrix is nearly
/// singular, by a damped one (Levenberg, Marquardt). Returns false if none helps much.
bool stepDamped(Readings flight, double unreached, Parameters& p, double& error) {
  constexpr double kLeastGain = 0.01, kSmallest = 1e-4, kLargest = 1e4;
  const Slopes slopes = slopesOf(flight, p, unreached);
  const SquareOfParameters squares = productOf(slopes, slopes);
  const Parameters gradient = productOf(slopes, residualsOf(flight, p, unreached));
  for (double damping = kSmallest; damping <= kLargest; damping *= 10) {
    SquareOfParameters damped = squares;
    damped.diagonal() *= 1 + damping;
    const Parameters next = p - inverseOf(damped) * gradient;
    const double nextError = residualsOf(flight, next, unreached).squaredNorm();
    if (!(nextError < (1 - kLeastGain) * error)) continue;
    p = next;
    error = nextError;
    return true;
  }
  return false;
}

/// Returns the readings of the first turn, or all if there are no three.
std::size_t firstTurnIn(Readings flight) {
  constexpr double kTurn = 6.3;  // [rad]
  std::size_t first = flight.size();
  double turned = 0;
  for (std::size_t i = 1; i < flight.size(); ++i) {
    const double step = flight[i].rate.time - flight[i - 1].rate.time;
    turned += step * flight[i].rate.angularVelocity.norm();
    if (turned > kTurn && first == flight.size()) first = i;
  }
  return turned > 3 * kTurn ? first : flight.size();
}

/// Returns a start for a long flight, by fits to its first turn and to half as much more each time,
/// as a motion that isn't near is soon far; nothing of a short one.
std::optional<Parameters> grownStart(Readings flight) {
  std::size_t count = firstTurnIn(flight);
  if (count == flight.size() || count <= kParameters) return std::nullopt;
  const Readings first = flight.first(count);
  Parameters p = parametersOf(solveLinear(first).tensor, first.front().rate.angularVelocity);
  if (!isFollowed(first, p)) return std::nullopt;
  for (; count < flight.size(); count += count / 2)
    p = fitFreeSpin(flight.first(count), p, Eigen::Vector3d::Zero()).parameters;
  return p;
}

}  // namespace

Eigen::Matrix3d tensorOf(const Parameters& p) {
  Eigen::Matrix3d tensor;
  tensor << p[0], p[2], p[3],  //
      p[2], p[1], p[4],        //
      p[3], p[4], 1 - p[0] - p[1];
  return tensor;
}

Parameters parametersOf(Eigen::Matrix3d tensor, const Eigen::Vector3d& start) {
  tensor /= tensor.trace();
  Parameters p;
  p << tensor(0, 0), tensor(1, 1), tensor(0, 1), tensor(0, 2), tensor(1, 2), start;
  return p;
}

Eigen::Vector3d principalMoments(const Eigen::Matrix3d& tensor) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

MomentumMatrix momentumMatrix(const RecordedMoment& moment) {
  const Eigen::Vector3d& w = moment.angularVelocity;
  MomentumMatrix momentum;
  momentum << w.x(), 0, 0, w.y(), w.z(), 0,  //
      0, w.y(), 0, w.x(), 0, w.z(),          //
      0, 0, w.z(), 0, w.x(), w.y();
  return moment.attitude.toRotationMatrix() * momentum;
}

Eigen::Matrix3d tensorFrom(const Entries& entries) {
  Eigen::Matrix3d tensor;
  tensor << entries[0], entries[3], entries[4],  //
      entries[3], entries[1], entries[5],        //
      entries[4], entries[5], entries[2];
  return tensor;
}

Eigen::Vector3d freeSpinAfter(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& spin,
                              double interval) {
  FreeSpin free(tensor, spin, std::numeric_limits<double>::max());
  free.advance(interval);
  return free.spin();
}

Linear solveLinear(Readings flight) {
  std::vector<Rate> rates;
  for (const InertialReading& reading : flight) rates.push_back(reading.rate);
  const std::vector<RecordedMoment> moments = integrateRates(rates);
  std::vector<std::size_t> ends = breaksIn(rates);
  ends.push_back(moments.size());
  // The squares of each momentum minus the mean of those that ought to be the same
  Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
  std::vector<MomentumMatrix> means;
  std::size_t start = 0;
  for (const std::size_t end : ends) {
    means.push_back(meanMomentum(moments, start, end));
    for (std::size_t i = start; i < end; ++i) {
      const MomentumMatrix difference = momentumMatrix(moments[i]) - means.back();
      squares += difference.transpose() * difference;
    }
    start = end;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(squares);
  const Entries entries = solver.eigenvectors().col(0);
  // Rounding of the squares hides what is smaller than this share of the largest
  const double least = 1e-16 * solver.eigenvalues()[5];
  const double smallest = std::sqrt(std::max(solver.eigenvalues()[0], least));
  Linear linear;
  linear.tensor = tensorFrom(entries);
  linear.gap = std::sqrt(std::max(solver.eigenvalues()[1], least)) / smallest;
  double size = 0;
  for (const MomentumMatrix& mean : means) size += (mean * entries).norm();
  linear.change = smallest / std::sqrt(static_cast<double>(rates.size())) *
                  static_cast<double>(means.size()) / size;
  return linear;
}

MomentumMatrix meanMomentum(const std::vector<RecordedMoment>& moments, std::size_t start,
                            std::size_t end) {
  MomentumMatrix sum = MomentumMatrix::Zero();
  for (std::size_t i = start; i < end; ++i) sum += momentumMatrix(moments[i]);
  return sum / static_cast<double>(end - start);
}

bool isFollowed(Readings flight, const Parameters& start) {
  constexpr double kLargestTurn = 1;  // [rad]
  for (std::size_t i = 1; i < flight.size(); ++i) {
    const double step = flight[i].rate.time - flight[i - 1].rate.time;
    if (flight[i].rate.angularVelocity.norm() * step > kLargestTurn) return false;
  }
  return principalMoments(tensorOf(start))[0] > 0;
}

FreeSpinFit fitFreeSpin(Readings flight, Parameters p, const Eigen::Vector3d& biasVariance) {
  constexpr int kMaxIterations = 40;
  constexpr int kMaxHalvings = 20;
  const double unreached = unreachedIn(flight);
  double error = residualsOf(flight, p, unreached).squaredNorm();
  for (int i = 0; i < kMaxIterations; ++i) {
    const Slopes slopes = slopesOf(flight, p, unreached);
    Parameters step = -inverseOf(productOf(slopes, slopes)) *
                      productOf(slopes, residualsOf(flight, p, unreached));
    // Halve a step that doesn't lessen the error
    bool isLess = false;
    for (int k = 0; k < kMaxHalvings && !isLess; ++k, step /= 2) {
      const double next = residualsOf(flight, p + step, unreached).squaredNorm();
      isLess = next < error;
      if (isLess) p += step;
      if (isLess) error = next;
    }
    if (!isLess && !stepDamped(flight, unreached, p, error)) break;
  }
  FreeSpinFit fit;
  fit.parameters = p;
  const double count = 3.0 * static_cast<double>(flight.size());
  const double variance = error / (count - kParameters);
  fit.covariance = covarianceOf(slopesOf(flight, p, unreached), variance, biasVariance);
  fit.residual = std::sqrt(error / count);
  return fit;
}

FreeSpinFit nearestFreeSpin(Readings flight, const Parameters& start,
                            const Eigen::Vector3d& biasVariance, double noise) {
  constexpr double kMuch = 3, kLess = 0.9;
  constexpr double kPart = 1e-3;  // of the spin, where the noise isn't known
  const double enough = std::max(kMuch * noise, kPart * start.tail<3>().norm());
  FreeSpinFit fit = fitFreeSpin(flight, start, biasVariance);
  const auto take = [&](const Parameters& from) {
    const FreeSpinFit other = fitFreeSpin(flight, from, biasVariance);
    if (other.residual < kLess * fit.residual) fit = other;
  };
  if (fit.residual > enough) take(parametersOf(Eigen::Matrix3d::Identity(), start.tail<3>()));
  if (fit.residual > enough) {
    if (const auto grown = grownStart(flight)) take(*grown);
  }
  return fit;
}

}  // namespace rotatebook::recording
