#include "engines/table.h"

#include <array>
#include <cstdio>

#include "engines/comparison.h"

namespace rotatebook::bench {
namespace {

constexpr std::array kStepsASecond{60, 240, 1000};
// Looks are all that an engine is asked for where the step doesn't matter.
constexpr int kLooksASecond = 20;

void printHead(const Motion& motion) {
  const Eigen::Vector3d& size = motion.book.size;
  const Eigen::Vector3d& spin = motion.angularVelocity;
  std::printf("Book %g x %g x %g m, %g kg; angular velocity at first (%.4f, %.4f, %.4f) rad/s;\n",
              size.x(), size.y(), size.z(), motion.book.mass, spin.x(), spin.y(), spin.z());
  std::printf("%g s without gravity or damping. The error is the angle of the rotation from the\n",
              kDuration);
  std::printf("exact attitude to the engine's: at the end, and the largest of looks every %g s.\n",
              kInterval);
  std::printf(
      "Drifts are from first to last. A step's processor time is that of the fastest run.\n\n");
  std::printf("%-15s %-24s %-9s %9s %9s %10s %10s %10s %8s\n", "engine", "mode", "step [s]",
              "end [rad]", "max [rad]", "energy [%]", "|L| [%]", "half-turns", "ns/step");
}

std::string stepText(const Mode& mode, const Row& row, int stepsASecond) {
  if (row.chosenSteps) return "chosen: " + std::to_string(*row.chosenSteps);
  if (!mode.stepMatters) return "any";
  return "1/" + std::to_string(stepsASecond);
}

void printRow(const Family& family, const Mode& mode, const Row& row, int stepsASecond,
              int exactHalfTurns) {
  const std::string turns = std::to_string(row.halfTurns) + "/" + std::to_string(exactHalfTurns);
  std::printf("%-15s %-24s %-9s %9.2g %9.2g %+10.2g %+10.2g %10s %8.0f\n", family.name.c_str(),
              mode.name.c_str(), stepText(mode, row, stepsASecond).c_str(), row.lastError,
              row.largestError, 100 * row.energyDrift, 100 * row.momentumDrift, turns.c_str(),
              row.nanoseconds);
  std::fflush(stdout);
}

void printMode(const Comparison& comparison, const Family& family, const Mode& mode) {
  const auto print = [&](int stepsASecond) {
    const Row row = comparison.run(mode, 1.0 / stepsASecond);
    printRow(family, mode, row, stepsASecond, comparison.halfTurns());
  };
  if (!mode.stepMatters) return print(kLooksASecond);
  for (const int stepsASecond : kStepsASecond) print(stepsASecond);
}

void printFamily(const Comparison& comparison, const Family& family) {
  for (const Mode& mode : family.modes) printMode(comparison, family, mode);
  if (family.modes.empty()) {
    std::printf("%-15s not installed: %s\n", family.name.c_str(), family.package.c_str());
  }
}

}  // namespace

void printTable(const Motion& motion, const std::vector<Family>& families) {
  printHead(motion);
  const Comparison comparison(motion);
  for (const Family& family : families) printFamily(comparison, family);
  std::printf("\n");
  for (const Family& family : families) {
    if (!family.note.empty()) std::printf("%s: %s\n", family.name.c_str(), family.note.c_str());
  }
}

}  // namespace rotatebook::bench
