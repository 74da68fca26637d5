// The mass properties of a body, with its principal axes and what is known of its surface.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "body/mass_properties.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// The surface that a body has.
struct BodySurface {
  std::size_t triangles = 0;
  std::size_t shells = 0;  ///< Connected surfaces.
  /// Two triangles that cross each other, from 0; nothing if none are known. Not looked for in
  /// bodies that are sums of shapes, whose parts may overlap.
  std::optional<std::array<std::size_t, 2>> crossing{};
  /// Two triangles at an edge around which something is enclosed twice, or taken away where nothing
  /// is; nothing if there is no such edge.
  std::optional<std::array<std::size_t, 2>> overlap{};
  std::vector<std::string> notes{};  ///< On what was changed or left out of the file.
};

struct BodyNumbers {
  body::MassProperties properties;
  std::optional<BodySurface> surface{};  ///< Nothing for the book.
};

/// Returns the numbers of a motion's body. Throws InputError as numbersOf() does.
BodyNumbers bodyNumbersOf(const Panel& motion);

/// Returns whether a file of this name is a mesh, by its ending.
bool isMesh(std::string_view name);

/// The unit and the substance of a mesh.
struct MeshSubstance {
  double unit = 1;  ///< Of its coordinates. [m]
  /// One of both may be stated; without either the mesh is of water. [kg/m^3, kg]
  std::optional<double> density{}, mass{};
};

/// Returns the numbers of the mesh called `name`. Throws InputError as meshes::readMesh() does, and
/// if no body has such an inertia.
BodyNumbers bodyNumbersOf(const std::string& name, std::string_view bytes,
                          const MeshSubstance& substance);

/// Principal moments, smallest first [kg m^2], and their axes as columns, right-handed.
struct SortedAxes {
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;
  /// Rate at which a deviation from a spin about the middle axis grows, as a share of the spin:
  /// physics::tiltGrowth().
  double growth = 0;
};

SortedAxes sortedAxesOf(const body::MassProperties& properties);

}  // namespace rotatebook::scene
