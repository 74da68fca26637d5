// [body], [simulation], [initial] and [expect]: what moves, and what it must show.
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "physics/elementary.h"
#include "scene/names.h"
#include "scene/nearest_name.h"
#include "scene/sections.h"
#include "scene/toml_text.h"

namespace rotatebook::scene {
namespace {

using Limits = std::numeric_limits<double>;

constexpr NumberRange kSizes{"three lengths from 1e-6 to 1e6 m", 1e-6, 1e6};
constexpr NumberRange kMass{"a mass from 1e-9 to 1e9 kg", 1e-9, 1e9};
constexpr NumberRange kMoments{"three moments of inertia up to 1e21 kg m^2", -1e21, 1e21};
constexpr NumberRange kRow{"rows of three numbers up to 1e21 kg m^2", -1e21, 1e21};
// Their squares and inverses are numbers, too.
constexpr NumberRange kStepTimes{"a time from 1e-100 to 1e100 s", 1e-100, 1e100};
constexpr NumberRange kNumber{"a number", Limits::lowest(), Limits::max()};
constexpr NumberRange kTilt{"an angle from -1e6 to 1e6 rad", -physics::kLargestAngle,
                            physics::kLargestAngle};
constexpr NumberRange kNotNegative{"zero or a positive number", 0, Limits::max()};

// What physics refuses is physics' to say; the place is ours.
template <typename Check>
void failAtValue(const ValueReader& value, const Check& check) {
  try {
    check();
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

Eigen::Matrix3d inertiaFrom(const ValueReader& value) {
  const auto rows = value.elements(
      3, "three moments, [Ix, Iy, Iz], or a tensor of three rows, [[Ixx, Ixy, Ixz], ...]");
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  if (std::holds_alternative<TomlNode::Array>(rows.front().node().value)) {
    for (int row = 0; row < 3; ++row) {
      tensor.row(row) = rows[static_cast<std::size_t>(row)].vector(kRow).transpose();
    }
  } else {
    tensor.diagonal() = value.vector(kMoments);
  }
  failAtValue(value, [&] { physics::checkInertia(tensor); });
  return tensor;
}

physics::Integrator integratorFrom(const ValueReader& value) {
  if (value.text(kLongestName) == nameOf(kModels, physics::Model::Exact)) {
    value.fail(value.name() + " can't be \"exact\": the closed form is a model of its own, " +
               "simulation.model = \"exact\", of a rigid body; particles have none");
  }
  return value.oneOf(kIntegrators);
}

physics::Tilt tiltFrom(const ValueReader& value) {
  const auto parts = value.elements(2, "an angle and an axis, such as [0.001, \"z\"]");
  return {parts[0].number(kTilt), parts[1].oneOf(kAxes)};
}

void checkOrder(const ValueReader& bounds, std::string_view lowKey, double low,
                std::string_view highKey, double high) {
  if (low <= high) return;
  bounds.find(lowKey)->mismatch("at most " + std::string(highKey) + ", " + tomlNumber(high));
}

Expectation expectationFrom(Quantity quantity, const ValueReader& bounds) {
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

void addExpectations(Quantity quantity, const ValueReader& value,
                     std::vector<Expectation>& expectations) {
  for (const auto& bounds : value.tables("a table such as { min = 1.0 } or an array of them")) {
    expectations.push_back(expectationFrom(quantity, bounds));
  }
}

}  // namespace

void readBody(const ValueReader& section, physics::Cuboid& body,
              std::optional<Eigen::Matrix3d>& inertia) {
  section.readTable({
      {"size", [&](const ValueReader& value) { body.size = value.vector(kSizes); }},
      {"mass", [&](const ValueReader& value) { body.mass = value.number(kMass); }},
      {"inertia", [&](const ValueReader& value) { inertia = inertiaFrom(value); }},
  });
}

void readSimulation(const ValueReader& section, physics::SimulationSettings& settings) {
  section.readTable({
      {"model", [&](const ValueReader& value) { settings.model = value.oneOf(kModels); }},
      {"integrator",
       [&](const ValueReader& value) { settings.integrator = integratorFrom(value); }},
      {"normalize", [&](const ValueReader& value) { settings.normalize = value.flag(); }},
      {"damping", [&](const ValueReader& value) { settings.damping = value.number(kNotNegative); }},
      {"stiffness",
       [&](const ValueReader& value) { settings.stiffness = value.number(kPositive); }},
      {"time_per_frame",
       [&](const ValueReader& value) { settings.timePerFrame = value.number(kStepTimes); }},
      {"substeps",
       [&](const ValueReader& value) { settings.substeps = value.integer(1, kMostSubsteps); }},
  });
  if (!section.find("integrator")) settings.integrator = defaultIntegrator(settings.model);
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
  const auto tilt = section.find("tilt");
  if (tilt && (hasVelocity || hasMomentum)) failAtValue(*tilt, [&] { spin.tilted(); });
}

void requireSpin(const ValueReader& section) {
  for (const auto& kind : kSpinKinds) {
    if (section.find(kind.name)) return;
  }
  section.fail("[initial] needs angular_velocity or angular_momentum");
}

void readExpectations(const ValueReader& section, std::vector<Expectation>& expectations) {
  const auto quantities = allQuantities();
  std::vector<Field> fields;
  fields.reserve(quantities.size());
  for (const Quantity quantity : quantities) {
    fields.push_back({nameOf(quantity), [&expectations, quantity](const auto& value) {
                        addExpectations(quantity, value, expectations);
                      }});
  }
  section.readTable(fields);
}

void checkIntegrator(const ValueReader& section, const physics::SimulationSettings& settings) {
  const auto integrator = section.find("integrator");
  if (!integrator || physics::isFor(settings.model, settings.integrator)) return;
  const std::string chosen =
      integrator->name() + " = " + tomlString(nameOf(kIntegrators, settings.integrator));
  const std::string model = tomlString(nameOf(kModels, settings.model));
  if (settings.model == physics::Model::Exact) {
    integrator->fail(chosen + ", but the model " + model + " takes no steps; leave it out");
  }
  integrator->fail(chosen + ", but the model " + model + " has " +
                   quotedList(integratorNames(settings.model), "and"));
}

void checkInertia(const ValueReader& section, physics::Model model) {
  const auto inertia = section.find("inertia");
  if (!inertia || model != physics::Model::Particles) return;
  inertia->fail(inertia->name() +
                " is for rigid models, but the model is \"particles\", whose inertia follows from "
                "where they are; leave it out");
}

}  // namespace rotatebook::scene
