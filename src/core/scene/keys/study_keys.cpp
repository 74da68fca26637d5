// The keys of [study]: which runs to make, and what must come out.
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

using document::kPositiveTime;

constexpr const char* kExpectedMeasures = "a list of quantities, such as [\"diverges_at\"]";
constexpr ValueForm kMeasureForm{.type = ValueForm::Type::Choice,
                                 .choices = measureNames(MeasureSections::Studies)};

std::vector<Measure> measuresFrom(const ValueReader& value) {
  std::vector<Measure> measures;
  readEach(value.list(kExpectedMeasures), [&](const ValueReader& element) {
    const Measure measure = measureFrom(element, MeasureSections::Studies);
    if (std::ranges::count(measures, measure) > 0) {
      element.fail(value.name() + " has " + std::string(nameOf(measure)) + " twice");
    }
    measures.push_back(measure);
  });
  if (measures.size() <= kMaxMeasures) return measures;
  value.fail(value.name() + " has " + std::to_string(measures.size()) +
             " quantities; a study measures up to " + std::to_string(kMaxMeasures));
}

std::string measuresText(const std::vector<Measure>& measures) {
  return listText(measures, [](Measure one) { return tomlString(nameOf(one)); });
}

}  // namespace

Keys<StudySettings> studyKeys() {
  static constexpr std::array keys{
      valueAxis<&StudySettings::x>(
          "x", {.meaning = "the key that each run has another value of, see [axes](vary.md#axes)",
                .byDefault = "`simulation.substeps`, 1, 2, 4 ... 1024"}),
      valueAxis<&StudySettings::curves>(
          "curves", {.meaning = "a second key: one curve for each of its values",
                     .byDefault = "without `measure`, all of the model's integrators"}),
      key<&StudySettings::measures, measuresFrom, measuresText>(
          "measure", listForm(kExpectedMeasures, kMeasureForm),
          {.meaning = "one to three of the [measures](map.md#measures)",
           .byDefault = "`[\"order\"]`"}),
      placedExpectations<&StudySettings::expected, kStudyExpectations>(
          "expect",
          {.meaning = "[bounds](vary.md#expectations) on all runs, or on those with an `x` or on a "
                      "`curve`",
           .byDefault = "none",
           .affects = Affects::Text}),
      number<&StudySettings::duration>("duration", kPositiveTime,
                                       {.comment = "s, length of the motions",
                                        .meaning = "length of the motions, whatever the clip's",
                                        .byDefault = "the clip's"}),
      number<&StudySettings::interval>("interval", kPositiveTime,
                                       {.comment = "s from sample to sample",
                                        .meaning = "time from sample to sample, whatever the steps",
                                        .byDefault = "that from frame to frame"}),
  };
  return keys;
}

}  // namespace rotatebook::scene
