// The measures of a motion: the one list from which expectations, studies, grids and maps
// take.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "physics/motion_settings.h"
#include "physics/trajectory.h"

namespace rotatebook::scene {

/// A measure of a motion. Each has a row in measure_list.inc.
enum class Measure {
#define ROTATEBOOK_MEASURE(enumerator, ...) enumerator,
#include "scene/measure_list.inc"
#undef ROTATEBOOK_MEASURE
};

/// The sections that take a measure; each takes those of the ones before it, too.
enum class MeasureSections {
  All,      ///< [expect], [study], [grid] and [map].
  Runs,     ///< [study] and [map].
  Studies,  ///< [study] alone.
};

/// The time that a measure is of.
enum class MeasureSpan {
  Moment,  ///< It has a value at each moment.
  Motion,  ///< It is of a whole motion.
};

/// The models whose motions have the measure.
enum class MeasureModels {
  All,
  Stepwise,   ///< All but Model::Exact: it measures an error of steps.
  Particles,  ///< Model::Particles alone.
};

/// A row of measure_list.inc.
struct MeasureRow {
  Measure measure = Measure::HalfTurns;
  std::string_view name;  ///< In a scene, e.g. "half_turns".
  MeasureSections sections = MeasureSections::All;
  MeasureSpan span = MeasureSpan::Moment;
  MeasureModels models = MeasureModels::All;
  double rest = 0;           ///< The value from which studies measure: 1 of ratios and the stretch.
  std::string_view meaning;  ///< In Markdown, with the unit.
  std::string_view label;    ///< Beside a map's colours, with the unit.
  std::string_view studied;  ///< On a study's axis, with the unit.
};

/// The rows, in the order of Measure.
inline constexpr std::array kMeasureRows{
#define ROTATEBOOK_MEASURE(enumerator, name, sections, span, models, ...)                     \
  MeasureRow{Measure::enumerator,   name,       MeasureSections::sections, MeasureSpan::span, \
             MeasureModels::models, __VA_ARGS__},
#include "scene/measure_list.inc"
#undef ROTATEBOOK_MEASURE
};

/// Returns the row of `measure`.
constexpr const MeasureRow& rowOf(Measure measure) {
  return kMeasureRows[static_cast<std::size_t>(measure)];
}

/// Returns the name of `measure` in a scene.
constexpr std::string_view nameOf(Measure measure) {
  return rowOf(measure).name;
}

/// The names of all measures, in the order of the rows.
inline constexpr auto kMeasureNames = [] {
  std::array<std::string_view, kMeasureRows.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kMeasureRows[i].name;
  return names;
}();
static_assert(std::ranges::is_sorted(kMeasureRows, {}, &MeasureRow::sections));

/// Returns the names of the measures that `sections` take, in the order of the rows.
constexpr std::span<const std::string_view> measureNames(MeasureSections sections) {
  const auto takes = [=](const MeasureRow& row) { return row.sections <= sections; };
  return std::span(kMeasureNames).first(std::ranges::count_if(kMeasureRows, takes));
}

/// The measures that [expect] and [grid] take, in the order of the rows.
inline constexpr auto kMeasuresOfMotions = [] {
  constexpr auto isOne = [](const MeasureRow& row) { return row.sections == MeasureSections::All; };
  std::array<Measure, std::ranges::count_if(kMeasureRows, isOne)> all{};
  std::size_t count = 0;
  for (const MeasureRow& row : kMeasureRows) {
    if (isOne(row)) all[count++] = row.measure;
  }
  return all;
}();

/// Returns why motions of `model` have no such measure; empty if they have.
std::string reasonForAbsence(Measure measure, physics::Model model);

/// The lowest and the highest value of a measure; NaN of nothing.
struct MeasuredRange {
  double lowest = std::numeric_limits<double>::quiet_NaN();
  double highest = lowest;
};

/// Returns the values of `measure` on one sample of a motion whose first sample is `start`; they
/// differ for the stretch alone. Half-turns are those made so far. A measure of a whole motion is
/// NaN.
MeasuredRange rangeOn(const physics::Sample& sample, const physics::Sample& start, Measure measure);

/// Returns the one of rangeOn() that is farther from the measure's rest.
double valueOn(const physics::Sample& sample, const physics::Sample& start, Measure measure);

}  // namespace rotatebook::scene
