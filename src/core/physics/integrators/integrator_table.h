// The table of integrators: their properties and the factories of their simulators. Inside the room
// only.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "physics/integrators/rigid_state.h"
#include "physics/motion_settings.h"
#include "physics/steps/any_step.h"

namespace rotatebook::physics {

class Simulator;

/// An implementation of an integrator for some models.
struct Stepping {
  std::span<const Model> models;  ///< The models that it serves.
  std::string_view keeps;         ///< Quantities that it keeps to rounding, as text.
  int nanoseconds = 0;            ///< Approximate time of a step. [ns]
  std::string_view source;        ///< Its paper, book or engine.
  /// Creates the simulator, at t = 0. Throws InputError as makeSimulator() does.
  std::unique_ptr<Simulator> (*make)(const MotionSettings& settings) = nullptr;
  /// Returns a quaternion's step of length h [s]; null if it is no template of its number type.
  /// Throws StepTooLong.
  AnyStep (*quaternionStep)(const RigidConstants& body, double h) = nullptr;
  /// Likewise a matrix's.
  AnyStep (*matrixStep)(const RigidConstants& body, double h) = nullptr;
  bool takesDissipation = false;  ///< Of rigid bodies: RigidConstants::dissipation.
  /// Returns the longest stable step [s] for a mode of particles of this stiffness [1/s^2] and
  /// damping [1/s]; 0 if there is none. Null for rigid bodies.
  double (*stableStep)(double stiffness, double damping) = nullptr;
};

/// A row of integrator_list.inc.
struct IntegratorRow {
  Integrator integrator;
  std::string_view word;              ///< Its name in scene files.
  int order;                          ///< Of convergence to the exact motion; 0 if to another.
  std::array<Stepping, 2> steppings;  ///< An unused one has no models.
};

/// Returns all rows, in the order of Integrator.
std::span<const IntegratorRow> integratorTable();

/// Returns the implementation of `integrator` for `model`; null if there is none.
const Stepping* steppingOf(Model model, Integrator integrator);

}  // namespace rotatebook::physics
