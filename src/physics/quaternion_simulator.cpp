#include "physics/quaternion_simulator.h"

namespace rotatebook::physics {

QuaternionSimulator::QuaternionSimulator(const MotionSettings& settings)
    : body_(settings), normalize_(settings.simulation.normalize) {}

void QuaternionSimulator::advance(double h) {
  const Eigen::Vector3d w = body_.angularVelocity(textbookMatrix(attitude_));
  const Eigen::Quaterniond spin(0, w.x(), w.y(), w.z());
  attitude_.coeffs() += h / 2 * (spin * attitude_).coeffs();
  if (normalize_) attitude_.coeffs() /= attitude_.norm();
}

}  // namespace rotatebook::physics
