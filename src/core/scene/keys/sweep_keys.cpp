// The keys of [study] for a sweep: a study over any key of a motion.
#include <algorithm>
#include <string>
#include <vector>

#include "scene/keys/axis_keys.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

constexpr const char* kExpectedMeasures = "a list of quantities, such as [\"diverges_at\"]";

std::vector<Measure> measuresFrom(const ValueReader& value) {
  std::vector<Measure> measures;
  readEach(value.list(kExpectedMeasures), [&](const ValueReader& element) {
    const Measure measure = motionMeasureFrom(element);
    if (std::ranges::count(measures, measure) > 0) {
      element.fail(value.name() + " has " + std::string(nameOf(measure)) + " twice");
    }
    measures.push_back(measure);
  });
  if (measures.size() <= kMaxMeasures) return measures;
  value.fail(value.name() + " has " + std::to_string(measures.size()) +
             " quantities; a study measures up to " + std::to_string(kMaxMeasures));
}

/// Returns a function that finds a part of a scene's sweep, which must be present.
template <typename Part>
auto ofSweep(Part Sweep::*part) {
  return [part](auto& scene) -> auto& {
    return (*scene.study->sweep).*part;
  };
}

}  // namespace

const Keys<Scene>& sweepKeys() {
  static const Keys<Scene> keys{
      keyAt<Scene>("x", ofSweep(&Sweep::x), valueAxis(),
                   {.meaning = "instead of all these: the key that each run has another value of, "
                               "see [axes](vary.md#axes)",
                    .byDefault = "none"}),
      keyAt<Scene>(
          "curves", ofSweep(&Sweep::curves), valueAxis(),
          {.meaning = "a second key: one curve for each of its values", .byDefault = "none"}),
      keyAt<Scene>("measure", ofSweep(&Sweep::measures),
                   Kind<std::vector<Measure>>{measuresFrom,
                                              [](const std::vector<Measure>& all) {
                                                return listText(all, [](Measure one) {
                                                  return tomlString(nameOf(one));
                                                });
                                              },
                                              kExpectedMeasures},
                   {.meaning = "one to three of the [quantities](scene.md#expectations) to measure",
                    .byDefault = "required with `x`"}),
      keyAt<Scene>("expect", ofSweep(&Sweep::expected), kStudyExpectations.kind(),
                   {.meaning = "[bounds](vary.md#expectations) on all runs, or on those with an "
                               "`x` or on a `curve`",
                    .byDefault = "none",
                    .affects = Affects::Text}),
  };
  return keys;
}

}  // namespace rotatebook::scene
