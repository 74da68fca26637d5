// A body that isn't the book, as scenes state it: a shape, a mesh, or a sum of shapes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "physics/motion_settings.h"

namespace rotatebook::body {
struct ClosedMesh;
}

namespace rotatebook::scene {

/// A shape with its lengths, density and place.
struct BodyPart {
  std::string shape;                ///< The name of one of body::allShapes().
  std::vector<double> lengths{};    ///< One for each of the shape's. [m]
  std::optional<double> density{};  ///< Negative for what is taken away; the shape's by default.
                                    ///< [kg/m^3]
  Eigen::Vector3d place{0, 0, 0};   ///< Of the shape's origin. [m]
  std::optional<physics::Tilt> turn{};  ///< About an axis, before it is moved to its place.

  friend bool operator==(const BodyPart&, const BodyPart&) = default;
};

/// A file's mesh, as far as a motion depends on it.
struct MeshFile {
  std::string name{};             ///< The file; empty for no mesh.
  double unit = 1;                ///< Of its lengths. [m]
  double volume = 0;              ///< Of its unit, > 0.
  Eigen::Vector3d size{0, 0, 0};  ///< Of the box around its centre, in its unit.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< Of density 1, about the centre.
  std::shared_ptr<const body::ClosedMesh> content{};  ///< Of the file, in its unit; null if unread.
  std::string checksum{};                             ///< checksumOf() the file, if it was read.

  /// Compares all but the content, from which the numbers follow.
  friend bool operator==(const MeshFile& a, const MeshFile& b) {
    return a.name == b.name && a.unit == b.unit && a.volume == b.volume && a.size == b.size &&
           a.inertia == b.inertia;
  }
};

/// The part of [body] that replaces the book: one shape, several parts, or the mesh of a file.
struct Solid {
  std::vector<BodyPart> parts{};  ///< Empty for a mesh, and for the book.
  bool isShape = false;           ///< Stated as `shape`, in place of a list of parts.
  MeshFile mesh{};
  std::optional<double> density{};  ///< Of the mesh. [kg/m^3]
  std::optional<double> mass{};     ///< Of the whole, in place of densities. [kg]

  bool isBook() const { return parts.empty() && mesh.name.empty(); }
  friend bool operator==(const Solid&, const Solid&) = default;
};

}  // namespace rotatebook::scene
