// The names that scene files use for values of the program: the one source for reading, printing
// and suggestions.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "physics/motion_settings.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// A value and its name in a scene file.
template <typename T>
struct Named {
  std::string_view name;
  T value;
};

inline constexpr std::array<Named<physics::Model>, 5> kModels{{
    {"particles", physics::Model::Particles},
    {"matrix", physics::Model::Matrix},
    {"quaternion", physics::Model::Quaternion},
    {"exact", physics::Model::Exact},
    {"recorded", physics::Model::Recorded},
}};

/// The integrators, in the order of physics::kIntegratorNames.
inline constexpr auto kIntegrators = [] {
  std::array<Named<physics::Integrator>, physics::kIntegratorNames.size()> named{};
  for (std::size_t i = 0; i < named.size(); ++i) {
    named[i] = {physics::kIntegratorNames[i], static_cast<physics::Integrator>(i)};
  }
  return named;
}();

/// Arrangements of particles by their whole name; a grid's has its number of cells, too.
inline constexpr std::array<Named<physics::Arrangement>, 3> kArrangements{{
    {"corners", physics::Arrangement::Corners},
    {"equimomental", physics::Arrangement::Equimomental},
    {"vertices", physics::Arrangement::Vertices},
}};

/// The keys of [initial] and [[nudge]] that state a spin; each has exactly one of them.
inline constexpr std::array<Named<physics::SpinKind>, 2> kSpinKinds{{
    {"angular_velocity", physics::SpinKind::AngularVelocity},
    {"angular_momentum", physics::SpinKind::AngularMomentum},
}};

inline constexpr std::array<Named<physics::Nudge::Axes>, 2> kNudgeAxes{{
    {"body", physics::Nudge::Axes::Body},
    {"world", physics::Nudge::Axes::World},
}};

inline constexpr std::array<Named<int>, 3> kAxes{{{"x", 0}, {"y", 1}, {"z", 2}}};

inline constexpr std::array<Named<ReferenceFrame>, 4> kFrames{{
    {"world", ReferenceFrame::World},
    {"body", ReferenceFrame::Body},
    {"momentum", ReferenceFrame::Momentum},
    {"turning", ReferenceFrame::Turning},
}};

inline constexpr std::array<Named<Fit>, 2> kFits{{
    {"all", Fit::All},
    {"each", Fit::Each},
}};

inline constexpr std::array<Named<Follow>, 2> kFollows{{
    {"none", Follow::None},
    {"size", Follow::Size},
}};

inline constexpr std::array<Named<Background>, 3> kBackgrounds{{
    {"studio", Background::Studio},
    {"stars", Background::Stars},
    {"transparent", Background::Transparent},
}};

inline constexpr auto kOverlays = [] {
  std::array<Named<Overlay>, kOverlayRows.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = {kOverlayRows[i].name, kOverlayRows[i].overlay};
  }
  return names;
}();

inline constexpr std::array<Named<Scale>, 2> kScales{{
    {"linear", Scale::Linear},
    {"log", Scale::Logarithmic},
}};

inline constexpr std::array<Named<MapMoment>, 2> kMapMoments{{
    {"end", MapMoment::End},
    {"largest", MapMoment::Largest},
}};

inline constexpr std::array<Named<Outcome>, 4> kOutcomes{{
    {"value", Outcome::Value},
    {"never", Outcome::Never},
    {"diverged", Outcome::Diverged},
    {"refused", Outcome::Refused},
}};

/// Returns the names alone.
template <typename T, std::size_t N>
constexpr std::array<std::string_view, N> namesOf(const std::array<Named<T>, N>& choices) {
  std::array<std::string_view, N> names;
  for (std::size_t i = 0; i < N; ++i) names[i] = choices[i].name;
  return names;
}

/// The names of kSpinKinds.
inline constexpr auto kSpinKeys = namesOf(kSpinKinds);
/// The keys of [simulation] that state a step; it has at most one of them.
inline constexpr std::array<std::string_view, 2> kStepKeys{"substeps", "step"};

/// Returns the name of `value`, which is one of `choices`.
template <typename T, std::size_t N>
constexpr std::string_view nameOf(const std::array<Named<T>, N>& choices, const T& value) {
  for (const Named<T>& choice : choices) {
    if (choice.value == value) return choice.name;
  }
  return {};
}

/// Returns the names of the integrators that `model` has.
inline std::vector<std::string_view> integratorNames(physics::Model model) {
  std::vector<std::string_view> names;
  for (const auto& [name, integrator] : kIntegrators) {
    if (physics::isFor(model, integrator)) names.push_back(name);
  }
  return names;
}

}  // namespace rotatebook::scene
