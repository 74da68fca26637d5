// Reports on a body's mass properties, as text and as JSON. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "body/mass_properties.h"

namespace rotatebook::cli {

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

/// Prints size, mass, centre, inertia, and the stability of a spin about the middle axis.
void reportBody(const BodyNumbers& numbers, std::ostream& output);

/// Returns a JSON object: "volume_m3", "mass_kg", "centre_m", "inertia_kg_m2" (3x3 about the
/// centre), "moments_kg_m2" (ascending), "axes" (a unit vector for each moment, right-handed),
/// "triangles" and "shells" (null for the book), "crossing" and "overlap" (the numbers of two
/// triangles, from 1, or null), "notes", "closed".
Json bodyJson(const BodyNumbers& numbers);

}  // namespace rotatebook::cli
