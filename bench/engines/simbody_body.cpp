#include "engines/simbody_body.h"

#include <Simbody.h>

namespace rotatebook::bench {

static_assert(sizeof(SimTK::Real) == sizeof(double));

struct SimbodyBody::Parts {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::MobilizedBody::Free body;
  SimTK::RungeKuttaMersonIntegrator integrator{system};

  const SimTK::State& now() const {
    const SimTK::State& state = integrator.getState();
    system.realize(state, SimTK::Stage::Velocity);
    return state;
  }
};

SimbodyBody::SimbodyBody(double mass, const std::array<double, 3>& moments,
                         const std::array<double, 3>& spin)
    : parts_(std::make_unique<Parts>()) {
  constexpr double kAccuracy = 1e-9;
  const SimTK::Body::Rigid info(SimTK::MassProperties(
      mass, SimTK::Vec3(0), SimTK::Inertia(moments[0], moments[1], moments[2])));
  parts_->body = SimTK::MobilizedBody::Free(parts_->matter.Ground(), info);
  SimTK::State start = parts_->system.realizeTopology();
  parts_->body.setUToFitAngularVelocity(start, SimTK::Vec3(spin[0], spin[1], spin[2]));
  parts_->integrator.setAccuracy(kAccuracy);
  parts_->integrator.initialize(start);
}

SimbodyBody::~SimbodyBody() = default;

void SimbodyBody::advanceTo(double time) {
  while (parts_->integrator.getTime() < time) parts_->integrator.stepTo(time);
}

std::array<double, 9> SimbodyBody::attitude() const {
  const SimTK::Rotation& rotation = parts_->body.getBodyRotation(parts_->now());
  std::array<double, 9> entries{};
  for (int i = 0; i < 9; ++i) entries[static_cast<std::size_t>(i)] = rotation[i / 3][i % 3];
  return entries;
}

std::array<double, 3> SimbodyBody::angularVelocity() const {
  const SimTK::Vec3& spin = parts_->body.getBodyAngularVelocity(parts_->now());
  return {spin[0], spin[1], spin[2]};
}

int SimbodyBody::stepsTaken() const {
  return parts_->integrator.getNumStepsTaken();
}

std::array<int, 2> simbodyVersion() {
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return {major, minor};
}

}  // namespace rotatebook::bench
