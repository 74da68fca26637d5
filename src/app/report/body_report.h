// Reports on a body's mass properties, as text and as JSON.
#pragma once

#include <array>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "body/mass_properties.h"

namespace rotatebook::report {

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

/// A body and where it comes from.
struct BodyNumbers {
  std::string name;
  body::MassProperties properties;
  std::optional<BodySurface> surface{};  ///< Nothing for the book.
};

/// The bodies of a scene's motions, or the one of a mesh.
struct Bodies {
  std::string name;                 ///< The scene's or the mesh's.
  std::vector<BodyNumbers> bodies;  ///< One or more; several are a scene's panels.
};

/// Prints size, mass, centre, inertia, and the stability of a spin about each principal axis.
void reportBodies(const Bodies& bodies, std::ostream& output);

/// Prints one JSON object: "name", "volume_m3", "mass_kg", "centre_m", "inertia_kgm2" (3x3 about
/// the centre), "principal_moments_kgm2" (ascending), "principal_axes" (a unit vector for each
/// moment, right-handed), "triangles" and "shells" (null for the book), "crossing" and
/// "overlap" (the numbers of two triangles, from 1, or null), "notes", "closed". Of several bodies:
/// "name", and these as "bodies".
void reportBodiesAsJson(const Bodies& bodies, std::ostream& output);

}  // namespace rotatebook::report
