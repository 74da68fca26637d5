// Volume, mass, centre of mass and inertia of solid bodies.
#pragma once

#include <Eigen/Core>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// A solid of uniform density, or several as one rigid body.
struct MassProperties {
  double volume = 0;                                  ///< [m^3]
  double mass = 0;                                    ///< [kg]
  Eigen::Vector3d centre{0, 0, 0};                    ///< The centre of mass. [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< About the centre of mass. [kg m^2]
};

/// Returns the mass properties of the body within a welded, closed mesh [m] of the given density
/// [kg/m^3]. Sums tetrahedra from the middle of the mesh's bounding box to its triangles (Mirtich
/// 1996 with the sign correction of 1997; Blow and Binstock 2004), so that a body far from the
/// origin loses nothing; sums are compensated. Throws InputError if the volume isn't positive, or
/// the sizes are too small or too large for doubles.
MassProperties massPropertiesOf(const TriangleMesh& mesh, double density);

/// Returns the same body turned about the origin by a rotation, then moved by `place` [m].
MassProperties moved(const MassProperties& body, const Eigen::Matrix3d& turn,
                     const Eigen::Vector3d& place);

/// Returns the two bodies as one: masses and moments add up, also where they overlap. A density may
/// be negative, for what is taken away. Throws InputError if no mass is left.
MassProperties sumOf(const MassProperties& a, const MassProperties& b);

}  // namespace rotatebook::body
