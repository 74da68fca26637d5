// What is known of each integrator, and how its simulators are made.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "physics/motion_settings.h"

namespace rotatebook::physics {

class Simulator;

/// An integrator's steps of some models.
struct Stepping {
  std::span<const Model> models;  ///< Those that have it.
  std::string_view keeps;         ///< What stays as it is but for rounding, in words.
  int nanoseconds = 0;            ///< About what a step takes. [ns]
  std::string_view source;        ///< Where it is from.
  /// The simulator, at t = 0. Throws InputError as makeSimulator() does.
  std::unique_ptr<Simulator> (*make)(const MotionSettings& settings) = nullptr;
};

/// A row of integrator_list.inc.
struct IntegratorRow {
  Integrator integrator;
  std::string_view word;              ///< In scene files.
  int order;                          ///< Of convergence to the exact motion; 0 if there is none.
  std::array<Stepping, 2> steppings;  ///< Those that it lacks are of no models.
};

/// All rows, in the order of Integrator.
std::span<const IntegratorRow> integratorTable();

/// How `model` steps by `integrator`; null if it doesn't.
const Stepping* steppingOf(Model model, Integrator integrator);

}  // namespace rotatebook::physics
