// A solid of one density.
#pragma once

#include "body/mass_properties.h"
#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// A solid's surface [m], and its mass properties at a density of 1 kg/m^3: in closed form where
/// there is one, else those of the surface.
struct SolidPiece {
  TriangleMesh surface;
  MassProperties properties;
};

}  // namespace rotatebook::body
