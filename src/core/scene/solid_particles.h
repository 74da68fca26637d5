// The places of particles in a body that a scene states. Inside the room only.
#pragma once

#include "physics/mass_spring_system.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Returns whether particles wait for the surface of a mesh, of which a clip's record has only the
/// numbers.
bool lacksSurface(const Motion& motion);

/// Returns particles at the vertices of the motion's body. Springs are along the edges of its
/// triangles, and from each vertex to three others, some 27, 38 and 41 % of all vertices further in
/// their list: these cross the body, whatever its surface is like. Throws InputError if there are
/// too many, or they can't have equal masses.
physics::MassSpringSystem particlesAtVertices(const Motion& motion);

/// Returns particles at the points of a lattice that are inside the body, with so many cells along
/// its longest side, and springs between those that are two cells or less apart; none if no point
/// is inside. Throws InputError likewise.
physics::MassSpringSystem particlesOnGrid(const Motion& motion, int cells);

}  // namespace rotatebook::scene
