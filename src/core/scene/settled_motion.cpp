#include "scene/settled_motion.h"

#include <algorithm>
#include <tuple>

#include "scene/part_densities.h"
#include "scene/placed_particles.h"
#include "scene/solid_numbers.h"
#include "scene/spin_axis.h"
#include "scene/step_limit.h"

namespace rotatebook::scene {
namespace {

SettledBody settledBody(const Motion& motion) {
  const Solid& solid = motion.solid;
  const auto settled = [&]() -> SettledBody {
    requireMatter(solid.parts);
    const SolidNumbers numbers = numbersOf(solid);
    return {solid, {numbers.size, numbers.properties.mass}, numbers.inertia};
  };
  return motion.locations.failAt({"body.dimensions", "body.shape", "body.mesh", "body.part"},
                                 settled);
}

/// Gives a motion the numbers of its solid.
void settleBody(Shared& shared, Motion& motion) {
  if (motion.solid.isBook()) return;
  auto body = std::ranges::find(shared.bodies, motion.solid, &SettledBody::solid);
  if (body == shared.bodies.end()) body = shared.bodies.insert(body, settledBody(motion));
  motion.body = body->box;
  motion.inertia = body->inertia;
}

/// Places the particles of a motion, unless they are those of the last one.
void settleParticles(Shared& shared, Motion& motion) {
  const auto source = [](const Motion& one) {
    return std::tie(one.simulation, one.solid, one.body, one.inertia);
  };
  motion.particles = shared.placed.particles;
  if (source(motion) == source(shared.placed)) return;
  placeParticles(motion);
  if (motion.particles.system) shared.placed = motion;
}

}  // namespace

void settle(Shared& shared, Motion& motion) {
  takeContent(shared.meshes, motion.solid.mesh);
  settleBody(shared, motion);
  settleParticles(shared, motion);
  settleSpin(motion);
  requireSlowSink(motion);
}

}  // namespace rotatebook::scene
