#include "study/lanes/member.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

#include "physics/simulate.h"
#include "rigid/rotation.h"

namespace rotatebook::study::lanes {
namespace {

using physics::BodyState;
using physics::RigidMotion;

static_assert(std::variant_size_v<physics::AnyStep> ==
              static_cast<std::size_t>(StepKind::FlatEuler));

// Copies a value that is made of doubles into rows.
template <typename Value>
void scatter(const Value& value, Row* rows, int lane) {
  const auto numbers = std::bit_cast<std::array<double, sizeof(Value) / sizeof(double)>>(value);
  for (std::size_t i = 0; i < numbers.size(); ++i) rows[i][lane] = numbers[i];
}

RigidMotion::State stateIn(const Row* rows, int lane) {
  static_assert(physics::kMostStateNumbers == kStateNumbers);
  RigidMotion::State numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = rows[i][lane];
  return numbers;
}

void scatterVector(const Eigen::Vector3d& v, Row* rows, int lane) {
  for (int i = 0; i < 3; ++i) rows[i][lane] = v[i];
}

bool hasSolver(std::size_t kind) {
  return kind == static_cast<std::size_t>(StepKind::Midpoint) ||
         kind == static_cast<std::size_t>(StepKind::MoserVeselov);
}

bool isOrdinary(double number) {
  constexpr double kLarge = 1e60;
  return number > 1 / kLarge && number < kLarge;
}

// Returns whether the momentum in world axes is as FlatEulerStep takes it. Products with it must
// not vanish.
bool isFlat(const RigidMotion& motion) {
  const Eigen::Vector3d momentum = motion.inertia().bodyFromPrincipal * motion.momentum();
  return std::bit_cast<std::uint64_t>(momentum.y()) == 0 && isOrdinary(std::fabs(momentum.x())) &&
         isOrdinary(std::fabs(momentum.z()));
}

}  // namespace

std::optional<Member> Member::of(const physics::MotionSettings& settings) {
  const auto motion = RigidMotion::of(settings);
  if (!motion) return std::nullopt;
  Member member(settings, *motion);
  if (!member.hasOrdinaryNumbers()) return std::nullopt;
  return member;
}

std::optional<Member> Member::withStepsOf(const physics::MotionSettings& settings) const {
  const auto motion = motion_.withStepsOf(settings);
  if (!motion) return std::nullopt;
  Member member = *this;
  member.interval_ = settings.simulation.steps().time;
  member.motion_ = *motion;
  return member;
}

Member::Member(const physics::MotionSettings& settings, const RigidMotion& motion)
    : body_(settings.body),
      interval_(settings.simulation.steps().time),
      motion_(motion),
      spunAxis_(spunAxisOf(settings, motion.inertia())),
      isFlat_(isFlat(motion)) {}

std::size_t Member::stepKind() const {
  const std::size_t kind = motion_.step().index();
  const bool isEuler = kind == static_cast<std::size_t>(StepKind::Euler);
  return isEuler && isFlat_ ? static_cast<std::size_t>(StepKind::FlatEuler) : kind;
}

bool Member::hasOrdinaryNumbers() const {
  const Eigen::Vector3d& moments = motion_.inertia().moments;
  bool isAll = isOrdinary(std::sqrt(motion_.momentum().squaredNorm()));
  for (int i = 0; i < 3; ++i) isAll = isAll && isOrdinary(moments[i]) && isOrdinary(body_.size[i]);
  return isAll;
}

// With halves v = (h/2) B L of the turns in the body, e = v.L never falls, and |L| stays.
// - A step adds v^2 to the attitude's squared norm: from (e / |L|)^2 to its largest value.
// - e is at most b_k l^2 + b_max (L^2 - l^2), with l along the spun axis k: above a bound less than
//   half of the momentum is along it, whatever follows. Rounding takes less than a thousandth.
void Member::fillBounds(Block& block, int lane) const {
  block.leastStretch[lane] = 0;
  block.mostStretch[lane] = block.watch.lastEnergy[lane] = std::numeric_limits<double>::infinity();
  const auto* step = std::get_if<physics::EulerStep<double>>(&motion_.step());
  if (step == nullptr) return;
  const Eigen::Vector3d halfTurn(step->halfTurn.x, step->halfTurn.y, step->halfTurn.z);
  const double square = motion_.momentum().squaredNorm(), most = halfTurn.maxCoeff();
  const double energy = motion_.momentum().cwiseAbs2().dot(halfTurn);
  block.leastStretch[lane] = energy * energy / square;
  block.mostStretch[lane] = most * most * square;
  const Eigen::Vector3d spun = motion_.inertia().bodyFromPrincipal.transpose() * spunAxis_;
  const double bound = spun.cwiseAbs2().dot(halfTurn) / 4 + 0.75 * most;
  block.watch.lastEnergy[lane] = 1.001 * bound * square;
}

void Member::fill(Block& block, int lane) const {
  std::visit([&](const auto& step) { scatter(step, block.step, lane); }, motion_.step());
  scatter(motion_.start(), block.state, lane);
  const Eigen::Matrix3d principalFromBody = motion_.inertia().bodyFromPrincipal.transpose();
  scatterVector(principalFromBody * spunAxis_, block.watch.spunAxis, lane);
  fillBounds(block, lane);
  block.hasEnded[lane] = false;
  block.frames[lane] = 0;
}

void Member::start(Block& block, int lane) const {
  block.watch.side[lane] = 0;
  block.watch.halfTurns[lane] = 0;
  block.watch.isCounted[lane] = 1;
  block.watch.firstTurn[lane] = 0;
  count(block, lane, state(block, lane));
}

void Member::attend(Block& block, int lane) {
  const BodyState state = this->state(block, lane);
  if (!hasBlownUp(state, body_)) {
    count(block, lane, state);
    return;
  }
  // Solvers find finite numbers.
  outcome_.isRefused = hasSolver(stepKind()) && !state.angularMomentum.allFinite();
  if (!outcome_.isRefused) outcome_.divergedAt = timeOf(static_cast<double>(block.frames[lane]));
  // Leave the lane, but for its counts, to a body at rest.
  fillAtRest(block, lane);
}

void Member::count(Block& block, int lane, const BodyState& state) const {
  if (block.watch.isCounted[lane] == 0) return;
  const rigid::Polar polar = rigid::polarDecomposition(state.worldFromBody);
  if (!physics::keepsItsShape(polar.singularValues[2], polar.singularValues[0])) {
    block.watch.isCounted[lane] = 0;
    return;
  }
  const Eigen::Vector3d axis = polar.rotation * spunAxis_;
  const auto side =
      physics::sideOfCosine(axis.dot(state.angularMomentum), state.angularMomentum.norm());
  if (side == physics::TiltSide::None) return;
  const double next = side == physics::TiltSide::Near ? 1 : -1;
  if (block.watch.side[lane] * next < 0) {
    double& turns = block.watch.halfTurns[lane];
    if (turns == 0) block.watch.firstTurn[lane] = static_cast<double>(block.frames[lane]);
    turns += 1;
  }
  block.watch.side[lane] = next;
}

Outcome Member::outcome(const Block& block, int lane) const {
  Outcome result = outcome_;
  result.halfTurns = static_cast<int>(block.watch.halfTurns[lane]);
  const double firstTurn = block.watch.firstTurn[lane];
  if (firstTurn > 0) result.firstTurn = timeOf(firstTurn);
  return result;
}

BodyState Member::state(const Block& block, int lane) const {
  return motion_.stateOf(stateIn(block.state, lane));
}

void Member::fillAtRest(Block& block, int lane) const {
  for (Row& row : block.step) row[lane] = 0;
  block.step[kStepNumbers - 1][lane] = 1;  // A length of a step, by which some divide.
  scatter(motion_.rest(), block.state, lane);
  scatterVector({1, 0, 0}, block.watch.spunAxis, lane);  // The momentum's, which stays.
  block.watch.side[lane] = 1;
  block.watch.lastEnergy[lane] = -1;
  block.leastStretch[lane] = 1;  // Keeps the others from neither way.
  block.mostStretch[lane] = 0;
  block.hasEnded[lane] = true;
}

}  // namespace rotatebook::study::lanes
