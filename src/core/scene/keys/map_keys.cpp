// The keys of [map]: which runs to make, and how they are drawn.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "scene/keys/axis_keys.h"
#include "scene/keys/expectation_keys.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::kNumber;
using document::kPositive;
using document::kPositiveTime;

constexpr const char* kExpectedSize = "numbers of runs across and up, such as [960, 540]";
constexpr const char* kExpectedColours =
    "a table such as { palette = \"inferno\", from = 0, to = 180 }";
constexpr const char* kExpectedMarks = "tables such as { at = [0.5, 1], label = \"book\" }";
constexpr const char* kExpectedMapBounds =
    "tables such as { of = \"share\", outcome = \"diverged\", max = 0.5 }";
constexpr const char* kExpectedPoint = "a value on x and one on y, such as [0.5, 1]";
constexpr const char* kExpectedMoments = "three moments of inertia, such as [1.0, 3.1, 3.2]";
constexpr const char* kExpectedFilm =
    "a table such as { x = [2, 3], y = [0.1, 0.2], duration = 10 }";
constexpr const char* kExpectedEnds = "the first and the last value of an axis, such as [2, 3]";
constexpr const char* kExpectedContours = "a list of values, such as [0.25, 0.5]";
constexpr int kMinSide = 2;
constexpr std::size_t kMaxMarks = 50;

constexpr NumberRange kFilmTimes{"a time from 0.1 to 600 s", 0.1, 600, Dimension::Time};

constexpr std::array<Named<Palette>, 4> kPalettes{{{"inferno", Palette::Inferno},
                                                   {"viridis", Palette::Viridis},
                                                   {"gray", Palette::Gray},
                                                   {"coolwarm", Palette::Coolwarm}}};
using Of = MapExpectation::Of;
constexpr std::array<Named<Of>, 5> kOfs{{{"smallest", Of::Smallest},
                                         {"largest", Of::Largest},
                                         {"mean", Of::Mean},
                                         {"share", Of::Share},
                                         {"value", Of::Value}}};
constexpr ValueForm kNumberForm = formOf(ValueForm::Type::Number, kNumber);
constexpr ValueForm kMomentForm = formOf(ValueForm::Type::Number, kPositive);
constexpr ValueForm kSideForm = integerForm(kMinSide, kMaxMapSide);

void readSize(const ValueReader& value, MapSettings& map) {
  const auto sides = value.elements(2, kExpectedSize);
  std::vector<int> read;
  readEach(sides,
           [&](const ValueReader& side) { read.push_back(side.integer(kMinSide, kMaxMapSide)); });
  map.width = read[0];
  map.height = read[1];
}

std::vector<double> numbersFrom(const ValueReader& value, std::size_t count, const char* expected,
                                const NumberRange& range = kNumber) {
  std::vector<double> numbers;
  readEach(value.elements(count, expected),
           [&](const ValueReader& one) { numbers.push_back(one.number(range)); });
  return numbers;
}

std::string numbersText(const std::vector<double>& numbers) {
  return listText(numbers, tomlNumber);
}

/// Returns the list; nothing of an empty one.
std::string numbersIfAny(const std::vector<double>& numbers) {
  return numbers.empty() ? "" : numbersText(numbers);
}

std::string trueOrNothing(bool flag) {
  return flag ? "true" : "";
}

std::vector<double> contoursFrom(const ValueReader& value) {
  std::vector<double> contours;
  readEach(value.list(kExpectedContours),
           [&](const ValueReader& one) { contours.push_back(one.number(kNumber)); });
  return contours;
}

Keys<MapColours> colourKeys() {
  static constexpr std::array keys{
      choice<&MapColours::palette, kPalettes>("palette"),
      own<&MapColours::reversed, flagFrom, trueOrNothing>("reversed", {.flag = true}, kFlags),
      choice<&MapColours::scale, kScales>("scale"),
      number<&MapColours::from>("from", kNumber),
      number<&MapColours::to>("to", kNumber),
      key<&MapColours::contours, contoursFrom, numbersIfAny>(
          "contours", listForm(kExpectedContours, kNumberForm)),
  };
  return keys;
}

MapColours coloursFrom(const ValueReader& table) {
  MapColours colours;
  readKeys(table, colourKeys(), colours);
  if (colours.from && colours.to && !(*colours.from < *colours.to)) {
    table.find("from")->fail(
        table.name() + " runs from " + tomlNumber(*colours.from) + " to " +
        tomlNumber(*colours.to) +
        "; from must be less than to; reversed = true turns the colours round");
  }
  const bool isLogarithmic = colours.scale == Scale::Logarithmic;
  for (const char* end : {"from", "to"}) {
    const auto value = table.find(end);
    if (!isLogarithmic || !value || value->number(kNumber) > 0) continue;
    value->fail(table.name() + " is logarithmic, which needs " + end + " over 0");
  }
  return colours;
}

std::string coloursText(const MapColours& all) {
  return inlineTable(colourKeys(), all);
}

std::vector<double> endsFrom(const ValueReader& value) {
  return numbersFrom(value, 2, kExpectedEnds);
}

std::vector<double> pointFrom(const ValueReader& value) {
  return numbersFrom(value, 2, kExpectedPoint);
}

Keys<MapFilm> filmKeys() {
  static constexpr std::array keys{
      key<&MapFilm::x, endsFrom, numbersIfAny>("x", listForm(kExpectedEnds, kNumberForm, 2)),
      key<&MapFilm::y, endsFrom, numbersIfAny>("y", listForm(kExpectedEnds, kNumberForm, 2)),
      number<&MapFilm::duration>("duration", kFilmTimes),
  };
  return keys;
}

MapFilm filmFrom(const ValueReader& table) {
  MapFilm one;
  readKeys(table, filmKeys(), one);
  return one;
}

std::string filmText(const MapFilm& one) {
  return inlineTable(filmKeys(), one);
}

void readPlace(const ValueReader& value, MapMark& mark) {
  const auto point = pointFrom(value);
  mark.x = point[0];
  mark.y = point[1];
}

std::string placeText(const MapMark& mark) {
  return mark.moments ? "" : numbersText({mark.x, mark.y});
}

std::vector<double> inertiaFrom(const ValueReader& value) {
  return numbersFrom(value, 3, kExpectedMoments, kPositive);
}

Keys<MapMark> markKeys() {
  static constexpr std::array keys{
      keyOf<MapMark, readPlace, placeText>("at", listForm(kExpectedPoint, kNumberForm, 2),
                                           {.byDefault = "none"}),
      key<&MapMark::moments, inertiaFrom, numbersText>("moments",
                                                       listForm(kExpectedMoments, kMomentForm, 3)),
      text<&MapMark::label>("label", kLongestLabel, {.byDefault = "required"}),
  };
  return keys;
}

MapMark markFrom(const ValueReader& table) {
  MapMark mark;
  readKeys(table, markKeys(), mark);
  if (!table.find("label")) table.fail(table.name() + " needs a label");
  if (table.find("at").has_value() == mark.moments.has_value()) {
    table.fail(table.name() + " needs either at, a point, or moments, whose ratios are one");
  }
  return mark;
}

std::string markText(const MapMark& mark) {
  return inlineTable(markKeys(), mark);
}

std::vector<MapMark> marksFrom(const ValueReader& value) {
  auto all = tablesFrom(value, kExpectedMarks, markFrom);
  if (all.size() <= kMaxMarks) return all;
  value.fail(value.name() + " has " + std::to_string(all.size()) + " points; the limit is " +
             std::to_string(kMaxMarks));
}

std::string marksText(const std::vector<MapMark>& all) {
  return tablesText(all, markText);
}

Keys<MapExpectation> expectationKeys() {
  static constexpr std::array keys{
      choice<&MapExpectation::of, kOfs>("of", {.byDefault = "required"}),
      choice<&MapExpectation::outcome, kOutcomes>("outcome"),
      number<&MapExpectation::over>("over", kNumber),
      number<&MapExpectation::under>("under", kNumber),
      key<&MapExpectation::at, pointFrom, numbersText>("at",
                                                       listForm(kExpectedPoint, kNumberForm, 2)),
      text<&MapExpectation::panel>("panel", kLongestLabel),
  };
  return keys;
}

std::vector<KeyRow> mapExpectationRows() {
  std::vector<KeyRow> rows = membersOf<expectationKeys>();
  for (KeyRow& row : membersOf<boundKeys>()) rows.push_back(std::move(row));
  return rows;
}

MapExpectation mapExpectationFrom(const ValueReader& table) {
  MapExpectation one;
  std::vector<Field> fields = fieldsInto(one, expectationKeys());
  for (Field& bound : fieldsInto(one.bounds, boundKeys())) fields.push_back(std::move(bound));
  table.readTable(fields);
  requireKeys(table, {"of"});
  const bool isShare = one.of == Of::Share, isValue = one.of == Of::Value;
  if (isShare != (one.outcome || one.over || one.under)) {
    table.fail(table.name() + (isShare ? " is of a share, so it needs outcome, over or under"
                                       : " has outcome, over or under, which are of a share"));
  }
  if (isValue != one.at.has_value()) {
    table.fail(table.name() + (isValue ? " is of a value, so it needs at = [X, Y]"
                                       : " has at, which is of a value"));
  }
  checkBounds(table, one.bounds);
  return one;
}

std::string mapExpectationText(const MapExpectation& one) {
  const std::string start = inlineTable(expectationKeys(), one);
  return start.substr(0, start.size() - 2) + ", " + inlineTable(boundKeys(), one.bounds).substr(2);
}

std::vector<MapExpectation> mapExpectationsFrom(const ValueReader& value) {
  return tablesFrom(value, kExpectedMapBounds, mapExpectationFrom);
}

std::string mapExpectationsText(const std::vector<MapExpectation>& all) {
  return tablesText(all, mapExpectationText);
}

Measure mapMeasureFrom(const ValueReader& value) {
  return measureFrom(value, MeasureSections::Runs);
}

std::string measureText(Measure measure) {
  return tomlString(nameOf(measure));
}

std::string mapSizeText(const MapSettings& map) {
  return "[" + std::to_string(map.width) + ", " + std::to_string(map.height) + "]";
}

}  // namespace

Keys<MapSettings> mapKeys() {
  static constexpr std::array keys{
      pixelAxis<&MapSettings::x>(
          "x", {.meaning = "the axis across, see [axes](vary.md#axes)", .byDefault = "required"}),
      pixelAxis<&MapSettings::y>("y",
                                 {.meaning = "the axis up, likewise", .byDefault = "required"}),
      key<&MapSettings::measure, mapMeasureFrom, measureText>(
          "measure",
          {.type = ValueForm::Type::Choice, .choices = measureNames(MeasureSections::Runs)},
          {.comment = "what the colours show",
           .meaning = "what the colours show, see [maps](map.md#measures)",
           .byDefault = "required",
           .allowed = "a quantity, such as \"half_turns\""}),
      choice<&MapSettings::moment, kMapMoments>(
          "moment", {.meaning = "at the end of each motion, or the largest value on the way"}),
      keyOf<MapSettings, readSize, mapSizeText>(
          "size", listForm(kExpectedSize, kSideForm, 2),
          {.comment = "runs, each a pixel",
           .meaning = "runs across and up, each a pixel, up to 16384 a side"}),
      number<&MapSettings::duration>("duration", kPositiveTime,
                                     {.comment = "s, length of the motions",
                                      .meaning = "length of the motions, whatever the clip's",
                                      .byDefault = "the clip's"}),
      number<&MapSettings::interval>(
          "interval", kPositiveTime,
          {.comment = "s from look to look",
           .meaning = "time from one look at a motion to the next, whatever its steps",
           .byDefault = "that from frame to frame"}),
      key<&MapSettings::colours, coloursFrom, coloursText>(
          "colors", tableForm(kTableKind, kExpectedColours, membersOf<colourKeys>),
          {.meaning =
               "the colours, and the values of the first and the last; see [maps](map.md#colours)",
           .byDefault = "`{ palette = \"inferno\", scale = \"linear\" }`",
           .affects = Affects::Picture}),
      key<&MapSettings::marks, marksFrom, marksText>(
          "marks", tableForm(kListKind, kExpectedMarks, membersOf<markKeys>),
          {.meaning = "points to mark, each with its value; see [maps](map.md#colours)",
           .byDefault = "none",
           .affects = Affects::Picture}),
      key<&MapSettings::expected, mapExpectationsFrom, mapExpectationsText>(
          "expect", tableForm(kListKind, kExpectedMapBounds, mapExpectationRows),
          {.meaning = "bounds on the smallest, largest or mean value, a share of the runs or one "
                      "value; see [expectations](vary.md#expectations)",
           .byDefault = "none",
           .affects = Affects::Text}),
      key<&MapSettings::film, filmFrom, filmText>(
          "film", tableForm(kTableKind, kExpectedFilm, membersOf<filmKeys>),
          {.meaning = "the part of the map that `rotatebook map --film` zooms into, and the "
                      "film's length; see [maps](map.md#films)",
           .byDefault = "none",
           .affects = Affects::Picture}),
  };
  return keys;
}

}  // namespace rotatebook::scene
