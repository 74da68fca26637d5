#include "physics/rigid_simulator.h"

#include "physics/attitude.h"
#include "physics/integrators/explicit_euler.h"
#include "physics/integrators/lie_group.h"
#include "physics/integrators/midpoint.h"
#include "physics/integrators/moser_veselov.h"
#include "physics/integrators/rigid_state.h"
#include "physics/integrators/runge_kutta.h"
#include "physics/integrators/splitting.h"
#include "physics/motion_start.h"

namespace rotatebook::physics {
namespace {

// At t = 0 the body's axes are the world's.
template <typename Attitude, bool kMomentumInBody>
RigidState<Attitude> startOf(const PrincipalAxes& axes, const Eigen::Vector3d& momentum) {
  const Eigen::Matrix3d& map = axes.bodyFromPrincipal;
  return {Attitude(map), kMomentumInBody ? momentum : Eigen::Vector3d(map * momentum)};
}

RigidConstants constantsOf(const PrincipalAxes& axes, const Eigen::Vector3d& angularVelocity) {
  const Eigen::Vector3d along = axes.bodyFromPrincipal.transpose() * angularVelocity;
  return {axes.moments, axes.moments.cwiseInverse(), axes.moments.cwiseProduct(along)};
}

template <typename Attitude, typename Method>
class RigidSimulator final : public Simulator {
 public:
  explicit RigidSimulator(const MotionSettings& settings)
      : RigidSimulator(settings, modelInertia(settings)) {}

  void advance(double h, int steps) override {
    const Method method(body_, h);
    RigidState<Attitude> state = state_;  // in registers
    for (int step = 0; step < steps; ++step) {
      method.step(state);
      if (normalize_) normalize(state.attitude);
    }
    state_ = state;
  }

  BodyState state() const override {
    const Eigen::Matrix3d map = mapOf(state_.attitude);
    const Eigen::Vector3d inBody = Method::kMomentumInBody
                                       ? state_.momentum
                                       : Eigen::Vector3d(map.transpose() * state_.momentum);
    const Eigen::Vector3d velocityInBody = body_.inverseInertia.cwiseProduct(inBody);
    BodyState result;
    result.worldFromBody = map * principalFromBody_;
    result.angularVelocity = map * velocityInBody;
    result.angularMomentum =
        Method::kMomentumInBody ? Eigen::Vector3d(map * inBody) : state_.momentum;
    result.kinetic = velocityInBody.dot(inBody) / 2;
    result.rotational = result.kinetic;
    return result;
  }

 private:
  RigidSimulator(const MotionSettings& settings, const PrincipalAxes& axes)
      : body_(constantsOf(axes, initialAngularVelocity(settings))),
        principalFromBody_(axes.bodyFromPrincipal.transpose()),
        state_(startOf<Attitude, Method::kMomentumInBody>(axes, body_.momentum)),
        normalize_(settings.simulation.normalize) {}

  RigidConstants body_;
  Eigen::Matrix3d principalFromBody_;
  RigidState<Attitude> state_;
  bool normalize_;
};

template <typename Attitude>
std::unique_ptr<Simulator> make(const MotionSettings& settings) {
  switch (settings.simulation.integrator) {
    case Integrator::Rk4:
      return std::make_unique<RigidSimulator<Attitude, RungeKutta4>>(settings);
    case Integrator::LieEuler:
      return std::make_unique<RigidSimulator<Attitude, LieEuler>>(settings);
    case Integrator::Cf4:
      return std::make_unique<RigidSimulator<Attitude, CommutatorFree4>>(settings);
    case Integrator::Splitting:
      return std::make_unique<RigidSimulator<Attitude, Splitting>>(settings);
    case Integrator::Suzuki4:
      return std::make_unique<RigidSimulator<Attitude, Suzuki4>>(settings);
    case Integrator::Midpoint:
      return std::make_unique<RigidSimulator<Attitude, Midpoint>>(settings);
    case Integrator::Dmv2:
      return std::make_unique<RigidSimulator<Attitude, MoserVeselov<2>>>(settings);
    case Integrator::Dmv4:
      return std::make_unique<RigidSimulator<Attitude, MoserVeselov<4>>>(settings);
    case Integrator::Dmv6:
      return std::make_unique<RigidSimulator<Attitude, MoserVeselov<6>>>(settings);
    case Integrator::Euler:
    case Integrator::SymplecticEuler:
    case Integrator::Verlet:
      break;  // The last two are refused before.
  }
  return std::make_unique<RigidSimulator<Attitude, ExplicitEuler>>(settings);
}

}  // namespace

std::unique_ptr<Simulator> makeRigidSimulator(const MotionSettings& settings) {
  const bool matrix = settings.simulation.model == Model::Matrix;
  return matrix ? make<Eigen::Matrix3d>(settings) : make<Eigen::Quaterniond>(settings);
}

}  // namespace rotatebook::physics
