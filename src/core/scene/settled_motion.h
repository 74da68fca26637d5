// Motions with all that follows from what a scene states of them. Inside the room only.
#pragma once

#include "base/document/value_reader.h"
#include "scene/body_section.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// The common part of all motions of a scene.
struct Shared {
  /// Their timePerFrame and substepped.
  physics::SimulationSettings clock;
  const MeshFiles& meshes;  ///< As far as they were read.
};

/// Returns what the motions of a scene have in common.
Shared sharedOf(const Spec& spec, const MeshFiles& meshes);

/// Gives a motion the clock, unless it states its own, the numbers of its solid, its particles, and
/// a spin that names its axis that axis; `file` has the motion's sections. Throws InputError.
void settle(const document::ValueReader& file, const Shared& shared, Motion& motion);

}  // namespace rotatebook::scene
