// Motions with all that follows from what a scene states of them. Inside the room only.
#pragma once

#include <vector>

#include "base/document/value_reader.h"
#include "rigid/inertia.h"
#include "scene/body_section.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// A body that isn't the book, with what follows from its statement.
struct SettledBody {
  Solid solid;
  physics::Cuboid box;  ///< Around it, and its mass.
  rigid::Inertia inertia;
};

/// The common part of all motions of a scene.
struct Shared {
  /// Their timePerFrame and substepped.
  physics::SimulationSettings clock;
  const MeshFiles& meshes;            ///< As far as they were read.
  std::vector<SettledBody> bodies{};  ///< Each once.
};

/// Returns what the motions of a scene have in common.
Shared sharedOf(const Spec& spec, const MeshFiles& meshes);

/// Gives a motion the clock, unless it states its own, the numbers of its solid, its particles, and
/// a spin that names its axis that axis; `file` has the motion's sections. Throws InputError.
void settle(const document::ValueReader& file, Shared& shared, Motion& motion);

}  // namespace rotatebook::scene
