#include "recording/toss.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "base/error.h"
#include "base/number_text.h"

namespace rotatebook::recording {
namespace {

constexpr int kParameters = 8;  // five of the tensor, whose trace is 1, and three of the start
using Parameters = Eigen::Matrix<double, kParameters, 1>;
using Slopes = Eigen::Matrix<double, Eigen::Dynamic, kParameters>;
using Readings = std::span<const InertialReading>;

constexpr double kFreeForce = 2;                                 // [m/s^2]
constexpr double kSlowest = 1;                                   // of a toss [rad/s]
constexpr double kRest = 0.15;                                   // largest rate of a rest [rad/s]
constexpr double kShortestRest = 0.2;                            // [s]
constexpr std::size_t kMinReadings = 20, kMaxReadings = 20'000;  // of a flight
constexpr double kWidest = 0.5;                                  // interval of a ratio
constexpr double kTrimmed = 0.02;                                // of a flight, at each end

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

/// Returns the principal moments, smallest first.
Eigen::Vector3d momentsOf(const Eigen::Matrix3d& tensor) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

Eigen::Vector2d ratiosOf(const Parameters& p) {
  const Eigen::Vector3d moments = momentsOf(tensorOf(p));
  return moments.head<2>() / moments[2];
}

/// Free motion of the angular velocity, in body axes, by the classical Runge-Kutta method.
class FreeSpin {
 public:
  explicit FreeSpin(const Parameters& p)
      : tensor_(tensorOf(p)), inverse_(tensor_.inverse()), spin_(p.tail<3>()) {}

  const Eigen::Vector3d& spin() const { return spin_; }

  void advance(double interval) {
    constexpr double kTurn = 0.05;  // largest of a step [rad]
    constexpr double kMaxSteps = 1000;
    const double turn = interval * spin_.norm();
    if (!std::isfinite(turn)) return;  // of parameters that are refused by their error
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
};

/// Returns the rates minus those of the free motion, three for each reading. [rad/s]
Eigen::VectorXd residualsOf(Readings flight, const Parameters& p) {
  Eigen::VectorXd residuals(3 * static_cast<Eigen::Index>(flight.size()));
  FreeSpin free(p);
  for (std::size_t i = 0; i < flight.size(); ++i) {
    if (i > 0) free.advance(flight[i].rate.time - flight[i - 1].rate.time);
    residuals.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        flight[i].rate.angularVelocity - free.spin();
  }
  return residuals;
}

Slopes slopesOf(Readings flight, const Parameters& p) {
  constexpr double kStep = 1e-6;
  Slopes slopes(3 * static_cast<Eigen::Index>(flight.size()), kParameters);
  for (int i = 0; i < kParameters; ++i) {
    Parameters up = p, down = p;
    up[i] += kStep;
    down[i] -= kStep;
    slopes.col(i) = (residualsOf(flight, up) - residualsOf(flight, down)) / (2 * kStep);
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

/// A rest before the flight, and the gyroscope's bias that it shows.
struct Rest {
  double duration = 0;  // 0 if there is none [s]
  Eigen::Vector3d bias{0, 0, 0};
  Eigen::Vector3d variance{0, 0, 0};  // of the bias, by the scatter of the rates [rad^2/s^2]
};

/// A free motion that is fitted to rates.
struct Fit {
  Parameters parameters;
  Eigen::Matrix<double, kParameters, kParameters> covariance;
  double residual = 0;  // root mean square [rad/s]
};

/// Returns the covariance of the parameters: by the noise of the flight's rates, and by the error
/// of the bias, which shifts all of an axis alike.
Eigen::Matrix<double, kParameters, kParameters> covarianceOf(const Slopes& slopes, double variance,
                                                             const Rest& rest) {
  const Eigen::Matrix<double, kParameters, kParameters> inverse =
      productOf(slopes, slopes).inverse();
  Eigen::Matrix<double, kParameters, 3> sums = Eigen::Matrix<double, kParameters, 3>::Zero();
  for (Eigen::Index row = 0; row < slopes.rows(); ++row)
    sums.col(row % 3) += slopes.row(row).transpose();
  const Eigen::Matrix<double, kParameters, 3> byBias = inverse * sums;
  return variance * inverse + byBias * rest.variance.asDiagonal() * byBias.transpose();
}

Fit refined(Readings flight, Parameters p, const Rest& rest) {
  constexpr int kMaxIterations = 20;
  constexpr int kMaxHalvings = 20;
  double error = residualsOf(flight, p).squaredNorm();
  for (int i = 0; i < kMaxIterations; ++i) {
    const Slopes slopes = slopesOf(flight, p);
    Parameters step =
        -productOf(slopes, slopes).ldlt().solve(productOf(slopes, residualsOf(flight, p)));
    // Halve a step that doesn't lessen the error
    bool isLess = false;
    for (int k = 0; k < kMaxHalvings && !isLess; ++k, step /= 2) {
      const double next = residualsOf(flight, p + step).squaredNorm();
      isLess = next < error;
      if (isLess) p += step;
      if (isLess) error = next;
    }
    if (!isLess) break;
  }
  Fit fit;
  fit.parameters = p;
  const double count = 3.0 * static_cast<double>(flight.size());
  const double variance = error / (count - kParameters);
  fit.covariance = covarianceOf(slopesOf(flight, p), variance, rest);
  fit.residual = std::sqrt(error / count);
  return fit;
}

/// Start values of the fit, and how far the motion determines them.
struct Linear {
  Eigen::Matrix3d tensor;
  double gap = 0;
};

Linear solveLinear(Readings flight) {
  std::vector<Rate> rates;
  for (const InertialReading& reading : flight) rates.push_back(reading.rate);
  const std::vector<RecordedMoment> moments = integrateRates(rates);
  double fastest = 0;
  for (const Rate& rate : rates) fastest = std::max(fastest, rate.angularVelocity.norm());
  Eigen::MatrixXd equations(3 * static_cast<Eigen::Index>(rates.size()), 9);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const Eigen::Vector3d w = rates[i].angularVelocity;
    // I w, as a matrix times the entries xx, yy, zz, xy, xz, yz
    Eigen::Matrix<double, 3, 6> entries;
    entries << w.x(), 0, 0, w.y(), w.z(), 0,  //
        0, w.y(), 0, w.x(), 0, w.z(),         //
        0, 0, w.z(), 0, w.x(), w.y();
    const auto row = 3 * static_cast<Eigen::Index>(i);
    equations.block<3, 6>(row, 0) = moments[i].attitude.toRotationMatrix() * entries;
    // In a unit in which the momentum is as large as the tensor's entries
    equations.block<3, 3>(row, 6) = -fastest * Eigen::Matrix3d::Identity();
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(equations, Eigen::ComputeThinV);
  const Eigen::VectorXd null = svd.matrixV().col(8);
  Linear linear;
  linear.tensor << null[0], null[3], null[4],  //
      null[3], null[1], null[5],               //
      null[4], null[5], null[2];
  constexpr double kLargestGap = 1e12;
  linear.gap = std::min(svd.singularValues()[7] / svd.singularValues()[8], kLargestGap);
  return linear;
}

std::pair<std::size_t, std::size_t> between(const InertialRecording& recording, double from,
                                            double to) {
  const auto& all = recording.readings;
  const auto isIn = [&](const InertialReading& one) {
    return one.rate.time >= from && one.rate.time <= to;
  };
  const auto first = std::find_if(all.begin(), all.end(), isIn);
  const auto end = std::find_if_not(first, all.end(), isIn);
  return {static_cast<std::size_t>(first - all.begin()),
          static_cast<std::size_t>(end - all.begin())};
}

/// Returns the longest run of readings in free flight, without its ends.
std::pair<std::size_t, std::size_t> longestFlight(const InertialRecording& recording,
                                                  double lever) {
  std::pair<std::size_t, std::size_t> longest{0, 0};
  std::size_t start = 0;
  for (std::size_t i = 0; i <= recording.readings.size(); ++i) {
    bool isFree = false;
    if (i < recording.readings.size()) {
      const InertialReading& one = recording.readings[i];
      const double rate = one.rate.angularVelocity.norm();
      isFree = rate > kSlowest && one.force.norm() < kFreeForce + rate * rate * lever;
    }
    if (isFree) continue;
    if (i - start > longest.second - longest.first) longest = {start, i};
    start = i + 1;
  }
  const double length = static_cast<double>(longest.second - longest.first);
  const auto trim = static_cast<std::size_t>(std::ceil(kTrimmed * length));
  if (longest.second - longest.first <= 2 * trim) return {0, 0};
  return {longest.first + trim, longest.second - trim};
}

std::pair<std::size_t, std::size_t> flightIn(const InertialRecording& recording,
                                             const std::string& name, const TossOptions& options) {
  const bool isStated = options.from || options.to;
  if (!isStated && !recording.hasForce) {
    throw InputError(name +
                     ": no accelerometer's columns (ax to az) that show the flight; state it with "
                     "--from and --to");
  }
  constexpr double kEver = 1e13;  // [s]
  const auto flight =
      isStated ? between(recording, options.from.value_or(-kEver), options.to.value_or(kEver))
               : longestFlight(recording, options.lever);
  const std::size_t count = flight.second - flight.first;
  if (count > kMaxReadings) {
    throw InputError(name + ": the flight has " + std::to_string(count) + " readings; up to " +
                     std::to_string(kMaxReadings) +
                     " are fitted: state a shorter one with --from and --to");
  }
  if (count >= kMinReadings) return flight;
  throw InputError(
      name + ": " + (isStated ? "the flight has " : "the longest flight that was found has ") +
      std::to_string(count) + " readings, but at least " + std::to_string(kMinReadings) +
      " are needed; state another with --from and --to");
}

/// Returns the rest that these readings are.
Rest restOf(Readings readings) {
  const auto count = static_cast<double>(readings.size());
  Rest rest;
  rest.duration = readings.back().rate.time - readings.front().rate.time;
  for (const InertialReading& one : readings) rest.bias += one.rate.angularVelocity / count;
  for (const InertialReading& one : readings)
    rest.variance += (one.rate.angularVelocity - rest.bias).cwiseAbs2() / (count * (count - 1));
  return rest;
}

/// Returns the longest rest before the flight.
Rest restBefore(Readings before) {
  Rest longest;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= before.size(); ++i) {
    if (i < before.size() && before[i].rate.angularVelocity.norm() < kRest) continue;
    const double length = i > start ? before[i - 1].rate.time - before[start].rate.time : 0;
    if (length > std::max(longest.duration, kShortestRest))
      longest = restOf(before.subspan(start, i - start));
    start = i + 1;
  }
  return longest;
}

/// Returns the ratios with their intervals, by the slopes of the ratios.
std::array<Estimate, 2> estimatesOf(const Fit& fit, std::size_t readings) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 2, kParameters> slopes;
  for (int i = 0; i < kParameters; ++i) {
    Parameters up = fit.parameters, down = fit.parameters;
    up[i] += kStep;
    down[i] -= kStep;
    slopes.col(i) = (ratiosOf(up) - ratiosOf(down)) / (2 * kStep);
  }
  const Eigen::Matrix2d covariance = slopes * fit.covariance * slopes.transpose();
  const Eigen::Vector2d ratios = ratiosOf(fit.parameters);
  // Student's quantile for 95 %, to 1 % from 20 degrees of freedom on.
  const double quantile = 1.96 + 2.4 / (3.0 * static_cast<double>(readings) - kParameters);
  std::array<Estimate, 2> estimates;
  for (int i = 0; i < 2; ++i) {
    const double half = quantile * std::sqrt(covariance(i, i));
    estimates[static_cast<std::size_t>(i)] = {ratios[i], ratios[i] - half, ratios[i] + half};
  }
  return estimates;
}

/// Returns the tensor of a body, as a multiple of its largest moment.
Eigen::Matrix3d bodysTensor(const Eigen::Matrix3d& tensor) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(tensor);
  Eigen::Vector3d moments = axes.eigenvalues();
  // No moment is larger than the sum of the others, with some room for rounding
  constexpr double kRoom = 1e-9;
  moments[2] = std::min(moments[2], (moments[0] + moments[1]) * (1 - kRoom));
  const Eigen::Matrix3d result =
      axes.eigenvectors() * (moments / moments[2]).asDiagonal() * axes.eigenvectors().transpose();
  return (result + result.transpose()) / 2;
}

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
  throw InputError(name + ": the motion doesn't tell the inertia: " + reason +
                   "; toss the body so that it tumbles, spun about its middle axis");
}

void requireTelling(const TossFit& fit, const std::string& name) {
  for (const Estimate& ratio : fit.ratios) {
    const double width = ratio.high - ratio.low;
    if (width <= kWidest && ratio.value > 0) continue;
    refuse(name, "a ratio of moments is " + roundedText(ratio.value, 3) +
                     ", with an interval that is " + roundedText(width, 2) + " wide");
  }
  const auto& [smallest, middle] = fit.ratios;
  if (smallest.high + middle.high >= 1) return;
  throw InputError(name + ": the ratios of moments are " + roundedText(smallest.value, 4) +
                   " and " + roundedText(middle.value, 4) +
                   ", but those of a body add up to 1 or more; is a column's sign or scale wrong?");
}

}  // namespace

TossFit fitToss(const InertialRecording& recording, const std::string& name,
                const TossOptions& options) {
  const auto [first, end] = flightIn(recording, name, options);
  const Rest rest = restBefore(Readings(recording.readings).first(first));
  TossFit result;
  result.bias = rest.bias;
  result.rest = rest.duration;
  std::vector<InertialReading> flight(
      recording.readings.begin() + static_cast<std::ptrdiff_t>(first),
      recording.readings.begin() + static_cast<std::ptrdiff_t>(end));
  for (InertialReading& one : flight) one.rate.angularVelocity -= result.bias;
  result.from = flight.front().rate.time;
  result.to = flight.back().rate.time;
  result.readings = flight.size();

  const Linear linear = solveLinear(flight);
  result.gap = linear.gap;
  if (!(linear.gap >= kSmallestGap)) {
    refuse(name, "the gap of its singular values is " + roundedText(linear.gap, 3) +
                     ", which is less than " + roundedText(kSmallestGap, 1));
  }
  const Fit fit =
      refined(flight, parametersOf(linear.tensor, flight.front().rate.angularVelocity), rest);
  result.residual = fit.residual;
  result.ratios = estimatesOf(fit, flight.size());
  requireTelling(result, name);
  result.start = fit.parameters.tail<3>();
  result.inertia = bodysTensor(tensorOf(fit.parameters));
  return result;
}

}  // namespace rotatebook::recording
