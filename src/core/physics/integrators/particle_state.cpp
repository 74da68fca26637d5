#include "physics/integrators/particle_state.h"

namespace rotatebook::physics {
namespace {

constexpr double kParticleCount = 8;

void subtractMean(Points& points) {
  for (EightDoubles& components : points) {
    const double mean = sumOf(components) / kParticleCount;
    for (DoublePair& lanes : components) lanes -= mean;
  }
}

}  // namespace

Points ParticleState::accelerations(const Points& velocities) const {
  Points result = springs_.forces(velocities);
  const double inverse = 1 / mass_;
  for (EightDoubles& components : result) {
    for (DoublePair& lanes : components) lanes *= inverse;
  }
  return result;
}

void ParticleState::moveTo(const Points& positions) {
  positions_ = positions;
  springs_.moveTo(positions_);
}

// Leaves the springs as they are, because they depend on differences of positions alone.
void ParticleState::restoreCentre() {
  subtractMean(positions_);
  subtractMean(velocities_);
}

}  // namespace rotatebook::physics
