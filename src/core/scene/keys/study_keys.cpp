// The keys of [study]: which runs to make, and what must come out.
#include <algorithm>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::kNumber;
using document::kPositive;
using physics::Integrator;

constexpr const char* kExpectedSteps = "a list of substeps, such as [1, 2, 4]";
constexpr const char* kExpectedTilts = "a list of angles, such as [0.1, 0.01]";
constexpr NumberRange kTilts{"an angle over 0 and up to 0.785 rad",
                             std::numeric_limits<double>::denorm_min(), std::numbers::pi / 4,
                             Dimension::Angle};

constexpr NumberRange kStudyTimes{kPositive.expected, kPositive.min, kPositive.max,
                                  Dimension::Time};

Bounds boundsFrom(const ValueReader& value) {
  Bounds bounds;
  readKeys(value, boundKeys(), bounds);
  checkBounds(value, bounds);
  return bounds;
}

std::string boundsText(const Bounds& bounds) {
  return inlineTable(boundKeys(), bounds);
}

/// Reads a list whose elements differ from each other.
template <typename T, typename Read>
std::vector<T> listFrom(const ValueReader& value, const std::string& expected, const Read& read) {
  std::vector<T> list;
  readEach(value.list(expected), [&](const ValueReader& element) {
    const T item = read(element);
    if (std::ranges::count(list, item) > 0) {
      element.fail(value.name() + " has " + describe(element.node()) + " twice");
    }
    list.push_back(item);
  });
  return list;
}

void readIntegrators(const ValueReader& value, Scene& scene) {
  scene.study->integrators = listFrom<Integrator>(
      value, "a list of integrators, such as [\"euler\", \"rk4\"]",
      [names = integratorNames(scene.simulation.model)](const ValueReader& element) {
        element.choice(names);
        return choiceFrom(element, kIntegrators);
      });
}

void readSteps(const ValueReader& value, Scene& scene) {
  scene.study->steps = listFrom<int>(value, kExpectedSteps, [](const ValueReader& element) {
    return element.integer(1, kMaxSubsteps);
  });
}

void readOrders(const ValueReader& value, Scene& scene) {
  StudySettings& study = *scene.study;
  std::vector<Field> fields;
  for (const Integrator integrator : integratorsOf(scene.simulation.model)) {
    fields.push_back({nameOf(kIntegrators, integrator), [&, integrator](const ValueReader& bounds) {
                        study.orders.push_back({integrator, boundsFrom(bounds)});
                      }});
  }
  value.readTable(fields);
  // Without its runs, which the command line may leave out, an integrator has nothing to show.
  std::erase_if(study.orders, [&](const ExpectedOrder& order) {
    return std::ranges::count(study.integrators, order.integrator) == 0;
  });
}

void readTilts(const ValueReader& value, Scene& scene) {
  scene.study->tilts = listFrom<double>(
      value, kExpectedTilts, [](const ValueReader& element) { return element.number(kTilts); });
}

/// Returns a function that prints a list; nothing for an empty one.
template <typename T, typename Text>
auto listOf(std::vector<T> StudySettings::*list, Text text) {
  return [list, text](const Scene& scene) {
    const std::vector<T>& values = *scene.study.*list;
    return values.empty() ? "" : listText(values, text);
  };
}

std::string flipLawText(const Scene& scene) {
  return scene.study->flipLaw ? boundsText(*scene.study->flipLaw) : "";
}

}  // namespace

const Keys<Scene>& samplingKeys() {
  const auto ofStudy = [](auto part) {
    return [part](auto& scene) -> auto& {
      return (*scene.study).*part;
    };
  };
  static const Keys<Scene> keys{
      keyAt<Scene>("duration", ofStudy(&StudySettings::duration), number(kStudyTimes),
                   {.comment = "s, length of the motions",
                    .meaning = "length of the motions, whatever the clip's",
                    .byDefault = "the clip's"}),
      keyAt<Scene>("interval", ofStudy(&StudySettings::interval), number(kStudyTimes),
                   {.comment = "s from sample to sample",
                    .meaning = "time from sample to sample, whatever the steps",
                    .byDefault = "that from frame to frame"}),
  };
  return keys;
}

const Keys<Scene>& studyKeys() {
  static const Keys<Scene> keys{
      {"integrators",
       readIntegrators,
       listOf(&StudySettings::integrators,
              [](Integrator one) { return quotedName(kIntegrators, one); }),
       {.meaning = "integrators to compare; `--integrators` overrides",
        .byDefault = "all of the model's",
        .allowed = "a list of the model's integrators"}},
      {"steps",
       readSteps,
       listOf(&StudySettings::steps, [](int steps) { return std::to_string(steps); }),
       {.comment = "integration steps, each in place of simulation.substeps",
        .meaning = "steps to compare; `--steps` overrides",
        .byDefault = "1, 2, 4 ... 1024",
        .allowed = kExpectedSteps}},
      // Printed by ordersText().
      {"orders",
       readOrders,
       [](const Scene&) { return ""; },
       {.meaning = "on the order of each integrator: `study.orders.rk4`",
        .byDefault = "none",
        .allowed = "bounds such as { min = 1.0, max = 2.0 }",
        .affects = Affects::Text}},
      {"tilts",
       readTilts,
       listOf(&StudySettings::tilts, tomlNumber),
       {.comment = "rad, each in place of the one in [initial]",
        .meaning = "instead of these: initial tilts to compare, up to 0.785",
        .byDefault = "none",
        .allowed = kExpectedTilts,
        .unit = "rad"}},
      {"flip_law",
       [](const ValueReader& value, Scene& scene) { scene.study->flipLaw = boundsFrom(value); },
       flipLawText,
       {.comment = "greatest |measured interval / law - 1|",
        .meaning = "with tilts: on the greatest \\|measured interval / law - 1\\|",
        .byDefault = "none",
        .allowed = "bounds such as { min = 1.0, max = 2.0 }",
        .affects = Affects::Text}},
  };
  return keys;
}

std::string ordersText(const StudySettings& study) {
  std::string text;
  for (const auto& [integrator, bounds] : study.orders) {
    text += "orders." + std::string(nameOf(kIntegrators, integrator)) + " = " + boundsText(bounds) +
            "\n";
  }
  return text;
}

}  // namespace rotatebook::scene
