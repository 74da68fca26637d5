// The run of a block in lanes, for any number type and step. Included by the source of each
// instruction set, and by nothing else. Inside the room only.
#pragma once

#include "physics/steps/euler_step.h"
#include "physics/steps/midpoint_step.h"
#include "physics/steps/moser_veselov_step.h"
#include "physics/steps/polar_factor.h"
#include "physics/steps/runge_kutta_step.h"
#include "study/lanes/block.h"
#include "study/lanes/flat_euler_step.h"
#include "study/lanes/lanes.h"
#include "study/lanes/pair.h"

namespace rotatebook::study::lanes {

using physics::Matrix3;
using physics::MatrixState;
using physics::Quaternion;
using physics::StepState;
using physics::Vector3;

/// Motions that a number holds.
template <typename Number>
inline constexpr int kLanesOf = sizeof(Number) / sizeof(double);

/// Copies a value of several numbers from as many rows, or to them.
template <typename Number, typename Value>
void load(const Row* rows, int first, Value& value) {
  constexpr int kCount = sizeof(Value) / sizeof(Number);
  double numbers[kCount][kLanesOf<Number>];
  for (int i = 0; i < kCount; ++i) __builtin_memcpy(numbers[i], rows[i] + first, sizeof(Number));
  __builtin_memcpy(&value, numbers, sizeof(Value));
}
template <typename Number, typename Value>
void store(const Value& value, Row* rows, int first) {
  constexpr int kCount = sizeof(Value) / sizeof(Number);
  double numbers[kCount][kLanesOf<Number>];
  __builtin_memcpy(numbers, &value, sizeof(Value));
  for (int i = 0; i < kCount; ++i) __builtin_memcpy(rows[i] + first, numbers[i], sizeof(Number));
}

template <typename Number>
bool solve(const physics::MidpointEquation<Number>& /*type*/, const double* equation,
           double* solution) {
  return solveMidpoint(equation, solution);
}
template <typename Number>
bool solve(const physics::MoserVeselovEquation<Number>& /*type*/, const double* equation,
           double* solution) {
  return solveMoserVeselov(equation, solution);
}

/// Solves steps one by one by Newton's method; a body without a solution gets NaN.
template <typename Number>
struct SolvedOrNan {
  template <typename Equation, typename Iterated>
  [[gnu::noinline]] Vector3<Number> operator()(const Equation& equation,
                                               const Iterated& iterated) const {
    constexpr int kLanes = kLanesOf<Number>, kCount = sizeof(Equation) / sizeof(Number);
    double numbers[kCount][kLanes], solutions[3][kLanes];
    bool isSolved[kLanes];
    __builtin_memcpy(numbers, &equation, sizeof(Equation));
    __builtin_memcpy(solutions, &iterated.x, sizeof(solutions));
    storeMask(iterated.isSolved, isSolved);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (isSolved[lane]) continue;
      double one[kCount], solution[3];
      for (int i = 0; i < kCount; ++i) one[i] = numbers[i][lane];
      const bool exists = solve(equation, one, solution);
      for (int i = 0; i < 3; ++i) solutions[i][lane] = exists ? solution[i] : __builtin_nan("");
    }
    Vector3<Number> result;
    __builtin_memcpy(&result, solutions, sizeof(solutions));
    return result;
  }

  template <typename Condition>
  Vector3<Number> unsolved(const Vector3<Number>& x, const Condition& condition) const {
    const Number nan(__builtin_nan(""));
    return chosen(condition, x, Vector3<Number>{nan, nan, nan});
  }
};

/// Takes those polar factors one by one that haven't been found.
template <typename Number>
struct FactoredOneByOne {
  template <typename Condition>
  [[gnu::noinline]] Matrix3<Number> operator()(const Matrix3<Number>& map,
                                               const Matrix3<Number>& found,
                                               const Condition& isLeft) const {
    constexpr int kLanes = kLanesOf<Number>;
    double maps[9][kLanes], factors[9][kLanes];
    bool isMissing[kLanes];
    __builtin_memcpy(maps, &map, sizeof(maps));
    __builtin_memcpy(factors, &found, sizeof(factors));
    storeMask(isLeft, isMissing);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (!isMissing[lane]) continue;
      double one[9];
      for (int i = 0; i < 9; ++i) one[i] = maps[i][lane];
      takePolarFactor(one);
      for (int i = 0; i < 9; ++i) factors[i][lane] = one[i];
    }
    Matrix3<Number> result;
    __builtin_memcpy(&result, factors, sizeof(factors));
    return result;
  }
};

/// When steps end with a normalisation, and how far each of them is known to go.
enum class Drift { Sometimes, Each, EachNear, EachFar };

template <Drift kDrift, typename Number>
[[gnu::always_inline]] inline void undoDrift(Quaternion<Number>& attitude) {
  if constexpr (kDrift == Drift::EachNear) {
    attitude = scaled(attitude, physics::inverseRootNearOne(squaredNorm(attitude)));
  } else if constexpr (kDrift == Drift::EachFar) {
    attitude = scaled(attitude, physics::inverseRootFarFromOne(squaredNorm(attitude)));
  } else {
    normalize(attitude);
  }
}
template <Drift kDrift, typename Number>
[[gnu::always_inline]] inline void undoDrift(Matrix3<Number>& attitude) {
  physics::takePolarFactor(attitude, FactoredOneByOne<Number>{});
}

/// The bounds of a look: a momentum's square along the spun axis where the tilt is 60 or 120
/// degrees, and how far from it the square has to be if its side is to be certain.
template <typename Number>
struct Bounds {
  Number quarter, doubt;

  Bounds() = default;
  explicit Bounds(const Vector3<Number>& momentum) {
    const Number square = squaredNorm(momentum);
    const auto isInRange = both(Number(1e-280) < square, square < Number(1e250));
    quarter = Number(0.25) * square;
    doubt = chosen(isInRange, Number(1e-6) * square, Number(__builtin_inf()));
  }
};

/// Numbers that are watched at each look: WatchRows.
template <typename Number>
struct Watch {
  Vector3<Number> spunAxis;
  Number side, halfTurns, isCounted, firstTurn, lastEnergy;

  /// Returns the side of the tilt at a look. Takes the square of the momentum's part along the spun
  /// axis, with the part's sign.
  Number nextSide(Number signedSquare, const Bounds<Number>& bounds) const {
    return chosen(bounds.quarter < signedSquare, Number(1),
                  chosen(signedSquare < Number(0) - bounds.quarter, Number(-1), side));
  }
  void countTo(Number next, Number frame) {
    const Number turns = halfTurns + chosen(side * next < Number(0), isCounted, Number(0));
    firstTurn = chosen(halfTurns + turns == Number(1), frame, firstTurn);
    halfTurns = turns;
    side = next;
  }
};

template <typename Number, typename Step>
[[gnu::always_inline]] inline void take(const Step& step, typename Step::State& state) {
  if constexpr (requires { step(state); }) {
    step(state);
  } else {
    state.attitude = state.attitude * step.stepMomentum(state, SolvedOrNan<Number>{});
  }
}

/// Returns how far the attitude is from a rotation.
template <typename Number>
Number strainOf(const Quaternion<Number>& attitude) {
  return magnitude(squaredNorm(attitude) - Number(1));
}
template <typename Number>
Number strainOf(const Matrix3<Number>& a) {
  const Number one(1);
  const Vector3<Number> lengths{squaredNorm(a.x) - one, squaredNorm(a.y) - one,
                                squaredNorm(a.z) - one};
  const Vector3<Number> skews{dot(a.x, a.y), dot(a.y, a.z), dot(a.z, a.x)};
  const Number growth = dot(cross(a.x, a.y), a.z) - one;  // -2 if it mirrors the body.
  return largestSize(lengths) + largestSize(skews) + magnitude(growth);
}

/// Returns the momentum in body axes.
template <typename Step>
[[gnu::always_inline]] inline auto momentumInBody(const typename Step::State& state) {
  if constexpr (Step::kMomentumInBody) {
    return state.momentum;
  } else if constexpr (requires { Step::inBody(state); }) {
    return Step::inBody(state);
  } else {
    return turnedToBody(state);
  }
}

template <typename Step>
inline constexpr bool kIsEuler = requires(Step step) {
  step.halfTurn;
};

/// As many motions as a number holds.
template <typename OfStep, typename OfNumber>
struct Group {
  using Step = OfStep;
  using Number = OfNumber;

  Step step;
  typename Step::State state;
  Watch<Number> watch;
  Bounds<Number> bounds;  ///< Of the momentum, which stays unless it is the body's.
};

template <typename Group>
void load(const Block& block, int first, Group& group) {
  using Number = typename Group::Number;
  load<Number>(block.step, first, group.step);
  load<Number>(block.state, first, group.state);
  load<Number>(reinterpret_cast<const Row*>(&block.watch), first, group.watch);
  group.bounds = Bounds<Number>(group.state.momentum);
}
template <typename Group>
void store(const Group& group, Block& block, int first) {
  using Number = typename Group::Number;
  store<Number>(group.state, block.state, first);
  store<Number>(group.watch, reinterpret_cast<Row*>(&block.watch), first);
}

template <Drift kDrift, int kGroups, typename Group>
[[gnu::always_inline]] inline void makeStep(Group (&groups)[kGroups], bool isDue) {
#pragma GCC unroll 4
  for (Group& group : groups) {
    take<typename Group::Number>(group.step, group.state);
    if (isDue) undoDrift<kDrift>(group.state.attitude);
  }
}

/// Makes steps, of which `left` are left to the next normalisation.
template <int kGroups, typename Group>
[[gnu::always_inline]] inline void makeSteps(Group (&groups)[kGroups], std::int64_t count,
                                             const Course& course, std::int64_t& left) {
  for (std::int64_t made = 0; made < count; ++made) {
    const bool isDue = course.normalizeEvery != 0 && --left <= 0;
    if (isDue) left = course.normalizeEvery;
    makeStep<Drift::Sometimes>(groups, isDue);
  }
}

/// Makes steps, each of which ends with a normalisation; the first by itself, as it has much in
/// common with a look before it.
template <Drift kDrift, int kGroups, typename Group>
[[gnu::always_inline]] inline void makeNormalizedSteps(Group (&groups)[kGroups],
                                                       std::int64_t count) {
  if (count > 0) makeStep<kDrift>(groups, true);
  for (std::int64_t made = 1; made < count; ++made) makeStep<kDrift>(groups, true);
}

/// Looks at the motions after so many frames. Returns for which bodies nothing needs care.
template <typename Group>
[[gnu::always_inline]] inline auto watched(Group& group, std::int64_t frames) {
  using Number = typename Group::Number;
  using Step = typename Group::Step;
  if constexpr (Step::kMomentumInBody) group.bounds = Bounds<Number>(group.state.momentum);
  const Number along = dot(group.watch.spunAxis, momentumInBody<Step>(group.state));
  const Number signedSquare = along * magnitude(along);
  const Number distance = magnitude(magnitude(signedSquare) - group.bounds.quarter);
  const auto isUnit = strainOf(group.state.attitude) < Number(1e-8);
  const auto isQuiet = both(isUnit, group.bounds.doubt < distance);
  const Number next = group.watch.nextSide(signedSquare, group.bounds);
  group.watch.countTo(isAll(isQuiet) ? next : chosen(isQuiet, next, group.watch.side),
                      Number(static_cast<double>(frames)));
  return isQuiet;
}

/// Looks at the motions of groups of a block. Returns whether one needs care.
template <int kGroups, typename Group>
[[gnu::always_inline]] inline bool needsCare(Group (&groups)[kGroups], std::int64_t frames,
                                             bool* needing) {
  bool care = false;
#pragma GCC unroll 4
  for (int i = 0; i < kGroups; ++i) {
    const auto isQuiet = watched(groups[i], frames);
    if (isAll(isQuiet)) [[likely]]
      continue;
    care = true;
    storeMask(isNot(isQuiet), needing + i * kLanesOf<typename Group::Number>);
  }
  return care;
}

/// Returns whether no body will turn over any more. Euler's steps, normalised, turn the momentum in
/// the body about the angular velocity, which adds d.I^-1 d >= 0 to the energy, d being its change.
template <int kGroups, typename Group>
[[gnu::always_inline]] inline bool areSettled(const Group (&groups)[kGroups]) {
  bool all = true;
  for (const Group& group : groups) {
    const auto inBody = momentumInBody<typename Group::Step>(group.state);
    const auto energy = dot(componentProduct(group.step.halfTurn, inBody), inBody);
    all = all && isAll(group.watch.lastEnergy < energy);
  }
  return all;
}

/// Runs the motions of some groups of a block, step by step in turns: one group's step gives the
/// processor something to do while it waits for the results of another's.
template <template <typename> typename Step, typename Number, int kGroups, Drift kDrift>
bool runGroups(Block& block, int first, const Course& course) {
  constexpr int kLanes = kLanesOf<Number>;
  Group<Step<Number>, Number> groups[kGroups];
  for (int i = 0; i < kGroups; ++i) load(block, first + i * kLanes, groups[i]);

  std::int64_t frames = block.frames[first];
  std::int64_t left = course.normalizeEvery;
  if (left > 1) left -= frames * course.stepsPerFrame % left;
  const auto framesToLook = [&] {
    const std::int64_t rest = course.frames - frames;
    return rest < course.framesPerLook ? rest : course.framesPerLook;
  };
  const auto make = [&](std::int64_t made) __attribute__((always_inline)) {
    if constexpr (kDrift == Drift::Sometimes) {
      makeSteps(groups, made * course.stepsPerFrame, course, left);
    } else {
      makeNormalizedSteps<kDrift>(groups, made * course.stepsPerFrame);
    }
    frames += made;
  };
  constexpr bool kSettles = kDrift != Drift::Sometimes && kIsEuler<Step<Number>>;
  constexpr int kLooks = 8;  // from one question whether all are settled to the next
  bool care = false, goesOn = frames < course.frames;
  if (goesOn) make(framesToLook());
  for (int looks = 1; goesOn; ++looks) {
    if (course.isWatched) care = needsCare(groups, frames, block.needsCare + first);
    if constexpr (kSettles) {
      if (course.isWatched && !care && looks % kLooks == 0 && areSettled(groups))
        frames = course.frames;
    }
    goesOn = !care && frames < course.frames;
    if (goesOn) make(framesToLook());
  }

  for (int i = 0; i < kGroups; ++i) store(groups[i], block, first + i * kLanes);
  for (int i = 0; i < kLanes * kGroups; ++i) block.frames[first + i] = frames;
  return care;
}

/// Returns how far each normalisation of some motions goes.
inline Drift driftOf(const Block& block, int first, int count) {
  constexpr double kRounding = 0.999;
  bool isNear = true, isFar = true;
  for (int lane = first; lane < first + count; ++lane) {
    isNear = isNear && block.mostStretch[lane] < kRounding * physics::kNearOne;
    isFar = isFar && physics::kNearOne < kRounding * block.leastStretch[lane] &&
            block.mostStretch[lane] < kRounding * physics::kRootReach;
  }
  return isNear ? Drift::EachNear : isFar ? Drift::EachFar : Drift::Each;
}

template <template <typename> typename Step, typename Number, int kGroups>
bool run(Block& block, const Course& course) {
  constexpr int kLanes = kLanesOf<Number> * kGroups;
  static_assert(kBlockSize % kLanes == 0);
  const auto runFrom = [&](int first) {
    if (course.normalizeEvery != 1)
      return runGroups<Step, Number, kGroups, Drift::Sometimes>(block, first, course);
    if constexpr (kIsEuler<Step<Number>>) {
      const Drift drift = driftOf(block, first, kLanes);
      if (drift == Drift::EachNear)
        return runGroups<Step, Number, kGroups, Drift::EachNear>(block, first, course);
      if (drift == Drift::EachFar)
        return runGroups<Step, Number, kGroups, Drift::EachFar>(block, first, course);
    }
    return runGroups<Step, Number, kGroups, Drift::Each>(block, first, course);
  };
  bool care = false;
  for (int first = 0; first < kBlockSize; first += kLanes) {
    if (runFrom(first)) care = true;
  }
  return care;
}

/// Returns the runs in the order of StepKind: Euler's step, the shortest, with its own number, and
/// in groups, as it waits longest for its results unless there are more at once.
template <typename EulerNumber, int kEulerGroups, typename Number>
constexpr Kernels kernels() {
  return {{&run<physics::EulerStep, EulerNumber, kEulerGroups>,
           &run<physics::RungeKutta4Step, Number, 1>, &run<physics::MidpointStep, Number, 1>,
           &run<physics::MoserVeselovStep, Number, 1>, &run<physics::EulerMatrixStep, Number, 1>,
           &run<FlatEulerStep, EulerNumber, kEulerGroups>}};
}

}  // namespace rotatebook::study::lanes
