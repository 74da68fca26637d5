// The shapes that a scene can name.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "body/solid_piece.h"
#include "body/surface.h"

namespace rotatebook::body {

/// A length that a shape is made from.
struct ShapeLength {
  std::string_view name;  ///< As in scenes: "radius".
  double byDefault = 0;   ///< > 0. [m]
};

/// A part of a body that counts as a point.
struct PointMass {
  double mass = 0;                 ///< > 0. [kg]
  Eigen::Vector3d place{0, 0, 0};  ///< From the body's centre of mass. [m]
};

/// A row of shape_list.inc.
struct Shape {
  std::string_view name;  ///< As in scenes: "t-handle".
  double density = 0;     ///< Of its usual material, > 0. [kg/m^3]
  std::vector<ShapeLength> lengths;
  /// Makes the solid from one length [m] > 0 for each of `lengths`; of several closed surfaces,
  /// each counts, also where they overlap. Throws InputError if the lengths don't fit each other.
  SolidPiece (*solid)(std::span<const double> lengths) = nullptr;
  /// Makes its surface as it looks, within the box around the solid; called after `solid`.
  Surface (*look)(std::span<const double> lengths) = nullptr;
  /// Returns the points that have all of its mass, at a density of 1 kg/m^3; null of solids.
  std::vector<PointMass> (*weights)(std::span<const double> lengths) = nullptr;
};

/// Returns all shapes, in the order of their list.
std::span<const Shape> allShapes();

/// Returns the shape of that name; null if there is none.
const Shape* findShape(std::string_view name);

}  // namespace rotatebook::body
