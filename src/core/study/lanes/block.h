// Motions that are made side by side, as plain arrays: code for any instruction set reads them. No
// functions, which the linker would take from any of them. Inside the room only.
#pragma once

#include <cstdint>

namespace rotatebook::study::lanes {

/// Motions of a block.
inline constexpr int kBlockSize = 32;

using Row = double[kBlockSize];  ///< A number of each motion.

/// The steps that there are for several bodies at once: those of physics::AnyStep, and Euler's of a
/// momentum in the plane of x and z.
enum class StepKind { Euler, RungeKutta4, Midpoint, MoserVeselov, EulerMatrix, FlatEuler };
inline constexpr int kStepKinds = 6;

inline constexpr int kStepNumbers = 10;   ///< At most, in a step's type.
inline constexpr int kStateNumbers = 12;  ///< At most, in a step's state.

/// Settings that a block's motions have in common.
struct Course {
  std::int64_t frames = 0;         ///< To be made.
  std::int64_t framesPerLook = 1;  ///< From one look to the next; the last is after all frames.
  std::int64_t stepsPerFrame = 1;
  std::int64_t normalizeEvery = 1;  ///< As SimulationSettings::normalizeEvery.
  bool isWatched = false;           ///< True if half-turns are counted at the looks.
};

/// Numbers that are watched of each motion, row by row as Watch has it.
struct WatchRows {
  Row spunAxis[3];  ///< Along the principal axes, a unit vector.
  Row side;         ///< Of the tilt: 1 near, -1 far, 0 neither yet.
  Row halfTurns;    ///< A whole number.
  Row isCounted;    ///< 1 if half-turns are counted, else 0.
  Row firstTurn;    ///< Frame of the look that found the first half-turn; 0 so far if none has.
  Row lastEnergy;   ///< h/2 L.I^-1 L above which Euler's steps, normalised, turn over no more.
};

/// A block on its way. A motion needs care after a look at which its numbers alone don't decide
/// what is to be counted; the others of its group wait for it.
struct Block {
  alignas(64) Row step[kStepNumbers];    ///< The numbers of each motion's step type.
  alignas(64) Row state[kStateNumbers];  ///< Of each step's State.
  alignas(64) WatchRows watch;
  double leastStretch[kBlockSize];  ///< A step adds at least this to an attitude's norm, squared.
  double mostStretch[kBlockSize];   ///< At most this; 0 and infinity where neither is known.
  std::int64_t frames[kBlockSize];  ///< Made so far: up to a look, or all.
  bool needsCare[kBlockSize];
  bool hasEnded[kBlockSize];
};

/// Makes steps of a block up to the end of its course, or until motions need care. Returns whether
/// one does.
using Run = bool (*)(Block& block, const Course& course);

/// Functions that are compiled for an instruction set.
struct Kernels {
  Run runs[kStepKinds];  ///< In the order of StepKind.
};

/// Equations that iteration hasn't solved, as the numbers of their types. Solved by Newton's method
/// in code for any processor. Returns whether there is a solution.
bool solveMidpoint(const double* equation, double* solution);
bool solveMoserVeselov(const double* equation, double* solution);

/// Takes the orthogonal matrix closest to a matrix, column by column, as rigid::polarFactor() does.
void takePolarFactor(double* matrix);

}  // namespace rotatebook::study::lanes
