// The mass properties of bodies that scenes state.
#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "body/mass_properties.h"
#include "body/solid_piece.h"
#include "body/surface.h"
#include "rigid/inertia.h"
#include "scene/solid.h"

namespace rotatebook::scene {

/// The numbers of a solid that a motion takes.
struct SolidNumbers {
  /// Along the axes of the solid, with its centre as it is placed; that of a mesh is 0.
  body::MassProperties properties;
  Eigen::Vector3d size{0, 0, 0};  ///< Of the box around it whose middle is its centre. [m]
  rigid::Inertia inertia;         ///< Of the properties.
};

/// Returns the mass properties of a solid that isn't the book: sums of its parts', also where they
/// overlap. Throws InputError if lengths don't fit each other, no mass is left, or no body has such
/// an inertia.
SolidNumbers numbersOf(const Solid& solid);

/// Returns a part's density, or else its shape's. [kg/m^3]
double densityOf(const BodyPart& part);

/// Returns a part in its place, of density 1. [m] Throws InputError if its lengths don't fit.
body::SolidPiece placed(const BodyPart& part);

/// Returns the look of a solid around its centre of mass: of its parts, but for those that take
/// away, or of its mesh, whose file was read. [m] Throws InputError if it has more than
/// body::kMaxDrawnTriangles, or is a mesh whose look can't be read.
body::Surface surfaceOf(const Solid& solid);

/// Reads the mesh called `name`: its numbers, in its own unit, and its content. Throws InputError
/// as meshes::readMesh() does, and if it encloses no volume.
MeshFile readMeshFile(const std::string& name, std::string_view bytes);
/// Gives `mesh` the content of its file. Throws InputError likewise, and if the file has other
/// numbers.
void takeMeshFile(std::string_view bytes, MeshFile& mesh);

}  // namespace rotatebook::scene
