// The same motion, bit by bit, from every build: debug, optimised, with sanitizers.
#include <array>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

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

std::vector<double> numbersOf(const BodyState& state) {
  std::vector<double> numbers(state.corners.data(), state.corners.data() + state.corners.size());
  numbers.insert(numbers.end(), state.angularVelocity.begin(), state.angularVelocity.end());
  numbers.insert(numbers.end(), state.angularMomentum.begin(), state.angularMomentum.end());
  numbers.insert(numbers.end(), {state.kinetic, state.potential, state.rotational});
  return numbers;
}

struct Golden {
  std::string name;
  Model model;
  bool normalize;
  std::uint64_t hash;
};

void PrintTo(const Golden& golden, std::ostream* stream) {
  *stream << golden.name;
}

class Determinism : public testing::TestWithParam<Golden> {};

TEST_P(Determinism, GivesTheSameBitsInEveryBuild) {
  const MotionSettings settings =
      settingsOf({.model = GetParam().model, .slant = 0.1, .normalize = GetParam().normalize});
  const auto simulator = makeSimulator(settings);
  const double h = settings.simulation.timePerFrame / settings.simulation.substeps;
  for (int step = 0; step < 10000; ++step) simulator->advance(h);
  const std::uint64_t hash = fnv1a(numbersOf(simulator->state()));
  std::cout << GetParam().name << " 0x" << std::hex << hash << std::dec << '\n';
  EXPECT_EQ(hash, GetParam().hash);
}

INSTANTIATE_TEST_SUITE_P(
    OfModel, Determinism,
    testing::Values(Golden{"Particles", Model::Particles, true, 0xc42a81a1e2015588},
                    Golden{"ParticlesUnnormalised", Model::Particles, false, 0xbbda7bdce818b96a},
                    Golden{"Matrix", Model::Matrix, true, 0xed9a53d281d00647},
                    Golden{"MatrixUnnormalised", Model::Matrix, false, 0xac99ceab61d919db},
                    Golden{"Quaternion", Model::Quaternion, true, 0xb7662a327b8adb8f},
                    Golden{"QuaternionUnnormalised", Model::Quaternion, false, 0x68ec76960711d861}),
    [](const auto& instance) { return instance.param.name; });

TEST(Fnv1a, HashesTheBytesOfNumbers) {
  EXPECT_EQ(fnv1a({}), 0xcbf29ce484222325U);
  EXPECT_NE(fnv1a({0.0}), fnv1a({-0.0}));
}

}  // namespace
}  // namespace rotatebook::physics
