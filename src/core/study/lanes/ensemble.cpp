#include "study/lanes/ensemble.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "base/error.h"
#include "physics/integrators/step_error.h"
#include "physics/make_simulator.h"
#include "physics/turn_watch.h"
#include "study/lanes/kernels.h"
#include "study/lanes/member.h"

namespace rotatebook::study::lanes {
namespace {

using physics::BodyState;
using physics::MotionSettings;

// The kind of step and the course, which all motions of a block have in common.
using Key = std::tuple<std::size_t, std::int64_t, std::int64_t, std::int64_t, std::int64_t>;

Key keyOf(const Member& member, const Course& course) {
  return {member.stepKind(), course.frames, course.framesPerLook, course.stepsPerFrame,
          course.normalizeEvery};
}

Course courseOf(const MotionSettings& motion, std::int64_t frames, std::int64_t framesPerLook) {
  return {frames, framesPerLook, motion.simulation.steps().count, motion.simulation.normalizeEvery};
}

BodyState failedState() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BodyState state;
  state.worldFromBody.setConstant(nan);
  state.angularVelocity.setConstant(nan);
  state.angularMomentum.setConstant(nan);
  state.kinetic = state.rotational = nan;
  return state;
}

// The scalar ways.
Outcome outcomeOf(const WatchedMotion& watched, const std::atomic<bool>* stop) {
  Outcome result;
  try {
    physics::TurnWatch watch(watched.motion);
    for (std::int64_t frame = 0; frame < watched.frames && (stop == nullptr || !*stop);) {
      frame = std::min(frame + watched.framesPerLook, watched.frames);
      const double time = static_cast<double>(frame) * watched.motion.simulation.steps().time;
      const bool goesOn = watch.look(time);
      result.halfTurns = watch.halfTurns();
      if (result.halfTurns > 0 && !result.firstTurn) result.firstTurn = time;
      if (!goesOn) break;
    }
    result.divergedAt = watch.divergedAt();
  } catch (const InputError&) {
    result.isRefused = true;
  }
  return result;
}

BodyState stateAfter(const MotionSettings& settings, std::int64_t frames) {
  const auto simulator = physics::makeSimulator(settings);
  const physics::EqualSteps steps = settings.simulation.steps();
  try {
    for (std::int64_t n = 0; n < frames; ++n) {
      simulator->advance(steps.time, steps.count);
    }
  } catch (const physics::StepError&) {
    return failedState();
  }
  return simulator->state();
}

// Gathers motions for blocks of equal courses.
class Blocks {
 public:
  // A block in the making.
  struct Waiting {
    Course course;
    std::vector<std::size_t> indices;
    std::vector<Member> members;
  };

  // Adds the motion with an index. Returns a block that is full with it.
  std::optional<Waiting> add(std::size_t index, const Member& member, const Course& course) {
    Waiting& waiting = waiting_[keyOf(member, course)];
    waiting.course = course;
    waiting.indices.push_back(index);
    waiting.members.push_back(member);
    if (waiting.members.size() < kBlockSize) return std::nullopt;
    return std::exchange(waiting, {});
  }

  // Returns the blocks that aren't full.
  std::vector<Waiting> rest() {
    std::vector<Waiting> rest;
    for (auto& [key, waiting] : waiting_) {
      if (!waiting.members.empty()) rest.push_back(std::move(waiting));
    }
    return rest;
  }

 private:
  std::map<Key, Waiting> waiting_;
};

// Returns nullopt for motions that lanes don't make. What is wrong with others is reported where
// they are made by themselves.
std::optional<Member> memberOf(const MotionSettings& settings, InstructionSet set) {
  if (set == InstructionSet::None) return std::nullopt;
  try {
    return Member::of(settings);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// Makes all motions: `alone` makes one that lanes don't make, `together` a block. `motionOf` and
// `courseOf` return those of an index.
template <typename MotionOf, typename CourseOf, typename Alone, typename Together>
void makeAll(std::size_t count, InstructionSet set, const MotionOf& motionOf,
             const CourseOf& courseOf, const Alone& alone, const Together& together) {
  Blocks blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Member> member = memberOf(motionOf(i), set);
    if (!member) {
      alone(i);
    } else if (auto full = blocks.add(i, *member, courseOf(i))) {
      together(*full);
    }
  }
  for (Blocks::Waiting& block : blocks.rest()) together(block);
}

// A block with its motions, the rest of its lanes at rest.
std::unique_ptr<Block> blockOf(const std::vector<Member>& members) {
  auto block = std::make_unique<Block>();
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const auto i = static_cast<std::size_t>(lane);
    i < members.size() ? members[i].fill(*block, lane) : fillAtRest(*block, lane);
  }
  return block;
}

bool haveAllEnded(const Block& block) {
  return std::ranges::all_of(block.hasEnded, [](bool ended) { return ended; });
}

// Runs a block until all its motions have ended, and lets members attend to what lanes leave to
// them.
void run(Block& block, std::vector<Member>& members, Run lanes, const Course& course) {
  while (!haveAllEnded(block) && lanes(block, course)) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      const int lane = static_cast<int>(i);
      if (!block.needsCare[lane]) continue;
      block.needsCare[lane] = false;
      members[i].attend(block, lane);
    }
  }
}

Run runOf(InstructionSet set, const std::vector<Member>& members) {
  return kernelsFor(set).runs[members.front().stepKind()];
}

}  // namespace

std::vector<Outcome> outcomesOf(std::span<const WatchedMotion> motions, InstructionSet set,
                                const std::atomic<bool>* stop) {
  std::vector<Outcome> outcomes(motions.size());
  const auto isStopped = [&] { return stop != nullptr && *stop; };
  const auto motionOf = [&](std::size_t i) -> const MotionSettings& { return motions[i].motion; };
  const auto watchedCourse = [&](std::size_t i) {
    Course course = courseOf(motionOf(i), motions[i].frames, motions[i].framesPerLook);
    course.isWatched = true;
    return course;
  };
  const auto alone = [&](std::size_t i) {
    if (!isStopped()) outcomes[i] = outcomeOf(motions[i], stop);
  };
  const auto together = [&](Blocks::Waiting& of) {
    if (isStopped()) return;
    const auto block = blockOf(of.members);
    for (std::size_t i = 0; i < of.members.size(); ++i) {
      of.members[i].start(*block, static_cast<int>(i));
    }
    run(*block, of.members, runOf(set, of.members), of.course);
    for (std::size_t i = 0; i < of.members.size(); ++i) {
      outcomes[of.indices[i]] = of.members[i].outcome(*block, static_cast<int>(i));
    }
  };
  makeAll(motions.size(), set, motionOf, watchedCourse, alone, together);
  return outcomes;
}

std::vector<BodyState> statesAfter(std::span<const MotionSettings> motions, std::int64_t frames,
                                   InstructionSet set) {
  std::vector<BodyState> states(motions.size());
  const auto motionOf = [&](std::size_t i) -> const MotionSettings& { return motions[i]; };
  const auto course = [&](std::size_t i) { return courseOf(motions[i], frames, 1); };
  const auto alone = [&](std::size_t i) { states[i] = stateAfter(motions[i], frames); };
  const auto together = [&](Blocks::Waiting& of) {
    const auto block = blockOf(of.members);
    run(*block, of.members, runOf(set, of.members), of.course);
    for (std::size_t i = 0; i < of.members.size(); ++i) {
      states[of.indices[i]] = of.members[i].state(*block, static_cast<int>(i));
    }
  };
  makeAll(motions.size(), set, motionOf, course, alone, together);
  return states;
}

}  // namespace rotatebook::study::lanes
