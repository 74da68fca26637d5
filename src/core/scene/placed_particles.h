// The particles of a motion, placed in its body. Inside the room only.
#pragma once

#include "base/document/value_reader.h"
#include "scene/read_named_file.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Throws InputError if `section`, [body], states what particles in this arrangement can't have: an
/// inertia of its own, or a body that isn't a box with particles at its corners.
void checkParticlesBody(const document::ValueReader& section,
                        const physics::SimulationSettings& settings);

/// Places the particles of a motion, unless they are the corners of a box, or lack their surface.
/// Throws InputError if they are too many, if their springs don't
/// hold the body's shape, or if its steps are longer than the longest stable one.
void placeParticles(Motion& motion);

/// Places the particles of a motion that lacks a surface. Throws InputError if `readNamedFile` or
/// takeMeshFile() refuses its file.
void placeInMesh(Motion& motion, const ReadNamedFile& readNamedFile);

}  // namespace rotatebook::scene
