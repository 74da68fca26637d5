// Motions are the same, bit by bit, from every build: debug, optimised, with sanitizers.
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "physics/integrator_names.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

// Fowler, Noll and Vo's hash 1a of 64 bits.
std::uint64_t fnv1a(const std::vector<double>& numbers) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  for (std::size_t i = 0; i < numbers.size() * sizeof(double); ++i) {
    hash = (hash ^ bytes[i]) * 0x100000001b3U;
  }
  return hash;
}

std::vector<double> numbersOf(const BodyState& state, const body::Cuboid& body) {
  const body::Cage corners = drawnCage(state, body);
  std::vector<double> numbers(corners.data(), corners.data() + corners.size());
  numbers.insert(numbers.end(), state.angularVelocity.begin(), state.angularVelocity.end());
  numbers.insert(numbers.end(), state.angularMomentum.begin(), state.angularMomentum.end());
  numbers.insert(numbers.end(), {state.kinetic, state.potential, state.rotational});
  return numbers;
}

struct Golden {
  Model model;
  Integrator integrator;
  bool normalize;
  std::uint64_t hash;
  double dissipation = 0;  // [kg m^2 s]
};

std::string nameOf(const Golden& golden) {
  return nameOf(golden.model, golden.integrator) + (golden.normalize ? "" : "Unnormalised") +
         (golden.dissipation > 0 ? "Dissipating" : "");
}

void PrintTo(const Golden& golden, std::ostream* stream) {
  *stream << nameOf(golden);
}

class Determinism : public testing::TestWithParam<Golden> {};

// Steps and exact solution use the four operations and the square root alone, which every machine
// rounds alike.
TEST_P(Determinism, GivesTheSameBitsInEveryBuild) {
  const Golden& golden = GetParam();
  MotionSettings settings =
      settingsOf({.model = golden.model, .slant = 0.1, .normalize = golden.normalize});
  settings.simulation.integrator = golden.integrator;
  settings.simulation.dissipation = golden.dissipation;
  const auto simulator = makeSimulator(settings);
  simulator->advance(10000 * settings.simulation.timePerFrame / settings.simulation.substeps,
                     10000);
  const std::uint64_t hash = fnv1a(numbersOf(simulator->state(), settings.body));
  std::cout << nameOf(golden) << " 0x" << std::hex << hash << std::dec << '\n';
  EXPECT_EQ(hash, golden.hash);
}

INSTANTIATE_TEST_SUITE_P(
    OfModel, Determinism,
    testing::Values(
        Golden{Model::Matrix, Integrator::Euler, true, 0xed9a53d281d00647},
        Golden{Model::Matrix, Integrator::Euler, false, 0xad1fc6f2d31315d7},
        Golden{Model::Matrix, Integrator::Rk4, true, 0x60f434cbaaaa96e2},
        Golden{Model::Matrix, Integrator::Rk4, false, 0xea1814c19191229},
        Golden{Model::Matrix, Integrator::LieEuler, true, 0x796dc7d1c1bac2e2},
        Golden{Model::Matrix, Integrator::Cf4, true, 0x8f1901ace59cb0db},
        Golden{Model::Matrix, Integrator::Splitting, true, 0x6ca248562323408f},
        Golden{Model::Matrix, Integrator::Suzuki4, true, 0xf36f647ca6008f48},
        Golden{Model::Matrix, Integrator::Midpoint, true, 0x1fbe97e454464d3f},
        Golden{Model::Matrix, Integrator::Dmv2, true, 0xe394c264fb5d40a1},
        Golden{Model::Matrix, Integrator::Dmv4, true, 0xcfca10e878d6b9e6},
        Golden{Model::Matrix, Integrator::Dmv6, true, 0xb3b9922eef7f1c66},
        Golden{Model::Matrix, Integrator::NoGyroscopic, true, 0x16cff60ff46c149f},
        Golden{Model::Matrix, Integrator::ExplicitGyroscopic, true, 0xd22e440578ea529f},
        Golden{Model::Matrix, Integrator::ImplicitGyroscopic, true, 0x14228cf947d5d361},
        Golden{Model::Matrix, Integrator::Renormalised, true, 0x8e825a1d9bcd8559},
        Golden{Model::Quaternion, Integrator::Euler, true, 0x6f901a6c8b29e257},
        Golden{Model::Quaternion, Integrator::Euler, false, 0xdea5ba2d14eec87b},
        Golden{Model::Quaternion, Integrator::Rk4, true, 0xf38d290319d6163},
        Golden{Model::Quaternion, Integrator::Rk4, false, 0x2c0eff4669f22095},
        Golden{Model::Quaternion, Integrator::LieEuler, true, 0x557ca56d3d87ba7},
        Golden{Model::Quaternion, Integrator::Cf4, true, 0x534eb85301625c58},
        Golden{Model::Quaternion, Integrator::Splitting, true, 0x27d198f054663c7a},
        Golden{Model::Quaternion, Integrator::Suzuki4, true, 0x6d823dd105c136ef},
        Golden{Model::Quaternion, Integrator::Midpoint, true, 0x3b73eb013aad6457},
        Golden{Model::Quaternion, Integrator::Dmv2, true, 0xdb73622773ea75fe},
        Golden{Model::Quaternion, Integrator::Dmv4, true, 0x62c5d1526a8ea028},
        Golden{Model::Quaternion, Integrator::Dmv6, true, 0x43bf2a941c359d5a},
        Golden{Model::Quaternion, Integrator::NoGyroscopic, true, 0xfbbba0d300b9abab},
        Golden{Model::Quaternion, Integrator::ExplicitGyroscopic, true, 0xfc16370f7e37c8e2},
        Golden{Model::Quaternion, Integrator::ImplicitGyroscopic, true, 0x9f173437436c301a},
        Golden{Model::Quaternion, Integrator::Renormalised, true, 0x2459850e16e33473},
        Golden{Model::Particles, Integrator::Euler, true, 0x7517978c6ec62b39},
        Golden{Model::Particles, Integrator::Euler, false, 0xa3bd9be2e028dbce},
        Golden{Model::Particles, Integrator::SymplecticEuler, true, 0x8e92b6de9b6b6a9c},
        Golden{Model::Particles, Integrator::SymplecticEuler, false, 0x595389d85cb8dbd4},
        Golden{Model::Particles, Integrator::Verlet, true, 0xf25b6c0fb13ed1eb},
        Golden{Model::Particles, Integrator::Verlet, false, 0x5ac85e33081da559},
        Golden{Model::Particles, Integrator::Rk4, true, 0x4a7b6db64861c436},
        Golden{Model::Particles, Integrator::Rk4, false, 0xd375067f2b236224},
        Golden{Model::Matrix, Integrator::Rk4, true, 0x9336f1ced4b10375, 2e-6},
        Golden{Model::Matrix, Integrator::Cf4, true, 0x4a943650af79158d, 2e-6},
        Golden{Model::Quaternion, Integrator::Euler, true, 0x2f071505230f50ea, 2e-6},
        Golden{Model::Quaternion, Integrator::Rk4, true, 0xfd6e16fd4217f8c, 2e-6},
        Golden{Model::Quaternion, Integrator::LieEuler, true, 0xad411eb92d226aa, 2e-6},
        Golden{Model::Quaternion, Integrator::Cf4, true, 0xf25e4701c9b08cc1, 2e-6},
        Golden{Model::Exact, Integrator::Euler, true, 0x20b78d8b1c056907}),
    [](const auto& instance) { return nameOf(instance.param); });

TEST(Fnv1a, HashesTheBytesOfNumbers) {
  EXPECT_EQ(fnv1a({}), 0xcbf29ce484222325U);
  EXPECT_NE(fnv1a({0.0}), fnv1a({-0.0}));
}

}  // namespace
}  // namespace rotatebook::physics
