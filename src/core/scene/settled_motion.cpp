#include "scene/settled_motion.h"

#include <algorithm>
#include <optional>

#include "base/document/value_reader.h"
#include "scene/limits.h"
#include "scene/part_densities.h"
#include "scene/placed_particles.h"
#include "scene/solid_numbers.h"
#include "scene/spin_axis.h"

namespace rotatebook::scene {
namespace {

using document::failAtValue;
using document::ValueReader;

SettledBody settledBody(const ValueReader& file, const Solid& solid) {
  std::optional<ValueReader> place;
  for (const char* key : {"dimensions", "shape", "mesh", "part"}) {
    if (!place) place = file.find("body", key);
  }
  return failAtValue(place.value_or(file), [&]() -> SettledBody {
    requireMatter(solid.parts);
    const SolidNumbers numbers = numbersOf(solid);
    return {solid, {numbers.size, numbers.properties.mass}, numbers.inertia};
  });
}

/// Gives a motion the numbers of its solid.
void settleBody(const ValueReader& file, Shared& shared, Motion& motion) {
  if (motion.solid.isBook()) return;
  auto body = std::ranges::find(shared.bodies, motion.solid, &SettledBody::solid);
  if (body == shared.bodies.end())
    body = shared.bodies.insert(body, settledBody(file, motion.solid));
  motion.body = body->box;
  motion.inertia = body->inertia;
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

void settle(const ValueReader& file, Shared& shared, Motion& motion) {
  if (!file.find("simulation", "time_per_frame")) {
    motion.simulation.timePerFrame = shared.clock.timePerFrame;
    motion.simulation.substepped = shared.clock.substepped;
  }
  takeContent(shared.meshes, motion.solid.mesh);
  settleBody(file, shared, motion);
  placeParticles(file, motion);
  settleSpin(file, motion);
}

}  // namespace rotatebook::scene
