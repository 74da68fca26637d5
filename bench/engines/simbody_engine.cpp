// Simbody, as an engine of the table.
#include "engines/engine.h"
#include "engines/simbody_body.h"

namespace rotatebook::bench {
namespace {

std::array<double, 3> numbersOf(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

class SimbodyEngine final : public Engine {
 public:
  SimbodyEngine(const Motion& motion, double step)
      : step_(step),
        body_(motion.book.mass, numbersOf(motion.book.solidInertia()),
              numbersOf(motion.angularVelocity)) {}

  void advance(int steps) override {
    done_ += steps;
    body_.advanceTo(done_ * step_);
  }

  EngineState state() const override {
    const std::array<double, 9> rows = body_.attitude();
    const std::array<double, 3> spin = body_.angularVelocity();
    EngineState state;
    state.worldFromBody = Eigen::Matrix3d::Map(rows.data()).transpose();
    state.angularVelocity = Eigen::Vector3d::Map(spin.data());
    return state;
  }

  std::optional<int> chosenSteps() const override { return body_.stepsTaken(); }

 private:
  double step_;  // [s]
  int done_ = 0;
  SimbodyBody body_;
};

}  // namespace

Family simbodyFamily() {
  const auto [major, minor] = simbodyVersion();
  Family family;
  family.name = "Simbody " + std::to_string(major) + "." + std::to_string(minor);
  family.package = "libsimbody-dev";
  family.note = "double precision; chooses its steps for an accuracy of 1e-9";
  const auto make = [](const Motion& motion, double step) {
    return std::make_unique<SimbodyEngine>(motion, step);
  };
  family.modes = {{"Runge-Kutta-Merson", make, false}};
  return family;
}

}  // namespace rotatebook::bench
