// The mass properties of bodies that scenes state.
#pragma once

#include <Eigen/Core>

#include "body/mass_properties.h"
#include "body/solid_piece.h"
#include "body/surface.h"
#include "scene/solid.h"

namespace rotatebook::scene {

/// The numbers of a solid that a motion takes.
struct SolidNumbers {
  /// Along the axes of the solid, with its centre as it is placed; that of a mesh is 0.
  body::MassProperties properties;
  Eigen::Vector3d size{0, 0, 0};  ///< Of the box around it whose middle is its centre. [m]
};

/// Returns the mass properties of a solid that isn't the book: sums of its parts', also where they
/// overlap. Throws InputError if lengths don't fit each other, no mass is left, or no body has such
/// an inertia.
SolidNumbers numbersOf(const Solid& solid);

/// Returns a part's density, or else its shape's. [kg/m^3]
double densityOf(const BodyPart& part);

/// Returns a part in its place, of density 1. [m] Throws InputError if its lengths don't fit.
body::SolidPiece placed(const BodyPart& part);

/// Returns the looks of a solid's parts, but for those that take away, around its centre of mass.
/// [m] Throws InputError if they have more than body::kMaxDrawnTriangles.
body::Surface surfaceOf(const Solid& solid);
/// Returns the look of a solid that is the mesh of a file, likewise: `file` is what
/// body::readSurface() made of it. Throws InputError if it has more than body::kMaxDrawnTriangles.
body::Surface surfaceOf(const Solid& solid, body::Surface file);

/// Returns the numbers of a closed mesh, in its own unit. Throws InputError if it encloses no
/// volume.
MeshFile meshFileOf(const std::string& name, const body::TriangleMesh& mesh);

}  // namespace rotatebook::scene
