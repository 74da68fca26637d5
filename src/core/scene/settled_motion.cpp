#include "scene/settled_motion.h"

#include <optional>

#include "base/document/value_reader.h"
#include "scene/part_densities.h"
#include "scene/placed_particles.h"
#include "scene/sections.h"
#include "scene/solid_numbers.h"
#include "scene/spin_axis.h"

namespace rotatebook::scene {
namespace {

/// Gives a motion the numbers of its solid.
void settleBody(const ValueReader& file, Motion& motion) {
  if (motion.solid.isBook()) return;
  std::optional<ValueReader> place;
  for (const char* key : {"dimensions", "shape", "mesh", "part"}) {
    if (!place) place = file.find("body", key);
  }
  failAtValue(place.value_or(file), [&] {
    requireMatter(motion.solid.parts);
    const SolidNumbers numbers = numbersOf(motion.solid);
    motion.body.size = numbers.size;
    motion.body.mass = numbers.properties.mass;
    motion.inertia = numbers.properties.inertia;
  });
}

}  // namespace

Shared sharedOf(const Spec& spec, const MeshFiles& meshes) {
  Shared shared{spec.motion.simulation, meshes};
  if (spec.clip.speed) {
    shared.clock.timePerFrame = spec.clip.frameRate.period() * spec.clip.speed->constant;
    shared.clock.substepped = kSubstepped;
  }
  return shared;
}

void settle(const ValueReader& file, const Shared& shared, Motion& motion) {
  if (!file.find("simulation", "time_per_frame")) {
    motion.simulation.timePerFrame = shared.clock.timePerFrame;
    motion.simulation.substepped = shared.clock.substepped;
  }
  takeContent(shared.meshes, motion.solid.mesh);
  settleBody(file, motion);
  placeParticles(file, motion);
  settleSpin(file, motion);
}

}  // namespace rotatebook::scene
