// Simbody: one body on a free mobilizer, integrated with steps that the accuracy chooses.
#include <Simbody.h>

#include "engines/engine.h"

namespace rotatebook::bench {
namespace {

constexpr double kAccuracy = 1e-9;

class SimbodyEngine final : public Engine {
 public:
  SimbodyEngine(const Motion& motion, double step) : step_(step) {
    const Eigen::Vector3d inertia = motion.book.solidInertia();
    const SimTK::Body::Rigid info(SimTK::MassProperties(
        motion.book.mass, SimTK::Vec3(0), SimTK::Inertia(inertia.x(), inertia.y(), inertia.z())));
    body_ = SimTK::MobilizedBody::Free(matter_.Ground(), info);
    SimTK::State start = system_.realizeTopology();
    const Eigen::Vector3d& spin = motion.angularVelocity;
    body_.setUToFitAngularVelocity(start, SimTK::Vec3(spin.x(), spin.y(), spin.z()));
    integrator_.setAccuracy(kAccuracy);
    integrator_.initialize(start);
  }

  void advance(int steps) override {
    done_ += steps;
    while (integrator_.getTime() < done_ * step_) integrator_.stepTo(done_ * step_);
  }

  EngineState state() const override {
    const SimTK::State& now = integrator_.getState();
    system_.realize(now, SimTK::Stage::Velocity);
    const SimTK::Rotation& rotation = body_.getBodyRotation(now);
    const SimTK::Vec3& spin = body_.getBodyAngularVelocity(now);
    EngineState state;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        state.worldFromBody(row, column) = rotation[row][column];
      }
    }
    state.angularVelocity = {spin[0], spin[1], spin[2]};
    return state;
  }

  std::optional<int> chosenSteps() const override { return integrator_.getNumStepsTaken(); }

 private:
  double step_;  // [s]
  int done_ = 0;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::MobilizedBody::Free body_;
  SimTK::RungeKuttaMersonIntegrator integrator_{system_};
};

}  // namespace

Family simbodyFamily() {
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  Family family;
  family.name = "Simbody " + std::to_string(major) + "." + std::to_string(minor);
  family.package = "libsimbody-dev";
  static_assert(sizeof(SimTK::Real) == sizeof(double));
  family.note = "double precision; chooses its steps for an accuracy of 1e-9";
  const auto make = [](const Motion& motion, double step) {
    return std::make_unique<SimbodyEngine>(motion, step);
  };
  family.modes = {{"Runge-Kutta-Merson", make, false}};
  return family;
}

}  // namespace rotatebook::bench
