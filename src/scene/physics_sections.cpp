// [body], [simulation], [initial] and [expect]: what moves, and what it must show.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/names.h"
#include "scene/sections.h"
#include "scene/toml_text.h"

namespace rotatebook::scene {
namespace {

using physics::Expectation;
using Limits = std::numeric_limits<double>;

constexpr int kMostSubsteps = 1'000'000;

constexpr NumberRange kSizes{"three lengths from 1e-6 to 1e6 m", 1e-6, 1e6};
constexpr NumberRange kMass{"a mass from 1e-9 to 1e9 kg", 1e-9, 1e9};
constexpr NumberRange kNumber{"a number", Limits::lowest(), Limits::max()};
constexpr NumberRange kNotNegative{"zero or a positive number", 0, Limits::max()};

physics::Tilt tiltFrom(const ValueReader& value) {
  const auto parts = value.elements(2, "an angle and an axis, such as [0.001, \"z\"]");
  return {parts[0].number(kNumber), parts[1].oneOf(kAxes)};
}

// Which vectors can be turned toward which axis is the physics' to say; the place is ours.
void checkTilt(const ValueReader& section, const physics::InitialSpin& spin) {
  try {
    spin.tilted();
  } catch (const InputError& error) {
    section.find("tilt")->fail(error.what());
  }
}

void checkOrder(const ValueReader& bounds, std::string_view lowKey, double low,
                std::string_view highKey, double high) {
  if (low <= high) return;
  bounds.find(lowKey)->mismatch("at most " + std::string(highKey) + ", " + tomlNumber(high));
}

Expectation expectationFrom(physics::Quantity quantity, const ValueReader& bounds) {
  Expectation expectation;
  expectation.quantity = quantity;
  bounds.readTable({
      {"min", [&](const ValueReader& value) { expectation.min = value.number(kNumber); }},
      {"max", [&](const ValueReader& value) { expectation.max = value.number(kNumber); }},
      {"rises_to", [&](const ValueReader& value) { expectation.risesTo = value.number(kNumber); }},
      {"falls_to", [&](const ValueReader& value) { expectation.fallsTo = value.number(kNumber); }},
      {"from", [&](const ValueReader& value) { expectation.from = value.number(kNotNegative); }},
      {"to", [&](const ValueReader& value) { expectation.to = value.number(kNotNegative); }},
  });
  if (!expectation.min && !expectation.max && !expectation.risesTo && !expectation.fallsTo) {
    bounds.fail(bounds.name() + " needs at least one of min, max, rises_to and falls_to");
  }
  if (expectation.min && expectation.max) {
    checkOrder(bounds, "min", *expectation.min, "max", *expectation.max);
  }
  checkOrder(bounds, "from", expectation.from, "to", expectation.to);
  return expectation;
}

void addExpectations(physics::Quantity quantity, const ValueReader& value,
                     std::vector<Expectation>& expectations) {
  for (const auto& bounds : value.tables("a table such as { min = 1.0 } or an array of them")) {
    expectations.push_back(expectationFrom(quantity, bounds));
  }
}

}  // namespace

void readBody(const ValueReader& section, physics::Cuboid& body) {
  section.readTable({
      {"size", [&](const ValueReader& value) { body.size = value.vector(kSizes); }},
      {"mass", [&](const ValueReader& value) { body.mass = value.number(kMass); }},
  });
}

void readSimulation(const ValueReader& section, physics::SimulationSettings& settings) {
  section.readTable({
      {"model", [&](const ValueReader& value) { settings.model = value.oneOf(kModels); }},
      {"integrator",
       [&](const ValueReader& value) { settings.integrator = value.oneOf(kIntegrators); }},
      {"normalize", [&](const ValueReader& value) { settings.normalize = value.flag(); }},
      {"damping", [&](const ValueReader& value) { settings.damping = value.number(kNotNegative); }},
      {"stiffness",
       [&](const ValueReader& value) { settings.stiffness = value.number(kPositive); }},
      {"time_per_frame",
       [&](const ValueReader& value) { settings.timePerFrame = value.number(kPositive); }},
      {"substeps",
       [&](const ValueReader& value) { settings.substeps = value.integer(1, kMostSubsteps); }},
  });
}

void readInitial(const ValueReader& section, physics::InitialSpin& spin) {
  std::vector<Field> fields;
  fields.reserve(kSpinKinds.size() + 1);
  for (const auto& kind : kSpinKinds) {
    fields.push_back({kind.name, [&](const ValueReader& value) {
                        spin.kind = kind.value;
                        spin.value = value.direction();
                      }});
  }
  fields.push_back({"tilt", [&](const ValueReader& value) { spin.tilt = tiltFrom(value); }});
  section.readTable(fields);

  const bool hasVelocity = section.find("angular_velocity").has_value();
  const bool hasMomentum = section.find("angular_momentum").has_value();
  if (hasVelocity && hasMomentum) {
    section.fail("[initial] has both angular_velocity and angular_momentum; keep one of them");
  }
  if (!hasVelocity && !hasMomentum) {
    section.fail("[initial] needs angular_velocity or angular_momentum");
  }
  checkTilt(section, spin);
}

void readExpectations(const ValueReader& section, std::vector<Expectation>& expectations) {
  const auto quantities = physics::allQuantities();
  std::vector<Field> fields;
  fields.reserve(quantities.size());
  for (const physics::Quantity quantity : quantities) {
    fields.push_back({physics::nameOf(quantity), [&expectations, quantity](const auto& value) {
                        addExpectations(quantity, value, expectations);
                      }});
  }
  section.readTable(fields);
}

}  // namespace rotatebook::scene
