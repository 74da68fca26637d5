#include "physics/matrix_simulator.h"

#include "physics/rotation.h"

namespace rotatebook::physics {

MatrixSimulator::MatrixSimulator(const MotionSettings& settings)
    : body_(settings), normalize_(settings.simulation.normalize) {}

void MatrixSimulator::advance(double h) {
  const Eigen::Matrix3d spin = crossMatrix(body_.angularVelocity(worldFromBody_));
  worldFromBody_ += h * (spin * worldFromBody_);
  if (normalize_) worldFromBody_ = polarFactor(worldFromBody_);
}

}  // namespace rotatebook::physics
