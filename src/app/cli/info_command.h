// Reports on a body's mass properties, as text and as JSON. Inside the room only.
#pragma once

#include <iosfwd>

#include "base/json.h"
#include "scene/body_numbers.h"

namespace rotatebook::cli {

/// Prints size, mass, centre, inertia, and the stability of a spin about the middle axis.
void reportBody(const scene::BodyNumbers& numbers, std::ostream& output);

/// Returns a JSON object: "volume_m3", "mass_kg", "centre_m", "inertia_kg_m2" (3x3 about the
/// centre), "moments_kg_m2" (ascending), "axes" (a unit vector for each moment, right-handed),
/// "triangles" and "shells" (null for the book), "crossing" and "overlap" (the numbers of two
/// triangles, from 1, or null), "notes", "closed".
Json bodyJson(const scene::BodyNumbers& numbers);

}  // namespace rotatebook::cli
