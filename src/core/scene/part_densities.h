// The densities of parts where they lie within each other. Inside the room only.
#pragma once

#include <vector>

#include "scene/solid.h"

namespace rotatebook::scene {

/// Throws InputError if the densities of parts that aren't shapes of a body add up to less than 0
/// somewhere, as where one takes away beside the others. Looks at a lattice of points in each part
/// that takes away, 24 along its longest side. Parts of which none adds are numbersOf()'s to
/// refuse.
void requireMatter(const std::vector<BodyPart>& parts);

}  // namespace rotatebook::scene
