// The keys of [body], [simulation], [initial], [[nudge]] and [expect]: what moves, and what it must
// show.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

#include "base/elementary.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "rigid/inertia.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/keys/recorded_keys.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using Limits = std::numeric_limits<double>;
using document::kNumber;
using document::kPositive;
using document::TomlNode;
using physics::InitialSpin;
using physics::MotionSettings;
using physics::SimulationSettings;

constexpr NumberRange kSizes{"three lengths from 1e-6 to 1e6 m", 1e-6, 1e6, Dimension::Length};
constexpr NumberRange kMass{"a mass from 1e-9 to 1e9 kg", 1e-9, 1e9, Dimension::Mass};
constexpr NumberRange kMoments{"three moments of inertia up to 1e21 kg m^2", -1e21, 1e21};
constexpr NumberRange kRow{"rows of three numbers up to 1e21 kg m^2", -1e21, 1e21};
// Squares and inverses of these are finite, too.
constexpr NumberRange kStepTimes{"a time from 1e-100 to 1e100 s", 1e-100, 1e100, Dimension::Time};
constexpr NumberRange kTilt{"an angle from -1e6 to 1e6 rad", -kLargestAngle, kLargestAngle,
                            Dimension::Angle};
constexpr NumberRange kNudgeTimes{"a time over 0 and up to 1e100 s", Limits::denorm_min(), 1e100,
                                  Dimension::Time};
constexpr const char* kExpectedBounds = "a table such as { min = 1.0 } or an array of them";
constexpr int kMaxInterval = 1'000'000'000;
constexpr const char* kExpectedEvery = "true, false or a table such as { every = 100 }";
constexpr const char* kExpectedTilt =
    "an angle and an axis, such as [0.02, \"z\"] or [\"1 deg\", \"z\"]";
constexpr NumberRange kNotNegative{"zero or a positive number", 0, Limits::max()};
constexpr NumberRange kWindowTimes{kNotNegative.expected, 0, kNotNegative.max, Dimension::Time};

Eigen::Matrix3d inertiaFrom(const ValueReader& value) {
  const auto rows = value.elements(
      3, "three moments, [Ix, Iy, Iz], or a tensor of three rows, [[Ixx, Ixy, Ixz], ...]");
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  if (std::holds_alternative<TomlNode::Array>(rows.front().node().value)) {
    for (int row = 0; row < 3; ++row) {
      tensor.row(row) = vectorFrom(rows[static_cast<std::size_t>(row)], kRow).transpose();
    }
  } else {
    tensor.diagonal() = vectorFrom(value, kMoments);
  }
  failAtValue(value, [&] { rigid::checkInertia(tensor); });
  return tensor;
}

std::string inertiaText(const Eigen::Matrix3d& tensor) {
  if (tensor.isDiagonal(0)) return vectorText(tensor.diagonal());
  return "[" +
         joined({vectorText(tensor.row(0)), vectorText(tensor.row(1)), vectorText(tensor.row(2))}) +
         "]";
}

void readIntegrator(const ValueReader& value, SimulationSettings& settings) {
  if (value.text(kLongestName) == nameOf(kModels, physics::Model::Exact)) {
    value.fail(value.name() + " can't be \"exact\": the closed form is a model of its own, " +
               "simulation.model = \"exact\", for rigid bodies; particles have none");
  }
  settings.integrator = choiceFrom(value, kIntegrators);
}

/// Returns the value with a comment that depends on the model; empty for a model without steps.
std::string integratorText(const SimulationSettings& settings) {
  const auto names = integratorNames(settings.model);
  if (names.empty()) return "";
  return quotedName(kIntegrators, settings.integrator) + "  # " + quotedList(names, "or");
}

int everyStepFrom(const ValueReader& value) {
  if (const bool* flag = std::get_if<bool>(&value.node().value)) return *flag ? 1 : 0;
  const auto* table = std::get_if<TomlNode::Table>(&value.node().value);
  if (!table || table->empty()) value.mismatch(kExpectedEvery);
  int every = 0;
  value.readTable(
      {{"every", [&every](const ValueReader& steps) { every = steps.integer(1, kMaxInterval); }}});
  return every;
}

/// Numbers of steps from one correction to the next; 0 for none.
Kind<int> everyStep() {
  return {everyStepFrom,
          [](int every) -> std::string {
            if (every > 1) return "{ every = " + std::to_string(every) + " }";
            return every == 1 ? "true" : "false";
          },
          kExpectedEvery};
}

constexpr const char* kExpectedArrangement =
    "\"corners\", \"equimomental\", \"vertices\" or \"grid:N\", with N from 2 to 200";
constexpr std::string_view kGrid = "grid:";

int cellsFrom(const ValueReader& value, std::string_view text) {
  constexpr int kMinCells = 2, kMaxCells = 200;
  int cells = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), cells);
  if (error != std::errc() || end != text.data() + text.size() || cells < kMinCells ||
      cells > kMaxCells)
    value.mismatch(kExpectedArrangement);
  return cells;
}

physics::ParticleSettings arrangementFrom(const ValueReader& value) {
  const auto* text = std::get_if<std::string>(&value.node().value);
  if (text == nullptr) value.mismatch(kExpectedArrangement);
  if (text->starts_with(kGrid))
    return {physics::Arrangement::Grid,
            cellsFrom(value, std::string_view(*text).substr(kGrid.size()))};
  if (!nearestName(*text, namesOf(kArrangements))) value.mismatch(kExpectedArrangement);
  return {choiceFrom(value, kArrangements)};
}

/// Places of particles.
Kind<physics::ParticleSettings> arrangement() {
  return {arrangementFrom,
          [](const physics::ParticleSettings& settings) {
            if (settings.arrangement != physics::Arrangement::Grid)
              return quotedName(kArrangements, settings.arrangement);
            return tomlString(std::string(kGrid) + std::to_string(settings.cells));
          },
          kExpectedArrangement};
}

constexpr NumberRange kRates{"a number from -1e9 to 1e9, but not 0", -1e9, 1e9};
constexpr std::array<Named<int>, 3> kRanks{{{"smallest", 0}, {"middle", 1}, {"largest", 2}}};

/// Reads { about = "middle", value = 4 }, the axis by its moment.
physics::SpinAbout aboutFrom(const ValueReader& value, physics::SpinKind kind) {
  physics::SpinAbout about;
  NumberRange range = kRates;
  if (kind == physics::SpinKind::AngularVelocity) range.dimension = Dimension::AngularVelocity;
  value.readTable(
      {{"about", [&](const ValueReader& rank) { about.rank = choiceFrom(rank, kRanks); }},
       {"value", [&](const ValueReader& rate) { about.rate = rate.number(range); }}});
  if (!value.find("about") || about.rate == 0)
    value.mismatch("three numbers, or a table such as { about = \"middle\", value = 4.0 }");
  return about;
}

std::string aboutText(const physics::SpinAbout& about) {
  return "{ about = " + quotedName(kRanks, about.rank) + ", value = " + tomlNumber(about.rate) +
         " }";
}

/// Returns a key of one of the kinds in which the spin S is given.
template <typename S>
Key<S> spinKey(physics::SpinKind kind, const std::string& unit, KeyText documentation) {
  documentation.allowed = direction().allowed;
  documentation.comment = unit;
  return {nameOf(kSpinKinds, kind),
          [kind](const ValueReader& value, S& spin) {
            spin.kind = kind;
            if constexpr (std::is_same_v<S, InitialSpin>) {
              spin.about.reset();
              if (std::holds_alternative<TomlNode::Table>(value.node().value)) {
                spin.about = aboutFrom(value, kind);
                return;
              }
            }
            NumberRange range = kDirections;
            if (kind == physics::SpinKind::AngularVelocity)
              range.dimension = Dimension::AngularVelocity;
            spin.value = directionFrom(value, range);
          },
          [kind](const S& spin) -> std::string {
            if (spin.kind != kind) return "";
            if constexpr (std::is_same_v<S, InitialSpin>) {
              if (spin.about) return aboutText(*spin.about);
            }
            return vectorText(spin.value);
          },
          std::move(documentation)};
}

physics::Tilt tiltFrom(const ValueReader& value) {
  const auto parts = value.elements(2, kExpectedTilt);
  return {parts[0].number(kTilt), choiceFrom(parts[1], kAxes)};
}

std::string tiltText(const physics::Tilt& tilt) {
  return "[" + tomlNumber(tilt.angle) + ", " + quotedName(kAxes, tilt.axis) + "]";
}

const Keys<Expectation>& windowedBoundKeys() {
  static const Keys<Expectation> keys{
      key("min", &Expectation::min, number(kNumber)),
      key("max", &Expectation::max, number(kNumber)),
      key("rises_to", &Expectation::risesTo, number(kNumber)),
      key("falls_to", &Expectation::fallsTo, number(kNumber)),
      key("from", &Expectation::from, number(kWindowTimes)),
      {"to",
       [](const ValueReader& value, Expectation& bounds) {
         bounds.to = value.number(kWindowTimes);
       },
       // A window without an end prints no `to`.
       [](const Expectation& bounds) {
         return std::isfinite(bounds.to) ? tomlNumber(bounds.to) : "";
       },
       {}},
  };
  return keys;
}

void checkOrder(const ValueReader& bounds, std::string_view lowKey, double low,
                std::string_view highKey, double high) {
  if (low <= high) return;
  bounds.find(lowKey)->mismatch("at most " + std::string(highKey) + ", " + tomlNumber(high));
}

Expectation expectationFrom(Measure measure, const ValueReader& bounds) {
  Expectation expectation;
  expectation.measure = measure;
  readKeys(bounds, windowedBoundKeys(), expectation);
  if (!expectation.min && !expectation.max && !expectation.risesTo && !expectation.fallsTo) {
    bounds.fail(bounds.name() + " needs at least one of min, max, rises_to and falls_to");
  }
  if (expectation.min && expectation.max) {
    checkOrder(bounds, "min", *expectation.min, "max", *expectation.max);
  }
  checkOrder(bounds, "from", expectation.from, "to", expectation.to);
  return expectation;
}

/// Returns the one key that holds all bounds on a quantity.
Key<std::vector<Expectation>> measureKey(Measure measure) {
  return {nameOf(measure),
          [measure](const ValueReader& value, std::vector<Expectation>& expectations) {
            for (const auto& bounds : value.tables(kExpectedBounds)) {
              expectations.push_back(expectationFrom(measure, bounds));
            }
          },
          [measure](const std::vector<Expectation>& expectations) {
            std::vector<std::string> bounds;
            for (const Expectation& expectation : expectations) {
              if (expectation.measure != measure) continue;
              bounds.push_back(inlineTable(windowedBoundKeys(), expectation));
            }
            return bounds.size() == 1 ? bounds.front() : "[" + joined(bounds) + "]";
          },
          {.meaning = std::string(rowOf(measure).meaning),
           .byDefault = "none",
           .allowed = kExpectedBounds}};
}

std::string labelFrom(const ValueReader& value) {
  std::string label = value.text(kLongestLabel);
  if (label.empty()) value.mismatch("a string that isn't empty");
  return label;
}

Keys<SimulationSettings> joinedKeys(Keys<SimulationSettings> keys,
                                    const Keys<SimulationSettings>& others) {
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

}  // namespace

const Keys<MotionSettings>& bodyKeys() {
  static const Keys<MotionSettings> keys{
      keyAt<MotionSettings>(
          "size", [](auto& motion) -> auto& { return motion.body.size; }, vector(kSizes),
          {.comment = "m, along x (from the spine), y (to the top), z (to the cover)",
           .meaning = "along x, y, z"}),
      keyAt<MotionSettings>("mass", [](auto& motion) -> auto& { return motion.body.mass; },
                            number(kMass), {.comment = "kg", .meaning = "[kg]"}),
      key("inertia", &MotionSettings::inertia, Kind<Eigen::Matrix3d>{inertiaFrom, inertiaText, {}},
          {.comment = "kg m^2, in place of the solid cuboid's",
           .meaning = "for rigid models [kg m²]",
           .byDefault = "the solid cuboid's",
           .allowed = "three moments, or a symmetric 3x3 tensor"}),
  };
  return keys;
}

const Keys<SimulationSettings>& simulationKeys() {
  static const Keys<SimulationSettings> keys = joinedKeys(
      {
          key("model", &SimulationSettings::model, oneOf(kModels),
              {.meaning = "see [models](motion.md)"}),
          {"integrator",
           readIntegrator,
           integratorText,
           {.meaning = "see [integrators](motion.md#integrators)",
            .byDefault = "`\"rk4\"`; for particles `\"euler\"`",
            .allowed = "one of the model's integrators"}},
          key("normalize", &SimulationSettings::normalizeEvery, everyStep(),
              {.comment = "undo the integrator's drift after each step, or after each n-th",
               .meaning = "undo the integrator's drift, see [normalising](motion.md#normalising)"}),
          key("normalize_energy", &SimulationSettings::normalizeEnergyEvery, everyStep(),
              {.meaning = "particles: scale the velocities to the energy at the start",
               .byDefault = "as `normalize`"}),
          key("remove_drift", &SimulationSettings::removeDriftEvery, everyStep(),
              {.meaning = "particles: bring the centre of mass to rest at the origin",
               .byDefault = "as `normalize`"}),
          key("damping", &SimulationSettings::damping, number(kNotNegative),
              {.comment = "particles: fraction of critical damping",
               .meaning = "particles: of each spring, as a fraction of 2√(km)"}),
          key("stiffness", &SimulationSettings::stiffness, number(kPositive),
              {.comment = "particles: N/m, of each spring",
               .meaning = "particles: of each spring [N/m]"}),
          key("particles", &SimulationSettings::particles, arrangement(),
              {.comment = "particles: where they are",
               .meaning = "particles: where they are, see [bodies](bodies.md#particles)"}),
          key("time_per_frame", &SimulationSettings::timePerFrame, number(kStepTimes),
              {.comment = "s simulated for each frame of video",
               .meaning = "simulated time from a frame to the next",
               .byDefault = "1/fps"}),
          key("substeps", &SimulationSettings::substeps, integer(1, kMaxSubsteps),
              {.comment = "integration steps for each frame"}),
      },
      recordedKeys());
  return keys;
}

const Keys<InitialSpin>& initialKeys() {
  static const Keys<InitialSpin> keys{
      spinKey<InitialSpin>(
          physics::SpinKind::AngularVelocity, "rad/s",
          {.meaning = "[rad/s]", .byDefault = "required, unless the next is given"}),
      spinKey<InitialSpin>(
          physics::SpinKind::AngularMomentum, "kg m^2/s",
          {.meaning = "[kg m²/s]", .byDefault = "required, unless the one before is given"}),
      key("tilt", &InitialSpin::tilt, Kind<physics::Tilt>{tiltFrom, tiltText, kExpectedTilt},
          {.comment = "rad, and the axis toward which the spin is turned",
           .meaning = "turns the vector given above toward the axis [rad]",
           .byDefault = "none"}),
  };
  return keys;
}

const Keys<physics::Nudge>& nudgeKeys() {
  static const Keys<physics::Nudge> keys{
      key("at", &physics::Nudge::at, number(kNudgeTimes),
          {.comment = "s, of simulated time",
           .meaning = "when, of simulated time [s]",
           .byDefault = "required"}),
      spinKey<physics::Nudge>(physics::SpinKind::AngularVelocity, "rad/s",
                              {.meaning = "what is added to the spin [rad/s]",
                               .byDefault = "required, unless the next is given"}),
      spinKey<physics::Nudge>(physics::SpinKind::AngularMomentum, "kg m^2/s",
                              {.meaning = "what is added to it [kg m²/s]",
                               .byDefault = "required, unless the one before is given"}),
      key("axes", &physics::Nudge::axes, oneOf(kNudgeAxes),
          {.meaning = "the axes that it is along, at that moment"}),
  };
  return keys;
}

const Keys<std::vector<Expectation>>& expectKeys() {
  static const auto keys = [] {
    Keys<std::vector<Expectation>> all;
    for (const Measure measure : measuresOfMotions()) all.push_back(measureKey(measure));
    return all;
  }();
  return keys;
}

const Keys<Panel>& panelKeys() {
  static const Keys<Panel> keys{
      key("label", &Panel::label,
          Kind<std::string>{labelFrom, tomlString, document::expectedString(kLongestLabel)},
          {.meaning = "shown in the picture and the report, and part of the CSV file's name",
           .byDefault = "required"}),
  };
  return keys;
}

}  // namespace rotatebook::scene
