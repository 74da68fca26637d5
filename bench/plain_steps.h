// The paper's three steps in the plainest words, for the benchmarks to compare with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "physics/motion_start.h"

namespace rotatebook::bench {

using physics::MotionSettings;

/// A quaternion, through the matrix of its rotation.
class PlainQuaternion {
 public:
  explicit PlainQuaternion(const MotionSettings& settings)
      : inertia_(settings.body.solidInertia()),
        momentum_(inertia_.cwiseProduct(initialAngularVelocity(settings))) {}

  void advance(double h) {
    const Eigen::Matrix3d map = attitude_.toRotationMatrix();
    const Eigen::Vector3d w = map * (map.transpose() * momentum_).cwiseQuotient(inertia_);
    attitude_.coeffs() += h / 2 * (Eigen::Quaterniond(0, w.x(), w.y(), w.z()) * attitude_).coeffs();
    attitude_.normalize();
  }

 private:
  Eigen::Vector3d inertia_, momentum_;
  Eigen::Quaterniond attitude_ = Eigen::Quaterniond::Identity();
};

/// A matrix, made orthogonal by a singular value decomposition.
class PlainMatrix {
 public:
  explicit PlainMatrix(const MotionSettings& settings)
      : inertia_(settings.body.solidInertia()),
        momentum_(inertia_.cwiseProduct(initialAngularVelocity(settings))) {}

  void advance(double h) {
    const Eigen::Vector3d w =
        attitude_ * (attitude_.transpose() * momentum_).cwiseQuotient(inertia_);
    Eigen::Matrix3d cross;
    cross << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    attitude_ += h * cross * attitude_;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(attitude_,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    attitude_ = svd.matrixU() * svd.matrixV().transpose();
  }

 private:
  Eigen::Vector3d inertia_, momentum_;
  Eigen::Matrix3d attitude_ = Eigen::Matrix3d::Identity();
};

/// Particles, pair by pair, with all lengths found once for the forces and once for the energy.
class PlainParticles {
 public:
  explicit PlainParticles(const MotionSettings& settings)
      : mass_(settings.body.mass / 8),
        stiffness_(settings.simulation.stiffness),
        damping_(settings.simulation.damping * 2 * std::sqrt(stiffness_ * mass_)) {
    const Eigen::Vector3d w = initialAngularVelocity(settings);
    for (std::size_t i = 0; i < 8; ++i) {
      positions_[i] = settings.body.corners().col(static_cast<Eigen::Index>(i));
      velocities_[i] = w.cross(positions_[i]);
    }
    forEachPair([this](std::size_t i, std::size_t j, std::size_t n) {
      restLengths_[n] = (positions_[i] - positions_[j]).norm();
    });
    energy_ = kineticEnergy();
  }

  void advance(double h) {
    std::array<Eigen::Vector3d, 8> forces;
    forces.fill(Eigen::Vector3d::Zero());
    forEachPair([&](std::size_t i, std::size_t j, std::size_t n) {
      const Eigen::Vector3d d = positions_[i] - positions_[j];
      const double length = d.norm();
      const Eigen::Vector3d direction = d / length;
      const double rate = direction.dot(velocities_[i] - velocities_[j]);
      const double pull = -stiffness_ * (length - restLengths_[n]) - damping_ * rate;
      forces[i] += pull * direction;
      forces[j] -= pull * direction;
    });
    for (std::size_t i = 0; i < 8; ++i) {
      positions_[i] += h * velocities_[i];
      velocities_[i] += h / mass_ * forces[i];
    }
    normalize();
  }

 private:
  template <typename Visit>
  static void forEachPair(const Visit& visit) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = i + 1; j < 8; ++j) visit(i, j, n++);
    }
  }

  double kineticEnergy() const {
    double sum = 0;
    for (const auto& velocity : velocities_) sum += velocity.squaredNorm();
    return mass_ / 2 * sum;
  }

  void normalize() {
    double potential = 0;
    forEachPair([&](std::size_t i, std::size_t j, std::size_t n) {
      const double stretch = (positions_[i] - positions_[j]).norm() - restLengths_[n];
      potential += stiffness_ / 2 * stretch * stretch;
    });
    const double factor = std::sqrt(std::max(energy_ - potential, energy_ / 10) / kineticEnergy());
    Eigen::Vector3d place = Eigen::Vector3d::Zero(), velocity = place;
    for (std::size_t i = 0; i < 8; ++i) {
      velocities_[i] *= factor;
      place += positions_[i] / 8;
      velocity += velocities_[i] / 8;
    }
    for (std::size_t i = 0; i < 8; ++i) {
      positions_[i] -= place;
      velocities_[i] -= velocity;
    }
  }

  double mass_, stiffness_, damping_, energy_;
  std::array<double, 28> restLengths_{};
  std::array<Eigen::Vector3d, 8> positions_, velocities_;
};

}  // namespace rotatebook::bench
