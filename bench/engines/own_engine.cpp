// This program's own rigid body, with some of its integrators and in closed form.
#include "engines/engine.h"
#include "physics/make_simulator.h"
#include "physics/measure/measurement.h"
#include "rigid/exact_motion.h"

namespace rotatebook::bench {
namespace {

using physics::Integrator;

physics::MotionSettings motionSettings(const Motion& motion, Integrator integrator) {
  physics::MotionSettings settings;
  settings.body = motion.book;
  settings.initial.value = motion.angularVelocity;
  settings.simulation.model = physics::Model::Quaternion;
  settings.simulation.integrator = integrator;
  return settings;
}

class OwnEngine final : public Engine {
 public:
  OwnEngine(const Motion& motion, double step, Integrator integrator)
      : settings_(motionSettings(motion, integrator)),
        step_(step),
        simulator_(physics::makeSimulator(settings_)) {}

  void advance(int steps) override { simulator_->advance(step_ * steps, steps); }

  EngineState state() const override {
    physics::Measurement measurement(settings_);
    const physics::Sample sample = measurement.measure(0, simulator_->state());
    return {sample.attitude.toRotationMatrix(), sample.angularVelocity};
  }

 private:
  physics::MotionSettings settings_;
  double step_;  // [s]
  std::unique_ptr<physics::Simulator> simulator_;
};

/// Evaluates the closed form after each step, so that its time can be told beside the others'.
class ExactEngine final : public Engine {
 public:
  ExactEngine(const Motion& motion, double step)
      : step_(step), motion_(motion.book.solidInertia(), motion.angularVelocity) {}

  void advance(int steps) override {
    for (int i = 0; i < steps; ++i) moment_ = motion_.at(++done_ * step_);
  }

  EngineState state() const override {
    return {moment_.worldFromBody, moment_.worldFromBody * moment_.angularVelocityBody};
  }

 private:
  double step_;  // [s]
  rigid::ExactMotion motion_;
  int done_ = 0;
  rigid::ExactMotion::Moment moment_ = motion_.at(0);
};

Mode mode(const char* name, Integrator integrator) {
  return {name, [integrator](const Motion& motion, double step) {
            return std::make_unique<OwnEngine>(motion, step, integrator);
          }};
}

Mode exactMode() {
  const auto make = [](const Motion& motion, double step) {
    return std::make_unique<ExactEngine>(motion, step);
  };
  return {"exact", make, false};
}

}  // namespace

Family ownFamily() {
  Family family;
  family.name = "rotatebook";
  family.note = "double precision; \"exact\" is what the errors are measured from";
  family.modes = {
      mode("quaternion, euler", Integrator::Euler),
      mode("quaternion, rk4", Integrator::Rk4),
      mode("quaternion, splitting", Integrator::Splitting),
      mode("quaternion, midpoint", Integrator::Midpoint),
      mode("quaternion, dmv6", Integrator::Dmv6),
      exactMode(),
  };
  return family;
}

}  // namespace rotatebook::bench
