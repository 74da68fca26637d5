// Reports on a body's mass properties, as text and as JSON.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

#include "body/mass_properties.h"

namespace rotatebook::report {

/// The triangles that a body was measured by.
struct BodySurface {
  std::size_t triangles = 0;
  std::size_t shells = 0;  ///< Connected surfaces.
};

/// A body and where it comes from.
struct BodyNumbers {
  std::string name;
  body::MassProperties properties;
  std::optional<BodySurface> surface{};  ///< Nothing for the body of a scene.
};

/// Prints size, mass, centre, inertia, and the stability of a spin about each principal axis.
void reportBody(const BodyNumbers& body, std::ostream& output);

/// Prints one JSON object: "name", "volume_m3", "mass_kg", "centre_m", "inertia_kgm2" (3x3 about
/// the centre), "principal_moments_kgm2" (ascending), "principal_axes" (a unit vector for each
/// moment, right-handed), "triangles" and "shells" (null for the body of a scene), "closed".
void reportBodyAsJson(const BodyNumbers& body, std::ostream& output);

}  // namespace rotatebook::report
