#include "recording/swapped_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/elementary.h"
#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::recording {
namespace {

using Names = std::array<std::string_view, 3>;

constexpr Names kRateNames{"wx", "wy", "wz"}, kVectorNames{"qx", "qy", "qz"};
constexpr int kOrdersOfThree = 6, kSigns = 8;

/// Columns that hold others, or the others' negatives.
struct Columns3 {
  std::array<std::size_t, 3> held{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};

  int swaps() const {
    const auto moved = (held[0] != 0) + (held[1] != 1) + (held[2] != 2);
    return moved == 0 ? 0 : moved - 1;
  }
  int negatives() const { return (sign[0] < 0) + (sign[1] < 0) + (sign[2] < 0); }
  int changes() const { return swaps() + negatives(); }
  int determinant() const { return (swaps() == 1 ? -1 : 1) * sign[0] * sign[1] * sign[2]; }

  Columns3 transposed() const {
    Columns3 other;
    for (std::size_t i = 0; i < 3; ++i) {
      other.held[held[i]] = i;
      other.sign[held[i]] = sign[i];
    }
    return other;
  }
};

Columns3 columnsOf(int order, int signs) {
  constexpr std::array<std::array<std::size_t, 3>, kOrdersOfThree> kHeld{
      {{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}};
  Columns3 columns{kHeld[static_cast<std::size_t>(order)]};
  for (int i = 0; i < 3; ++i)
    columns.sign[static_cast<std::size_t>(i)] = (signs >> i & 1) != 0 ? -1 : 1;
  return columns;
}

/// Sums over the rates and slopes inside, without the two at each end.
struct Products {
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();  // of rates and slopes
  double rates = 0, slopes = 0;                       // squares

  Products(const Vectors& allRates, const Vectors& allSlopes) {
    for (std::size_t i = 2; i + 2 < allRates.size(); ++i) {
      product += allRates[i] * allSlopes[i].transpose();
      rates += allRates[i].squaredNorm();
      slopes += allSlopes[i].squaredNorm();
    }
  }

  /// Returns the fit by slopes that are turned, whose product with the rates is `along`.
  Multiple multipleOf(double along) const {
    Multiple multiple;
    if (!(along > 0)) return multiple;
    multiple.factor = along / slopes;
    multiple.left =
        std::sqrt(std::max(rates - along * multiple.factor, 0.0) / slopes) / multiple.factor;
    return multiple;
  }
  Multiple multipleOf(const Columns3& columns) const {
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      along += columns.sign[i] *
               product(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(columns.held[i]));
    }
    return multipleOf(along);
  }
};

/// A reading of the columns.
struct ColumnsReading {
  Columns3 columns{};
  bool areOfRates = true;     // else of the quaternions
  bool areOtherAxes = false;  // of the rates
  Multiple multiple{};

  int mistakes() const { return columns.changes() + areOtherAxes + !isOne(multiple.factor); }
};

/// Returns the reading of rates that are columns of the slopes along their axes, or the others.
ColumnsReading readingOf(const RatesAndSlopes& table, const Columns3& columns, bool areOtherAxes,
                         const Multiple& multiple) {
  // An odd change of a quaternion's vector is that of its inverse, along the other axes.
  if (table.haveQuaternions && areOtherAxes && columns.determinant() < 0)
    return {columns.transposed(), false, false, multiple};
  return {columns, true, areOtherAxes, multiple};
}

std::string columnsText(const Columns3& columns, const Names& names) {
  const auto nameOf = [&](std::size_t i) { return std::string(names[i]); };
  std::vector<std::string> negated, held;
  for (std::size_t i = 0; i < 3; ++i) {
    if (columns.sign[i] < 0) negated.push_back(nameOf(i));
    held.push_back((columns.sign[i] < 0 ? "-" : "") + nameOf(columns.held[i]));
  }
  if (columns.swaps() == 0) {
    return negated.size() == 1
               ? "the column " + negated.front() + " has the other sign; negate it"
               : "the columns " + joined(negated, ", ") + " have the other sign; negate them";
  }
  return "the columns " + nameOf(0) + ", " + nameOf(1) + ", " + nameOf(2) + " hold " +
         joined(held, ", ") +
         (negated.empty() ? "; name them in simulation.columns, or with --column"
                          : "; write them so that each holds its own");
}

std::string degreesOf(double radians) {
  return roundedText(radians * 180 / std::numbers::pi, 3) + " degrees";
}

}  // namespace

std::string alongText(bool areAlongBody) {
  const std::string axes = areAlongBody ? "body" : "world";
  return "the rates are along the " + axes + "'s axes; state simulation.rates_along = \"" + axes +
         "\", or --rates-along " + axes;
}

AxesMistake swappedColumns(const RatesAndSlopes& table) {
  constexpr double kAsWell = 2, kRounding = 1e-3;
  const Products body(table.rates, table.alongBody), world(table.rates, table.alongWorld);
  std::vector<ColumnsReading> readings;
  for (int order = 0; order < kOrdersOfThree; ++order) {
    for (int signs = 0; signs < kSigns; ++signs) {
      const Columns3 columns = columnsOf(order, signs);
      if (columns.changes() == 0) continue;
      for (const bool areOther : {false, true}) {
        const Products& products = table.areRatesAlongBody != areOther ? body : world;
        readings.push_back(readingOf(table, columns, areOther, products.multipleOf(columns)));
      }
    }
  }
  double least = readings.front().multiple.left;
  for (const ColumnsReading& reading : readings) least = std::min(least, reading.multiple.left);
  std::erase_if(readings, [&](const ColumnsReading& reading) {
    return !(reading.multiple.left <= kAsWell * least + kRounding);
  });
  if (readings.empty()) return {};
  const ColumnsReading best = *std::ranges::min_element(readings, {}, &ColumnsReading::mistakes);
  std::string text = columnsText(best.columns, best.areOfRates ? kRateNames : kVectorNames);
  // An even change of a quaternion's vector turns both kinds of axes likewise.
  if (table.haveQuaternions && best.areOfRates && !best.areOtherAxes &&
      best.columns.determinant() > 0)
    text += "; or else " + columnsText(best.columns.transposed(), kVectorNames);
  if (best.areOtherAxes) text += "; and " + alongText(!table.areRatesAlongBody);
  return {.text = text, .multiple = best.multiple};
}

std::optional<AxesMistake> turnedAxes(const RatesAndSlopes& table) {
  constexpr double kOfOneAxis = 1e-3;
  const Vectors& slopes = table.areRatesAlongBody ? table.alongBody : table.alongWorld;
  const Products products(table.rates, slopes);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products.product,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d values = svd.singularValues();
  if (values[1] < kOfOneAxis * values[0]) return std::nullopt;
  Eigen::Vector3d signs{1, 1, 1};
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) signs[2] = -1;
  const Eigen::Matrix3d turn = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  const Eigen::Quaterniond rotation(turn);
  const Eigen::Vector3d half = rotation.w() < 0 ? -rotation.vec() : Eigen::Vector3d(rotation.vec());
  const double angle = 2 * arcTangent(half.norm(), std::abs(rotation.w()));
  const Eigen::Vector3d axis = half.stableNormalized();
  const std::string axes = table.areRatesAlongBody ? "body" : "world";
  return AxesMistake{"the attitudes' " + axes + " is turned from that of the rates, by " +
                         degreesOf(angle) + " about (" + roundedText(axis.x(), 3) + ", " +
                         roundedText(axis.y(), 3) + ", " + roundedText(axis.z(), 3) +
                         "); write both along the same axes",
                     products.multipleOf(values.dot(signs)), angle * axis};
}

}  // namespace rotatebook::recording
