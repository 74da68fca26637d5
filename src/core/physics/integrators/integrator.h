// The names of the integrators, from their list.
#pragma once

#include <array>
#include <string_view>

namespace rotatebook::physics {

/// The rules by which models step through time. Each has a row in integrator_list.inc, and its
/// formulas in the header of the type that the row names.
enum class Integrator {
#define ROTATEBOOK_INTEGRATOR(enumerator, ...) enumerator,
#include "physics/integrators/integrator_list.inc"
#undef ROTATEBOOK_INTEGRATOR
};

/// Names of the integrators in scene files, in the order of the enumeration.
inline constexpr std::array kIntegratorNames{
#define ROTATEBOOK_INTEGRATOR(enumerator, word, ...) std::string_view(word),
#include "physics/integrators/integrator_list.inc"
#undef ROTATEBOOK_INTEGRATOR
};

}  // namespace rotatebook::physics
