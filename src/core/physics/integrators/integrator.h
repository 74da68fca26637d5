// The names of the integrators, from their list.
#pragma once

#include <array>
#include <string_view>

namespace rotatebook::physics {

/// How a model steps through time. integrator_list.inc has a row for each, the header that it names
/// the formulas.
enum class Integrator {
#define ROTATEBOOK_INTEGRATOR(enumerator, ...) enumerator,
#include "physics/integrators/integrator_list.inc"
#undef ROTATEBOOK_INTEGRATOR
};

/// What scene files call them, in the enumeration's order.
inline constexpr std::array kIntegratorWords{
#define ROTATEBOOK_INTEGRATOR(enumerator, word, ...) std::string_view(word),
#include "physics/integrators/integrator_list.inc"
#undef ROTATEBOOK_INTEGRATOR
};

}  // namespace rotatebook::physics
