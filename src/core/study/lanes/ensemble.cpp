#include "study/lanes/ensemble.h"

#include <algorithm>
#include <functional>
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
  using Make = std::function<void(Waiting&)>;  // Makes the motions of a block.

  explicit Blocks(Make make) : make_(std::move(make)) {}

  // Adds the motion with an index.
  void add(std::size_t index, const Member& member, const Course& course) {
    Waiting& waiting = waiting_[keyOf(member, course)];
    waiting.course = course;
    waiting.indices.push_back(index);
    waiting.members.push_back(member);
    if (waiting.members.size() == kBlockSize) make(waiting);
  }

  // Makes the motions of blocks that aren't full.
  void finish() {
    for (auto& [key, waiting] : waiting_) {
      if (!waiting.members.empty()) make(waiting);
    }
  }

 private:
  void make(Waiting& waiting) {
    make_(waiting);
    waiting.indices.clear();
    waiting.members.clear();
  }

  Make make_;
  std::map<Key, Waiting> waiting_;
};

// Makes members of motions. Of those that come one after another, many differ in their steps alone.
class Members {
 public:
  explicit Members(InstructionSet set) : isInLanes_(set != InstructionSet::None) {}

  // Returns nullopt for motions that lanes don't make. What is wrong with others is reported where
  // they are made by themselves.
  std::optional<Member> of(const MotionSettings& settings) {
    if (!isInLanes_) return std::nullopt;
    try {
      if (last_ && isLikeLast(settings)) return last_->withStepsOf(settings);
      last_ = Member::of(settings);
      if (last_) settings_ = settings;
      return last_;
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

 private:
  bool isLikeLast(const MotionSettings& settings) const {
    return settings.simulation.model == settings_.simulation.model &&
           settings.initial == settings_.initial && settings.body == settings_.body &&
           settings.inertia == settings_.inertia;
  }

  bool isInLanes_;
  std::optional<Member> last_{};
  MotionSettings settings_{};  // of the last
};

// A block with its motions, the rest of its lanes at rest.
std::unique_ptr<Block> blockOf(const std::vector<Member>& members) {
  auto block = std::make_unique<Block>();
  for (int lane = 0; lane < kBlockSize; ++lane) {
    const auto i = static_cast<std::size_t>(lane);
    i < members.size() ? members[i].fill(*block, lane) : members.front().fillAtRest(*block, lane);
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

struct Ensemble::Parts {
  Parts(InstructionSet lanes, const std::atomic<bool>* stopping)
      : set(lanes),
        stop(stopping),
        members(lanes),
        blocks([this](Blocks::Waiting& block) { make(block); }) {}

  bool isStopped() const { return stop != nullptr && *stop; }
  void make(Blocks::Waiting& of);

  InstructionSet set;
  const std::atomic<bool>* stop;
  Members members;
  Blocks blocks;
  std::vector<Outcome> outcomes{};
};

void Ensemble::Parts::make(Blocks::Waiting& of) {
  if (isStopped()) return;
  const auto block = blockOf(of.members);
  for (std::size_t i = 0; i < of.members.size(); ++i) {
    of.members[i].start(*block, static_cast<int>(i));
  }
  run(*block, of.members, runOf(set, of.members), of.course);
  for (std::size_t i = 0; i < of.members.size(); ++i) {
    outcomes[of.indices[i]] = of.members[i].outcome(*block, static_cast<int>(i));
  }
}

Ensemble::Ensemble(InstructionSet set, const std::atomic<bool>* stop)
    : parts_(std::make_unique<Parts>(set, stop)) {}

Ensemble::~Ensemble() = default;

void Ensemble::add(const WatchedMotion& watched) {
  std::vector<Outcome>& outcomes = parts_->outcomes;
  outcomes.emplace_back();
  if (parts_->isStopped()) return;
  if (const auto member = parts_->members.of(watched.motion)) {
    Course course = courseOf(watched.motion, watched.frames, watched.framesPerLook);
    course.isWatched = true;
    parts_->blocks.add(outcomes.size() - 1, *member, course);
  } else {
    outcomes.back() = outcomeOf(watched, parts_->stop);
  }
}

std::vector<Outcome> Ensemble::finish() {
  parts_->blocks.finish();
  return std::exchange(parts_->outcomes, {});
}

std::vector<BodyState> statesAfter(std::span<const MotionSettings> motions, std::int64_t frames,
                                   InstructionSet set) {
  std::vector<BodyState> states(motions.size());
  Blocks blocks([&](Blocks::Waiting& of) {
    const auto block = blockOf(of.members);
    run(*block, of.members, runOf(set, of.members), of.course);
    for (std::size_t i = 0; i < of.members.size(); ++i) {
      states[of.indices[i]] = of.members[i].state(*block, static_cast<int>(i));
    }
  });
  Members members(set);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (const auto member = members.of(motions[i])) {
      blocks.add(i, *member, courseOf(motions[i], frames, 1));
    } else {
      states[i] = stateAfter(motions[i], frames);
    }
  }
  blocks.finish();
  return states;
}

}  // namespace rotatebook::study::lanes
