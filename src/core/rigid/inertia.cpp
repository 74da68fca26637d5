#include "rigid/inertia.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/number_text.h"
#include "rigid/regime.h"

namespace rotatebook::rigid {
namespace {

// Rounding that is allowed in a computed tensor, as a fraction of its largest entry, and between
// moments that count as equal.
constexpr double kRounding = 1e-12;

// Keeps products of several moments and spins normal numbers. [kg m^2]
constexpr double kMinMoment = 1e-30;

void checkSymmetric(const Eigen::Matrix3d& tensor) {
  const double slack = kRounding * tensor.cwiseAbs().maxCoeff();
  for (int row = 0; row < 3; ++row) {
    for (int column = row + 1; column < 3; ++column) {
      const double here = tensor(row, column), there = tensor(column, row);
      if (std::abs(here - there) <= slack) continue;
      const std::string pair = {"xyz"[row], "xyz"[column]};
      throw InputError("an inertia tensor must be symmetric, but its " + pair + " entries are " +
                       shortestText(here) + " and " + shortestText(there));
    }
  }
}

// Residue of double-double arithmetic where a number should be 0, as a fraction of the largest.
constexpr double kResidue = 0x1p-96;

using Matrix = std::array<DoubleDouble3, 3>;  // rows

// Applies the Jacobi rotation that makes the symmetric tensor's entry (p, q) 0, and rotates the
// columns of `axes` likewise. (Golub and Van Loan, section 8.5)
void annul(std::size_t p, std::size_t q, Matrix& tensor, Matrix& axes) {
  const DoubleDouble entry = tensor[p][q];
  if (entry.high == 0) return;
  const DoubleDouble tau = (tensor[q][q] - tensor[p][p]) / (entry * 2.0);
  const DoubleDouble size = DoubleDouble(1.0) / (absolute(tau) + hypotenuse(tau, 1.0));
  const DoubleDouble tangent = tau.high < 0 ? -size : size;
  const DoubleDouble cosine = DoubleDouble(1.0) / hypotenuse(tangent, 1.0);
  const DoubleDouble sine = tangent * cosine;
  const auto turn = [&](DoubleDouble& a, DoubleDouble& b) {
    const DoubleDouble before = a;
    a = cosine * a - sine * b;
    b = sine * before + cosine * b;
  };
  tensor[p][p] = tensor[p][p] - tangent * entry;
  tensor[q][q] = tensor[q][q] + tangent * entry;
  const std::size_t r = 3 - p - q;
  turn(tensor[r][p], tensor[r][q]);
  tensor[p][r] = tensor[r][p];
  tensor[q][r] = tensor[r][q];
  tensor[p][q] = tensor[q][p] = 0.0;
  for (DoubleDouble3& row : axes) turn(row[p], row[q]);
}

// Diagonalizes `tensor`, whose entries are under 2, in place; returns its axes as columns.
Matrix diagonalize(Matrix& tensor) {
  constexpr int kSweeps = 12;  // measured 5: each squares the remainder
  constexpr double kEnough = 1e-33;
  Matrix axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    annul(0, 1, tensor, axes);
    annul(0, 2, tensor, axes);
    annul(1, 2, tensor, axes);
    const double left = std::fabs(tensor[0][1].high) + std::fabs(tensor[0][2].high);
    if (left < kEnough) break;
  }
  return axes;
}

// Sorts the moments, smallest first; makes nearly equal ones equal and the axes right-handed.
PrincipalAxes sorted(DoubleDouble3 moments, const Matrix& columns, double unit) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, [&](auto a, auto b) { return moments[a] < moments[b]; });
  const double minGap = kResidue * moments[order[2]].high;
  for (std::size_t i = 1; i < 3; ++i) {
    DoubleDouble &before = moments[order[i - 1]], &here = moments[order[i]];
    if (std::fabs((here - before).high) < minGap) here = before;
  }
  PrincipalAxes axes;
  for (int i = 0; i < 3; ++i) {
    const std::size_t from = order[static_cast<std::size_t>(i)];
    axes.moments[i] = moments[from].high * unit;
    axes.momentsLow[i] = moments[from].low * unit;
    for (int j = 0; j < 3; ++j) {
      axes.bodyFromPrincipal(j, i) = columns[static_cast<std::size_t>(j)][from].high;
      axes.bodyFromPrincipalLow(j, i) = columns[static_cast<std::size_t>(j)][from].low;
    }
  }
  const auto& p = axes.bodyFromPrincipal;
  if (p.col(0).cross(p.col(1)).dot(p.col(2)) < 0) {
    axes.bodyFromPrincipal.col(2) = -axes.bodyFromPrincipal.col(2);
    axes.bodyFromPrincipalLow.col(2) = -axes.bodyFromPrincipalLow.col(2);
  }
  return axes;
}

// Rounds the moments for people: an eigensolver comes only near a whole number.
std::string momentsText(const Eigen::Vector3d& moments) {
  const auto text = [](double moment) { return roundedText(moment, 9); };
  return "its principal moments are " + text(moments[0]) + ", " + text(moments[1]) + " and " +
         text(moments[2]) + " kg m^2";
}

// Returns the angle by which rounding may have turned an axis: the larger, the closer its moment is
// to another. It is capped at the rounding of a double, because moments so close that it would be
// larger let no spin grow. [rad]
double axisRounding(const Eigen::Vector3d& moments, int axis) {
  constexpr double kMax = 0x1p-60;
  double minGap = moments.maxCoeff();
  for (int other = 0; other < 3; ++other) {
    const double gap = std::fabs(moments[other] - moments[axis]);
    if (gap > 0) minGap = std::min(minGap, gap);
  }
  return std::min(kMax, kResidue * moments.maxCoeff() / minGap);
}

}  // namespace

DoubleDouble3 PrincipalAxes::preciseMoments() const {
  return {DoubleDouble{moments[0], momentsLow[0]}, DoubleDouble{moments[1], momentsLow[1]},
          DoubleDouble{moments[2], momentsLow[2]}};
}

DoubleDouble3 PrincipalAxes::alongPrincipal(const Eigen::Vector3d& v) const {
  if (bodyFromPrincipal.isIdentity(0)) return {v[0], v[1], v[2]};
  const double size = v.cwiseAbs().maxCoeff();
  DoubleDouble3 along;
  for (int i = 0; i < 3; ++i) {
    DoubleDouble sum;
    for (int j = 0; j < 3; ++j) {
      sum = sum + DoubleDouble{bodyFromPrincipal(j, i), bodyFromPrincipalLow(j, i)} * v[j];
    }
    along[static_cast<std::size_t>(i)] =
        std::fabs(sum.high) < size * axisRounding(moments, i) ? 0.0 : sum;
  }
  return along;
}

Eigen::Vector3d PrincipalAxes::angularVelocity(const Eigen::Vector3d& momentum) const {
  return bodyFromPrincipal * (bodyFromPrincipal.transpose() * momentum).cwiseQuotient(moments);
}

Eigen::Vector3d PrincipalAxes::angularMomentum(const Eigen::Vector3d& velocity) const {
  return bodyFromPrincipal * moments.cwiseProduct(bodyFromPrincipal.transpose() * velocity);
}

PrincipalAxes withEqualMoments(PrincipalAxes axes) {
  const auto order = axesByInertia(axes.moments);
  for (std::size_t i = 1; i < 3; ++i) {
    const int before = order[i - 1], here = order[i];
    if (axes.moments[here] - axes.moments[before] > kRounding * axes.moments[here]) continue;
    axes.moments[here] = axes.moments[before];
    axes.momentsLow[here] = axes.momentsLow[before];
  }
  return axes;
}

void clearRounding(Eigen::Matrix3d& tensor) {
  const double least = 1e-15 * tensor.diagonal().maxCoeff();  // Measured 2e-16.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i != j && std::fabs(tensor(i, j)) < least) tensor(i, j) = 0;
    }
  }
}

PrincipalAxes principalAxes(const Eigen::Matrix3d& tensor) {
  requireSameLayout();
  if (tensor.isDiagonal(0)) return {tensor.diagonal(), Eigen::Matrix3d::Identity()};
  const double unit = powerOfTwoBelow(tensor.cwiseAbs().maxCoeff());
  Matrix entries;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const auto i = static_cast<int>(row), j = static_cast<int>(column);
      entries[row][column] = exactSum(tensor(i, j) / unit, tensor(j, i) / unit) * 0.5;
    }
  }
  const Matrix columns = diagonalize(entries);
  return sorted({entries[0][0], entries[1][1], entries[2][2]}, columns, unit);
}

Inertia checkedInertia(const Eigen::Matrix3d& tensor) {
  if (!tensor.allFinite()) throw InputError("an inertia tensor must be finite");
  checkSymmetric(tensor);
  Inertia inertia(tensor);
  const Eigen::Vector3d& moments = inertia.axes().moments;
  const double largest = moments.maxCoeff();
  if (!(moments.minCoeff() > 0)) {
    throw InputError("an inertia tensor must be positive definite, but " + momentsText(moments));
  }
  if (moments.minCoeff() <= kRounding * largest) {
    throw InputError(
        "an inertia tensor's smallest principal moment must be more than 1e-12 of the largest, "
        "but " +
        momentsText(moments));
  }
  if (largest < kMinMoment) {
    throw InputError("an inertia tensor must have principal moments of 1e-30 kg m^2 or more, but " +
                     momentsText(moments));
  }
  if (largest > (1 + kRounding) * (moments.sum() - largest)) {
    throw InputError(
        "no body has this inertia: a principal moment can't exceed the sum of the other two, but " +
        momentsText(moments));
  }
  return inertia;
}

}  // namespace rotatebook::rigid
