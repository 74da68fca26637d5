#include "cli/info_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
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

/// Returns the vector for people: components that are only rounding, beside `scale`, are 0.
std::string bodyVectorText(const Eigen::Vector3d& vector, double scale, int digits) {
  return fmt::format("({})", joinedOf(vector, [&](double number) {
                       return roundedText(std::fabs(number) < 1e-12 * scale ? 0 : number, digits);
                     }));
}

/// Returns "x" or "(0.8, 0.6, 0)", for a unit vector.
std::string axisText(const Eigen::Vector3d& axis) {
  constexpr double kRounding = 1e-12;
  for (int i = 0; i < 3; ++i)
    if (std::fabs(axis[i]) > 1 - kRounding) return {"xyz"[i]};
  return bodyVectorText(axis, 1, 4);
}

std::string momentsText(const scene::SortedAxes& sorted) {
  return joinedOf(std::array{0, 1, 2}, [&](int i) {
    return fmt::format("{}{} about {}", roundedText(sorted.moments[i], 6), i == 0 ? " kg m^2" : "",
                       axisText(sorted.axes.col(i)));
  });
}

std::string pairText(const std::array<std::size_t, 2>& triangles) {
  return fmt::format("triangles {} and {}", triangles[0] + 1, triangles[1] + 1);
}

/// Returns what there is to say about the surface.
std::string surfaceText(const std::optional<scene::BodySurface>& surface) {
  if (!surface) return "the book, a cuboid";
  const std::string shells =
      surface->shells == 1
          ? "one closed surface"
          : fmt::format(
                "{} closed surfaces, which add up: also where they overlap; one that faces "
                "inward takes away",
                surface->shells);
  std::vector<std::string> notes = surface->notes;
  if (surface->crossing) {
    notes.push_back(pairText(*surface->crossing) +
                    " cross each other; what a surface encloses twice counts twice");
  }
  if (surface->overlap) {
    notes.push_back(
        pairText(*surface->overlap) +
        " meet at an edge around which something is enclosed twice, or taken away where "
        "nothing is; it counts so");
  }
  std::string text = fmt::format("{} triangles, {}", surface->triangles, shells);
  for (const std::string& note : notes) text += "\n  note        " + note;
  return text;
}

std::string inertiaText(const body::MassProperties& body, double scale) {
  std::string text = "about the centre [kg m^2]";
  for (int row = 0; row < 3; ++row)
    text += "\n              " + bodyVectorText(body.inertia.row(row), scale, 6);
  return text;
}

std::string growthText(double growth) {
  if (growth <= 1e-6) return "two moments are equal, or nearly so: no spin is unstable";
  return fmt::format("a spin of w about it is unstable: deviations grow as e^({} w t)",
                     roundedText(growth, 4));
}

/// Returns the numbers of two triangles, from 1; null if there are none.
Json pairJson(const std::optional<std::array<std::size_t, 2>>& triangles) {
  if (!triangles) return {};
  return arrayOf(*triangles, [](std::size_t triangle) { return triangle + 1; });
}

std::string spinText(const Spin& spin) {
  const double speed = spin.angularVelocity.norm();
  std::string line =
      fmt::format("{} rad/s ({} turns a second)", text(speed), text(speed / (2 * pi)));
  if (spin.equal == EqualMoments::All) return line;
  line += fmt::format(", {} from {}", countText(degrees(spin.offAxis), "degree"),
                      axisText(spin.axes[spin.spunAxis]));
  return spin.equal == EqualMoments::None ? fmt::format("{}, {}", line, kAxes[spin.spunAxis])
                                          : line;
}

std::string stabilityText(const SpinNumbers& numbers) {
  const Spin& spin = numbers.spin;
  if (spin.growth) {
    return fmt::format("unstable: small deviations grow as e^({} t), tenfold in {} s",
                       text(*spin.growth), text(std::numbers::ln10 / *spin.growth));
  }
  if (!spin.oscillation) return "";
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
          : axisText(spin.axes[2]),
      text(end), text(100 * energy / spin.energy));
}

std::string eulerText(const SpinNumbers& numbers) {
  if (!numbers.euler) return "";
  const timeline::EulerSteps& euler = *numbers.euler;
  const std::string keeps = fmt::format("{} s each, to keep the regime for {} s", text(euler.step),
                                        text(numbers.duration));
  if (!euler.substeps)
    return fmt::format("needs more than {} substeps, shorter than {}", euler.tried, keeps);
  return fmt::format("needs {}, {}", countText(*euler.substeps, "substep"), keeps);
}

std::string equalText(EqualMoments equal) {
  constexpr std::array<const char*, 4> kTexts{"none", "two smallest", "two largest", "all"};
  return kTexts[static_cast<std::size_t>(equal)];
}

Json eulerJson(const std::optional<timeline::EulerSteps>& euler) {
  if (!euler) return {};
  return {{"substeps", orNull(euler->substeps)}, {"tried", euler->tried}, {"h_s", euler->step}};
}

std::string regimeText(const Spin& spin) {
  if (!spin.period) return "";
  return fmt::format("the angular momentum L circles {}, {}",
                     axisText(spin.axes[spin.circledAxis()]), kAxes[spin.circledAxis()]);
}

std::string flipsText(const Spin& spin) {
  if (!spin.firstFlip) return "";
  return fmt::format("first at {} s, then every {} s", text(*spin.firstFlip),
                     text(*spin.flipInterval()));
}

ResultRows periodRows(const Spin& spin) {
  if (!spin.period) {
    return {{"period_s"},
            {"turn_rad"},
            {"dynamic_turn_rad"},
            {"geometric_turn_rad"},
            {"axis_turn_rad"}};
  }
  const SpinPeriod& period = *spin.period;
  return {{"period_s", period.time, "period",
           text(period.time) + " s, of the angular velocity in the body"},
          {"turn_rad", period.turn, "turn",
           fmt::format("{} degrees about L in a period, {} rad/s", degrees(period.turn),
                       text(period.turn / period.time))},
          {"dynamic_turn_rad", period.dynamicTurn},
          {"geometric_turn_rad", period.geometricTurn, "phases", phasesText(period)},
          {"axis_turn_rad", period.axisTurn, "precession",
           fmt::format("{} goes about L at {} rad/s", axisText(spin.axes[spin.circledAxis()]),
                       text(period.axisTurn / period.time))}};
}

ResultRows separatrixRows(const Spin& spin) {
  if (!spin.margin) return {{"margin"}, {"to_separatrix_rad"}};
  return {{"margin", *spin.margin},
          {"to_separatrix_rad", *spin.toSeparatrix, "separatrix",
           fmt::format("{} degrees away; L^2 / (2 E I2) - 1 is {}", degrees(*spin.toSeparatrix),
                       text(*spin.margin))}};
}

}  // namespace

ResultRows rowsOn(const scene::BodyNumbers& numbers) {
  const auto& [body, surface] = numbers;
  const scene::SortedAxes sorted = scene::sortedAxesOf(body);
  const scene::BodySurface known = surface.value_or(scene::BodySurface{});
  return {
      {.label = "body", .text = surfaceText(surface)},
      {"volume_m3", body.volume, "volume", roundedText(body.volume, 6) + " m^3"},
      {"mass_kg", body.mass, "mass", roundedText(body.mass, 6) + " kg"},
      {"centre_m", vectorJson(body.centre), "centre",
       bodyVectorText(body.centre, std::cbrt(body.volume), 6) + " m"},
      {"inertia_kg_m2", matrixJson(body.inertia), "inertia", inertiaText(body, sorted.moments[2])},
      {"moments_kg_m2", vectorJson(sorted.moments), "moments", momentsText(sorted)},
      {"axes", matrixJson(sorted.axes.transpose()), "middle axis", growthText(sorted.growth)},
      {"triangles", surface ? Json(known.triangles) : Json()},
      {"shells", surface ? Json(known.shells) : Json()},
      {"crossing", pairJson(known.crossing)},
      {"overlap", pairJson(known.overlap)},
      {"notes", known.notes},
      {"closed", true}};
}

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

ResultRows rowsOn(const SpinNumbers& numbers) {
  const Spin& spin = numbers.spin;
  ResultRows rows{
      {"label", orNull(numbers.motion.label)},
      {"model", nameOf(scene::kModels, numbers.motion.simulation.model)},
      {"moments_kg_m2", spin.moments},
      {"axes", arrayOf(spin.axes, [](const auto& axis) { return vectorJson(axis); })},
      {"equal_moments", equalText(spin.equal)},
      {"angular_velocity_rad_per_s", vectorJson(spin.angularVelocity), "spin", spinText(spin)},
      {"angular_momentum_kg_m2_per_s", vectorJson(spin.angularMomentum)},
      {"energy_j", spin.energy},
      {"spun_axis", kMoments[spin.spunAxis]},
      {"off_axis_rad", spin.offAxis},
      {"steady", spin.isSteady},
      {"regime", static_cast<int>(spin.regime)},
      {"growth_per_s", orNull(spin.growth), "stability", stabilityText(numbers)},
      {"oscillation_rad_per_s", orNull(spin.oscillation), "regime", regimeText(spin)},
      {"first_flip_s", orNull(spin.firstFlip), "flips", flipsText(spin)},
      {"flip_interval_s", orNull(spin.flipInterval())}};
  std::ranges::copy(periodRows(spin), std::back_inserter(rows));
  std::ranges::copy(separatrixRows(spin), std::back_inserter(rows));
  rows.push_back({"euler", eulerJson(numbers.euler), "Euler", eulerText(numbers)});
  rows.push_back({"remarks", remarksOn(numbers)});
  for (const std::string& remark : remarksOn(numbers)) rows.push_back({.text = remark});
  return rows;
}

}  // namespace rotatebook::cli
