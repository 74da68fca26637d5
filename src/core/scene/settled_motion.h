// Motions with all that follows from what a scene states of them. Inside the room only.
#pragma once

#include <vector>

#include "rigid/inertia.h"
#include "scene/body_section.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// A body that isn't the book, with what follows from its statement.
struct SettledBody {
  Solid solid;
  body::Cuboid box;  ///< Around it, and its mass.
  rigid::Inertia inertia;
};

/// The motions of a scene have these in common.
struct Shared {
  const MeshFiles& meshes;            ///< As far as they were read.
  std::vector<SettledBody> bodies{};  ///< Each once.
  Motion placed{};                    ///< The last one whose particles were placed.
};

/// Gives a motion the numbers of its solid, its particles, and a spin that names its axis that
/// axis. Throws InputError.
void settle(Shared& shared, Motion& motion);

}  // namespace rotatebook::scene
