// The Open Dynamics Engine: one body in a world.
#include <ode/ode.h>
#include <ode/version.h>

#include "engines/engine.h"

namespace rotatebook::bench {
namespace {

/// Allocates the library's own data as long as it lives.
class OdeLibrary {
 public:
  OdeLibrary() { dInitODE2(0); }
  OdeLibrary(const OdeLibrary&) = delete;
  OdeLibrary& operator=(const OdeLibrary&) = delete;
  ~OdeLibrary() { dCloseODE(); }
};

class OdeEngine final : public Engine {
 public:
  OdeEngine(const Motion& motion, double step, bool finiteRotation)
      : step_(step), world_(dWorldCreate()), body_(dBodyCreate(world_)) {
    dWorldSetGravity(world_, 0, 0, 0);
    const Eigen::Vector3d& size = motion.book.size;
    dMass mass;
    dMassSetBoxTotal(&mass, motion.book.mass, size.x(), size.y(), size.z());
    dBodySetMass(body_, &mass);
    dBodySetAutoDisableFlag(body_, 0);
    dBodySetFiniteRotationMode(body_, finiteRotation ? 1 : 0);
    const Eigen::Vector3d& spin = motion.angularVelocity;
    dBodySetAngularVel(body_, spin.x(), spin.y(), spin.z());
  }

  ~OdeEngine() override { dWorldDestroy(world_); }

  void advance(int steps) override {
    for (int i = 0; i < steps; ++i) dWorldStep(world_, step_);
  }

  EngineState state() const override {
    EngineState state;
    // Rows of four numbers, the last of them padding.
    using Rows = Eigen::Matrix<dReal, 3, 4, Eigen::RowMajor>;
    const Eigen::Map<const Rows> rows(dBodyGetRotation(body_));
    state.worldFromBody = rows.leftCols<3>().cast<double>();
    state.angularVelocity =
        Eigen::Map<const Eigen::Matrix<dReal, 3, 1>>(dBodyGetAngularVel(body_)).cast<double>();
    return state;
  }

 private:
  OdeLibrary library_;
  dReal step_;  // [s]
  dWorldID world_;
  dBodyID body_;
};

Mode mode(const char* name, bool finiteRotation) {
  return {name, [finiteRotation](const Motion& motion, double step) {
            return std::make_unique<OdeEngine>(motion, step, finiteRotation);
          }};
}

}  // namespace

Family odeFamily() {
  Family family;
  family.name = "ODE " dODE_VERSION;
  family.package = "libode-dev";
  family.note = sizeof(dReal) == sizeof(float) ? "single precision" : "double precision";
  family.modes = {
      mode("default", false),
      mode("finite rotation", true),
  };
  return family;
}

}  // namespace rotatebook::bench
