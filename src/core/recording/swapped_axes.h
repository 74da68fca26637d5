// Swapped and negated columns, and axes that are turned. Inside the room only.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "recording/rate_fit.h"

namespace rotatebook::recording {

/// Rates, and the slopes of the attitudes beside them along the axes of both kinds.
struct RatesAndSlopes {
  const Vectors& rates;
  const Vectors& alongBody;
  const Vectors& alongWorld;
  bool areRatesAlongBody;  ///< As the table is read.
  bool haveQuaternions = true;
};

/// A mistake in a table's axes.
struct AxesMistake {
  std::string text;
  Multiple multiple{};            ///< Of the rates by the slopes without it.
  Eigen::Vector3d turn{0, 0, 0};  ///< Of turned axes, a rotation vector. [rad]
};

/// Returns the columns of rates or of quaternions that are swapped or negated, by the rates' fit to
/// the slopes with as few of them as possible.
AxesMistake swappedColumns(const RatesAndSlopes& table);

/// Returns the constant rotation from the attitudes' axes to those of the rates that fits best;
/// nothing where the rates hardly leave a plane's axis, so that others fit as well.
std::optional<AxesMistake> turnedAxes(const RatesAndSlopes& table);

/// Returns that the rates are along these axes, and how to state it.
std::string alongText(bool areAlongBody);

}  // namespace rotatebook::recording
