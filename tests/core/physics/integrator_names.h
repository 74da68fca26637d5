// Names for the cases of parameterised tests.
#pragma once

#include <cctype>
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
    case Model::Recorded:
      return "Recorded";
    case Model::Exact:
      break;
  }
  return "Exact";
}

/// "LieEuler" for "lie-euler".
inline std::string nameOf(Integrator integrator) {
  std::string name;
  bool capital = true;
  for (const char letter : kIntegratorNames.at(static_cast<std::size_t>(integrator))) {
    if (letter != '-') name += static_cast<char>(capital ? std::toupper(letter) : letter);
    capital = letter == '-';
  }
  return name;
}

inline std::string nameOf(Model model, Integrator integrator) {
  return nameOf(model) + (model == Model::Exact ? "" : nameOf(integrator));
}

}  // namespace rotatebook::physics
