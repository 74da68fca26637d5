// The words that a scene file has for values of the program: read, printed and suggested from here.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "physics/motion_settings.h"

namespace rotatebook::scene {

/// A value and the word that stands for it in a scene file.
template <typename T>
struct Named {
  std::string_view name;
  T value;
};

inline constexpr std::array<Named<physics::Model>, 3> kModels{{
    {"particles", physics::Model::Particles},
    {"matrix", physics::Model::Matrix},
    {"quaternion", physics::Model::Quaternion},
}};

inline constexpr std::array<Named<physics::Integrator>, 1> kIntegrators{{
    {"euler", physics::Integrator::Euler},
}};

/// The keys of [initial] of which a scene has exactly one.
inline constexpr std::array<Named<physics::InitialSpin::Kind>, 2> kSpinKinds{{
    {"angular_velocity", physics::InitialSpin::Kind::AngularVelocity},
    {"angular_momentum", physics::InitialSpin::Kind::AngularMomentum},
}};

inline constexpr std::array<Named<int>, 3> kAxes{{{"x", 0}, {"y", 1}, {"z", 2}}};

/// x264's presets, fastest first.
inline constexpr std::array<std::string_view, 10> kPresets{
    "ultrafast", "superfast", "veryfast", "faster",   "fast",
    "medium",    "slow",      "slower",   "veryslow", "placebo"};

/// The words alone.
template <typename T, std::size_t N>
constexpr std::array<std::string_view, N> namesOf(const std::array<Named<T>, N>& choices) {
  std::array<std::string_view, N> names;
  for (std::size_t i = 0; i < N; ++i) names[i] = choices[i].name;
  return names;
}

/// The word for `value`, which is one of `choices`.
template <typename T, std::size_t N>
constexpr std::string_view nameOf(const std::array<Named<T>, N>& choices, const T& value) {
  for (const Named<T>& choice : choices) {
    if (choice.value == value) return choice.name;
  }
  return {};
}

}  // namespace rotatebook::scene
