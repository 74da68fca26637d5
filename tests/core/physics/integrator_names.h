// Names for the cases of parameterised tests.
#pragma once

#include <string>

#include "physics/motion_settings.h"

namespace rotatebook::physics {

inline std::string nameOf(Model model) {
  switch (model) {
    case Model::Particles:
      return "Particles";
    case Model::Matrix:
      return "Matrix";
    case Model::Quaternion:
      return "Quaternion";
    case Model::Exact:
      break;
  }
  return "Exact";
}

inline std::string nameOf(Integrator integrator) {
  static const char* const kNames[]{"Euler",     "Rk4",     "LieEuler",        "Cf4",
                                    "Splitting", "Suzuki4", "Midpoint",        "Dmv2",
                                    "Dmv4",      "Dmv6",    "SymplecticEuler", "Verlet"};
  return kNames[static_cast<int>(integrator)];
}

inline std::string nameOf(Model model, Integrator integrator) {
  return nameOf(model) + (model == Model::Exact ? "" : nameOf(integrator));
}

}  // namespace rotatebook::physics
