#include "cli/spin_report.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/core.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "scene/names.h"

namespace rotatebook::cli {
namespace {

using rigid::Regime;
using std::numbers::pi;
using timeline::EqualMoments;
using timeline::Spin;
using timeline::SpinPeriod;

/// Names of the axes, and of their moments, in the order of Spin::axes.
constexpr std::array<std::string_view, 3> kMoments{"smallest", "middle", "largest"};
constexpr std::array<std::string_view, 3> kAxes{
    "the axis of the smallest moment", "the middle axis", "the axis of the largest moment"};

std::string text(double value) {
  return roundedText(value, 4);
}

std::string degrees(double angle) {
  return text(angle * 180 / pi);
}

/// Returns "x", or "(0.8, 0.6, 0)" for an axis that isn't one of the book's.
std::string axisText(const Spin& spin, std::size_t axis) {
  const Eigen::Vector3d& along = spin.axes[axis];
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(along[i]) == 1) return {"xyz"[i]};
  }
  return "(" + joinedOf(std::array{along.x(), along.y(), along.z()}, text) + ")";
}

std::string spinText(const Spin& spin) {
  const double speed = spin.angularVelocity.norm();
  std::string line =
      fmt::format("{} rad/s ({} turns a second)", text(speed), text(speed / (2 * pi)));
  if (spin.equal == EqualMoments::All) return line;
  line += fmt::format(", {} degrees from {}", degrees(spin.offAxis), axisText(spin, spin.spunAxis));
  return spin.equal == EqualMoments::None ? fmt::format("{}, {}", line, kAxes[spin.spunAxis])
                                          : line;
}

std::string stabilityText(const SpinNumbers& numbers) {
  const Spin& spin = numbers.spin;
  if (spin.growth) {
    return fmt::format("unstable: small deviations grow as e^({} t), tenfold in {} s",
                       text(*spin.growth), text(std::numbers::ln10 / *spin.growth));
  }
  const bool isDrivenOff =
      numbers.motion.simulation.dissipates() && spin.regime == Regime::AboutSmallest;
  return fmt::format("{}: small deviations circle the axis at {} rad/s, once in {} s{}",
                     isDrivenOff ? "unstable by its dissipation" : "stable",
                     text(*spin.oscillation), text(2 * pi / *spin.oscillation),
                     isDrivenOff ? ", and grow" : "");
}

std::string phasesText(const SpinPeriod& period) {
  return fmt::format(
      "{} of these by the energy, 2 E T / |L|, {} {} by geometry, the solid angle that L encloses "
      "in the body",
      degrees(period.dynamicTurn), period.geometricTurn < 0 ? "less" : "and",
      degrees(std::fabs(period.geometricTurn)));
}

/// Says how a body ends that loses energy: it keeps L, with which a spin about the axis of the
/// largest moment has the least energy.
std::string endText(const Spin& spin) {
  const double end = spin.angularMomentum.norm() / spin.moments[2];
  const double energy = spin.moments[2] * end * end / 2;
  return fmt::format(
      "the numbers are those at the start; dissipation ends in a spin about {} at {} rad/s, in "
      "either sense, with {} % of the energy",
      spin.equal == EqualMoments::TwoLargest || spin.equal == EqualMoments::All
          ? "an axis of the largest moment"
          : axisText(spin, 2),
      text(end), text(100 * energy / spin.energy));
}

std::string eulerText(const SpinNumbers& numbers) {
  const timeline::EulerSteps& euler = *numbers.euler;
  const std::string keeps = fmt::format("{} s each, to keep the regime for {} s", text(euler.step),
                                        text(numbers.duration));
  if (!euler.substeps)
    return fmt::format("needs more than {} substeps, shorter than {}", euler.tried, keeps);
  return fmt::format("needs {}, {}", countText(*euler.substeps, "substep"), keeps);
}

/// A line of the report.
struct Line {
  std::string_view label;
  std::string content;
};

std::vector<Line> linesOn(const SpinNumbers& numbers) {
  const Spin& spin = numbers.spin;
  std::vector<Line> lines{{"spin", spinText(spin)}};
  if (spin.growth || spin.oscillation) lines.push_back({"stability", stabilityText(numbers)});
  if (spin.period) {
    const std::string circled = axisText(spin, spin.circledAxis());
    const SpinPeriod& period = *spin.period;
    lines.push_back({"regime", fmt::format("the angular momentum L circles {}, {}", circled,
                                           kAxes[spin.circledAxis()])});
    if (const auto flips = spin.flipInterval()) {
      lines.push_back({"flips", fmt::format("first at {} s, then every {} s", text(*spin.firstFlip),
                                            text(*flips))});
    }
    lines.push_back({"period", text(period.time) + " s, of the angular velocity in the body"});
    lines.push_back({"turn", fmt::format("{} degrees about L in a period, {} rad/s",
                                         degrees(period.turn), text(period.turn / period.time))});
    lines.push_back({"phases", phasesText(period)});
    lines.push_back({"precession", fmt::format("{} goes about L at {} rad/s", circled,
                                               text(period.axisTurn / period.time))});
  }
  if (spin.margin) {
    lines.push_back({"separatrix", fmt::format("{} degrees away; L^2 / (2 E I2) - 1 is {}",
                                               degrees(*spin.toSeparatrix), text(*spin.margin))});
  }
  if (numbers.euler) lines.push_back({"Euler", eulerText(numbers)});
  return lines;
}

std::string equalText(EqualMoments equal) {
  constexpr std::array<const char*, 4> kTexts{"none", "two smallest", "two largest", "all"};
  return kTexts[static_cast<std::size_t>(equal)];
}

Json eulerJson(const timeline::EulerSteps& euler) {
  return {{"substeps", orNull(euler.substeps)}, {"tried", euler.tried}, {"h_s", euler.step}};
}

Json periodJson(const Spin& spin) {
  const auto number = [&](double SpinPeriod::*member) {
    return spin.period ? Json((*spin.period).*member) : Json();
  };
  return {{"period_s", number(&SpinPeriod::time)},
          {"turn_rad", number(&SpinPeriod::turn)},
          {"dynamic_turn_rad", number(&SpinPeriod::dynamicTurn)},
          {"geometric_turn_rad", number(&SpinPeriod::geometricTurn)},
          {"axis_turn_rad", number(&SpinPeriod::axisTurn)}};
}

}  // namespace

std::vector<SpinNumbers> spinNumbersOf(const scene::Scene& scene) {
  const std::int64_t frames = scene.clip.frameCount();
  std::vector<SpinNumbers> all;
  for (const scene::Panel& motion : scene.motions) {
    all.push_back({motion, timeline::spinOf(motion), timeline::eulerStepsFor(motion, frames),
                   timeAt(scene, static_cast<double>(frames - 1))});
  }
  return all;
}

std::vector<std::string> remarksOn(const SpinNumbers& numbers) {
  const Spin& spin = numbers.spin;
  std::vector<std::string> remarks;
  if (spin.equal == EqualMoments::All) {
    remarks.emplace_back("all moments are equal: it turns steadily about any axis");
  } else if (spin.isSteady) {
    const bool couldTumble = spin.growth && numbers.motion.nudges.empty();
    remarks.push_back(fmt::format("the spin is exactly about a principal axis: it turns steadily{}",
                                  couldTumble ? ", as nothing starts the tumbling" : ""));
  } else if (!spin.period) {
    remarks.emplace_back(
        "the spin is exactly on the separatrix: it turns over once at most, and has no period");
  }
  if (spin.equal == EqualMoments::TwoSmallest || spin.equal == EqualMoments::TwoLargest) {
    remarks.push_back(fmt::format(
        "two moments are equal: {}no axis is unstable, nothing flips, and there is no separatrix",
        numbers.motion.simulation.dissipates() ? "without dissipation " : ""));
  }
  if (!numbers.motion.nudges.empty()) {
    remarks.push_back(fmt::format("the numbers are those before the first nudge, at {} s",
                                  text(numbers.motion.nudges.front().at)));
  }
  if (numbers.motion.simulation.dissipates()) remarks.push_back(endText(spin));
  if (numbers.motion.simulation.model == physics::Model::Particles) {
    const bool areCorners =
        numbers.motion.simulation.particles.arrangement == physics::Arrangement::Corners;
    remarks.push_back(fmt::format(
        "the numbers are those of a rigid body with the {}; springs and damping change the motion",
        areCorners ? "eight particles' moments, three times the solid book's"
                   : "particles' moments"));
  }
  return remarks;
}

void reportSpin(const SpinNumbers& numbers, std::ostream& out) {
  for (const auto& [name, content] : linesOn(numbers))
    out << fmt::format("  {:<12}{}\n", name, content);
  for (const std::string& remark : remarksOn(numbers)) out << "  " << remark << '\n';
}

Json spinJson(const SpinNumbers& numbers) {
  const Spin& spin = numbers.spin;
  Json object{{"label", orNull(numbers.motion.label)},
              {"model", nameOf(scene::kModels, numbers.motion.simulation.model)},
              {"moments_kg_m2", spin.moments},
              {"axes", arrayOf(spin.axes, [](const auto& axis) { return vectorJson(axis); })},
              {"equal_moments", equalText(spin.equal)},
              {"angular_velocity_rad_per_s", vectorJson(spin.angularVelocity)},
              {"angular_momentum_kg_m2_per_s", vectorJson(spin.angularMomentum)},
              {"energy_j", spin.energy},
              {"spun_axis", kMoments[spin.spunAxis]},
              {"off_axis_rad", spin.offAxis},
              {"steady", spin.isSteady},
              {"regime", static_cast<int>(spin.regime)},
              {"growth_per_s", orNull(spin.growth)},
              {"oscillation_rad_per_s", orNull(spin.oscillation)},
              {"first_flip_s", orNull(spin.firstFlip)},
              {"flip_interval_s", orNull(spin.flipInterval())}};
  object.update(periodJson(spin));
  object.update({{"margin", orNull(spin.margin)},
                 {"to_separatrix_rad", orNull(spin.toSeparatrix)},
                 {"euler", numbers.euler ? eulerJson(*numbers.euler) : Json()},
                 {"remarks", remarksOn(numbers)}});
  return object;
}

}  // namespace rotatebook::cli
