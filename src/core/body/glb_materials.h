// The materials of a .glb file. Inside the room only.
#pragma once

#include "body/glb_document.h"
#include "body/surface.h"

namespace rotatebook::body {

/// Sets the materials of a surface to those of the document, by their numbers, and a neutral one
/// after them; and its images to those that they use. Throws InputError for a picture that isn't in
/// the file, a number that isn't one, or more than kMaxMaterials.
void readMaterials(const GlbDocument& document, Surface& surface);

inline constexpr std::size_t kMaxMaterials = 256;

}  // namespace rotatebook::body
