#include "scene/study_section.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/measure/flip_interval.h"
#include "physics/motion_start.h"
#include "scene/nearest_name.h"
#include "scene/sections.h"
#include "scene/toml_text.h"

namespace rotatebook::scene {
namespace {

using physics::Integrator;
using physics::Model;

constexpr int kMostDoublings = 10;
constexpr NumberRange kTilts{"an angle over 0 and up to 0.785 rad",
                             std::numeric_limits<double>::denorm_min(), std::numbers::pi / 4};
constexpr NumberRange kBound{"a number", std::numeric_limits<double>::lowest(),
                             std::numeric_limits<double>::max()};
// Angle between the untilted spin and the median axis up to which there is a law to compare with.
// [rad]
constexpr double kAboutMedian = 0.1;

Bounds boundsFrom(const ValueReader& value) {
  Bounds bounds;
  value.readTable({
      {"min", [&](const ValueReader& bound) { bounds.min = bound.number(kBound); }},
      {"max", [&](const ValueReader& bound) { bounds.max = bound.number(kBound); }},
  });
  if (!bounds.min && !bounds.max) value.fail(value.name() + " needs min, max or both");
  if (bounds.min && bounds.max && *bounds.min > *bounds.max) {
    value.find("min")->mismatch("at most max, " + tomlNumber(*bounds.max));
  }
  return bounds;
}

/// Reads a list whose elements differ from each other.
template <typename T, typename Read>
std::vector<T> listFrom(const ValueReader& value, const std::string& expected, const Read& read) {
  std::vector<T> list;
  for (const ValueReader& element : value.list(expected)) {
    const T item = read(element);
    if (std::ranges::count(list, item) > 0) {
      element.fail(value.name() + " has " + describe(element.node()) + " twice");
    }
    list.push_back(item);
  }
  return list;
}

/// An integrator of the scene's model.
Integrator integratorFrom(const ValueReader& value, Model model) {
  value.choice(integratorNames(model));
  return value.oneOf(kIntegrators);
}

void refuseExact(const ValueReader& section) {
  section.fail(
      "the model \"exact\" takes no steps, so that [study] has no integrators and steps to "
      "compare; give it tilts, or choose another model");
}

std::vector<ExpectedOrder> ordersFrom(const ValueReader& value, const Scene& scene,
                                      const std::vector<Integrator>& studied) {
  std::vector<ExpectedOrder> orders;
  std::vector<Field> fields;
  for (const Integrator integrator : integratorsOf(scene.simulation.model)) {
    const std::string_view name = nameOf(kIntegrators, integrator);
    fields.push_back({name, [&orders, integrator](const ValueReader& bounds) {
                        orders.push_back({integrator, boundsFrom(bounds)});
                      }});
  }
  value.readTable(fields);
  // An integrator that the command line leaves out has nothing to show.
  std::erase_if(orders, [&](const ExpectedOrder& order) {
    return std::ranges::count(studied, order.integrator) == 0;
  });
  return orders;
}

StudySettings readPrecision(const ValueReader& section, const Scene& scene) {
  const Model model = scene.simulation.model;
  if (model == Model::Exact) refuseExact(section);
  StudySettings study = defaultStudy(model);
  if (const auto value = section.find("integrators")) {
    study.integrators = listFrom<Integrator>(
        *value, "a list of integrators, such as [\"euler\", \"rk4\"]",
        [model](const ValueReader& element) { return integratorFrom(element, model); });
  }
  if (const auto value = section.find("steps")) {
    study.steps =
        listFrom<int>(*value, "a list of steps a frame, such as [1, 2, 4]",
                      [](const ValueReader& element) { return element.integer(1, kMostSubsteps); });
  }
  if (const auto value = section.find("orders")) {
    study.orders = ordersFrom(*value, scene, study.integrators);
  }
  return study;
}

void checkTilted(const ValueReader& tilts, const Scene& scene) {
  if (!scene.initial.tilt) {
    tilts.fail(tilts.name() + " needs initial.tilt, whose axis it takes, such as [0.1, \"z\"]");
  }
  physics::MotionSettings motion = scene.motion();
  motion.initial.tilt.reset();
  const Eigen::Vector3d axis = medianAxis(modelInertia(motion));
  const Eigen::Vector3d spin = initialAngularVelocity(motion);
  if (axis.cross(spin).norm() <= kAboutMedian * spin.norm()) return;
  tilts.fail(tilts.name() +
             " needs a spin about the axis of the median moment of inertia, about which alone a "
             "body flips");
}

StudySettings readTilts(const ValueReader& section, const ValueReader& tilts, const Scene& scene) {
  StudySettings study;
  study.tilts = listFrom<double>(tilts, "a list of angles, such as [0.1, 0.01]",
                                 [](const ValueReader& element) { return element.number(kTilts); });
  if (const auto value = section.find("flip_law")) study.flipLaw = boundsFrom(*value);
  checkTilted(tilts, scene);
  return study;
}

void refuseMixture(const ValueReader& section) {
  for (const char* key : {"integrators", "steps", "orders"}) {
    if (const auto value = section.find(key)) {
      value->fail("[study] has both tilts and " + std::string(key) +
                  "; it compares either tilts, or integrators and steps");
    }
  }
}

template <typename T, typename Text>
std::string arrayText(const std::vector<T>& values, const Text& text) {
  std::vector<std::string> parts;
  for (const T& value : values) parts.push_back(text(value));
  return "[" + joined(parts) + "]";
}

std::string boundsText(const Bounds& bounds) {
  std::vector<std::string> parts;
  if (bounds.min) parts.push_back("min = " + tomlNumber(*bounds.min));
  if (bounds.max) parts.push_back("max = " + tomlNumber(*bounds.max));
  return "{ " + joined(parts) + " }";
}

std::string tiltsText(const StudySettings& study) {
  std::string text = "tilts = " + arrayText(study.tilts, tomlNumber) +
                     "  # rad, each in place of that of [initial]\n";
  if (!study.flipLaw) return text;
  return text + "flip_law = " + boundsText(*study.flipLaw) +
         "  # greatest |measured interval / law - 1|\n";
}

std::string precisionText(const StudySettings& study) {
  const auto word = [](Integrator integrator) {
    return tomlString(nameOf(kIntegrators, integrator));
  };
  std::string text = "integrators = " + arrayText(study.integrators, word) + "\nsteps = " +
                     arrayText(study.steps, [](int steps) { return std::to_string(steps); }) +
                     "  # integration steps for each frame, in place of simulation.substeps\n";
  for (const auto& [integrator, bounds] : study.orders) {
    text += "orders." + std::string(nameOf(kIntegrators, integrator)) + " = " + boundsText(bounds) +
            "\n";
  }
  return text;
}

}  // namespace

StudySettings defaultStudy(Model model) {
  StudySettings study;
  const auto integrators = integratorsOf(model);
  study.integrators.assign(integrators.begin(), integrators.end());
  if (study.integrators.empty()) return study;
  for (int doublings = 0; doublings <= kMostDoublings; ++doublings) {
    study.steps.push_back(1 << doublings);
  }
  return study;
}

StudySettings readStudy(const ValueReader& section, const Scene& scene) {
  // Each is read below, in an order of its own; here the names are checked.
  const auto later = [](const ValueReader&) {};
  section.readTable({{"integrators", later},
                     {"steps", later},
                     {"orders", later},
                     {"tilts", later},
                     {"flip_law", later}});
  const auto tilts = section.find("tilts");
  if (tilts) {
    refuseMixture(section);
    return readTilts(section, *tilts, scene);
  }
  if (const auto law = section.find("flip_law")) law->fail(law->name() + " needs study.tilts");
  return readPrecision(section, scene);
}

std::string studyText(const StudySettings& study) {
  return "\n[study]\n" + (study.isOfTilts() ? tiltsText(study) : precisionText(study));
}

}  // namespace rotatebook::scene
