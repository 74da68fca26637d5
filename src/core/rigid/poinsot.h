// Poinsot's construction of a free motion, and the energies between which it lies.
#pragma once

#include <Eigen/Core>

namespace rotatebook::rigid {

/// Poinsot's construction. The inertia ellipsoid rho . I rho = 1 turns with the body and rolls,
/// without slipping, on a plane across L, which is at rest in the world as long as energy and L
/// are conserved. Lengths are in 1 / (m sqrt(kg)). Of a body at rest all of it is NaN.
struct Poinsot {
  Eigen::Vector3d contact;  ///< rho = w / sqrt(2 E), along the principal axes.
  double distance;          ///< Of the plane from the centre, sqrt(2 E) / |L|.
};

/// Takes principal moments [kg m^2] and the angular momentum along their axes [kg m^2/s].
Poinsot poinsotOf(const Eigen::Vector3d& moments, const Eigen::Vector3d& momentum);

/// Returns the inertia ellipsoid's semi-axes, 1 / sqrt(I).
Eigen::Vector3d inertiaSemiAxes(const Eigen::Vector3d& moments);

/// Radii between which the contact point goes on the plane: those of the herpolhode.
struct HerpolhodeRadii {
  double least, greatest;
};
/// Takes the plane's distance, which is limited to that from the least to the greatest semi-axis.
HerpolhodeRadii herpolhodeRadii(const Eigen::Vector3d& semiAxes, double distance);

/// Returns the energies L^2 / (2 I) of spins with this size of the angular momentum about the
/// principal axes. [J] All motions with it lie between the least and the greatest of the three;
/// at the middle one the regime changes.
Eigen::Vector3d axisEnergies(const Eigen::Vector3d& moments, double momentum);

/// Returns the greatest angle from L to the axis that it circles in the body, the two directions of
/// which count as one. From 0 at the least and the greatest of `energies`, those of the axes, to
/// pi/2 at the middle one; 0 for energies beyond them. [rad]
double reachOfMomentum(const Eigen::Vector3d& energies, double energy);

}  // namespace rotatebook::rigid
