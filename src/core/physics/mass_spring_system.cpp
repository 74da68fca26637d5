#include "physics/mass_spring_system.h"

#include <utility>

#include "rigid/inertia.h"

namespace rotatebook::physics {

Eigen::Matrix3d MassSpringSystem::inertia(double mass) const {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& place : places) products += place * place.transpose();
  products *= mass / static_cast<double>(places.size());
  Eigen::Matrix3d tensor = products.trace() * Eigen::Matrix3d::Identity() - products;
  rigid::clearRounding(tensor);
  return tensor;
}

std::vector<Spring> allPairs(std::size_t count) {
  std::vector<Spring> springs;
  const auto end = static_cast<std::uint32_t>(count);
  for (std::uint32_t a = 0; a < end; ++a) {
    for (std::uint32_t b = a + 1; b < end; ++b) springs.push_back({a, b});
  }
  return springs;
}

void centre(std::vector<Eigen::Vector3d>& places) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& place : places) sum += place;
  const Eigen::Vector3d mean = sum / static_cast<double>(places.size());
  for (Eigen::Vector3d& place : places) place -= mean;
}

PlacedParticles placed(MassSpringSystem system, double mass) {
  const rigid::Inertia inertia(system.inertia(mass));
  return {std::make_shared<const MassSpringSystem>(std::move(system)), inertia};
}

}  // namespace rotatebook::physics
