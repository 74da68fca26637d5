// The keys of [map]: which runs to make, and how they are drawn.
#include <algorithm>
#include <array>
#include <string>
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
constexpr NumberRange kMapTimes{kPositive.expected, kPositive.min, kPositive.max, Dimension::Time};

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

const Keys<MapColours>& colourKeys() {
  static const Keys<MapColours> keys{
      key("palette", &MapColours::palette, oneOf(kPalettes)),
      {"reversed",
       [](const ValueReader& value, MapColours& colours) {
         const bool* flag = std::get_if<bool>(&value.node().value);
         if (flag == nullptr) value.mismatch("true or false");
         colours.reversed = *flag;
       },
       [](const MapColours& colours) { return colours.reversed ? "true" : ""; },
       {}},
      key("scale", &MapColours::scale, oneOf(kScales)),
      key("from", &MapColours::from, number(kNumber)),
      key("to", &MapColours::to, number(kNumber)),
      {"contours",
       [](const ValueReader& value, MapColours& colours) {
         readEach(value.list(kExpectedContours),
                  [&](const ValueReader& one) { colours.contours.push_back(one.number(kNumber)); });
       },
       [](const MapColours& colours) {
         return colours.contours.empty() ? "" : numbersText(colours.contours);
       },
       {}},
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

Kind<std::vector<double>> ends() {
  return {[](const ValueReader& value) { return numbersFrom(value, 2, kExpectedEnds); },
          [](const std::vector<double>& all) { return all.empty() ? "" : numbersText(all); },
          kExpectedEnds};
}

const Keys<MapFilm>& filmKeys() {
  static const Keys<MapFilm> keys{
      key("x", &MapFilm::x, ends()),
      key("y", &MapFilm::y, ends()),
      key("duration", &MapFilm::duration, number(kFilmTimes)),
  };
  return keys;
}

Kind<MapFilm> film() {
  return {[](const ValueReader& table) {
            MapFilm one;
            readKeys(table, filmKeys(), one);
            return one;
          },
          [](const MapFilm& one) { return inlineTable(filmKeys(), one); }, kExpectedFilm};
}

MapMark markFrom(const ValueReader& table) {
  MapMark mark;
  table.readTable(
      {{"at",
        [&](const ValueReader& value) {
          const auto point = numbersFrom(value, 2, kExpectedPoint);
          mark.x = point[0];
          mark.y = point[1];
        }},
       {"moments",
        [&](const ValueReader& value) {
          mark.moments = numbersFrom(value, 3, kExpectedMoments, kPositive);
        }},
       {"label", [&](const ValueReader& value) { mark.label = value.text(kLongestLabel); }}});
  if (!table.find("label")) table.fail(table.name() + " needs a label");
  if (table.find("at").has_value() == mark.moments.has_value()) {
    table.fail(table.name() + " needs either at, a point, or moments, whose ratios are one");
  }
  return mark;
}

std::string markText(const MapMark& mark) {
  const std::string place = mark.moments ? "moments = " + numbersText(*mark.moments)
                                         : "at = " + numbersText({mark.x, mark.y});
  return "{ " + place + ", label = " + tomlString(mark.label) + " }";
}

Kind<std::vector<MapMark>> marks() {
  auto kind = tables<MapMark>(markFrom, markText, kExpectedMarks);
  kind.read = [read = kind.read](const ValueReader& value) {
    auto all = read(value);
    if (all.size() <= kMaxMarks) return all;
    value.fail(value.name() + " has " + std::to_string(all.size()) + " points; the limit is " +
               std::to_string(kMaxMarks));
  };
  return kind;
}

const Keys<MapExpectation>& expectationKeys() {
  static const Keys<MapExpectation> keys{
      key("of", &MapExpectation::of, oneOf(kOfs)),
      key("outcome", &MapExpectation::outcome, oneOf(kOutcomes)),
      key("over", &MapExpectation::over, number(kNumber)),
      key("under", &MapExpectation::under, number(kNumber)),
      key("at", &MapExpectation::at,
          Kind<std::vector<double>>{
              [](const ValueReader& value) { return numbersFrom(value, 2, kExpectedPoint); },
              numbersText,
              kExpectedPoint,
              {}}),
      key("panel", &MapExpectation::panel, text(kLongestLabel)),
  };
  return keys;
}

MapExpectation mapExpectationFrom(const ValueReader& table) {
  MapExpectation one;
  std::vector<Field> fields = fieldsOf(
      expectationKeys(),
      [&](const Key<MapExpectation>& key, const ValueReader& value) { key.read(value, one); });
  for (Field& bound : fieldsOf(boundKeys(), [&](const Key<Bounds>&key, const ValueReader&value) {
         key.read(value, one.bounds);
       })) {
    fields.push_back(std::move(bound));
  }
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

}  // namespace

const Keys<MapSettings>& mapKeys() {
  static const Keys<MapSettings> keys{
      key("x", &MapSettings::x, pixelAxis(),
          {.meaning = "the axis across, see [axes](vary.md#axes)", .byDefault = "required"}),
      key("y", &MapSettings::y, pixelAxis(),
          {.meaning = "the axis up, likewise", .byDefault = "required"}),
      {"measure",
       [](const ValueReader& value, MapSettings& map) {
         map.measure = measureFrom(value, MeasureSections::Runs);
       },
       [](const MapSettings& map) { return tomlString(nameOf(map.measure)); },
       {.meaning = "what the colours show, see [maps](map.md#measures)",
        .byDefault = "required",
        .allowed = "a quantity, such as \"half_turns\""}},
      key("moment", &MapSettings::moment, oneOf(kMapMoments),
          {.meaning = "at the end of each motion, or the largest value on the way"}),
      {"size",
       readSize,
       [](const MapSettings& map) {
         return "[" + std::to_string(map.width) + ", " + std::to_string(map.height) + "]";
       },
       {.comment = "runs, each a pixel",
        .meaning = "runs across and up, each a pixel, up to 16384 a side",
        .allowed = kExpectedSize}},
      key("duration", &MapSettings::duration, number(kMapTimes),
          {.comment = "s, length of the motions",
           .meaning = "length of the motions, whatever the clip's",
           .byDefault = "the clip's"}),
      key("interval", &MapSettings::interval, number(kMapTimes),
          {.comment = "s from look to look",
           .meaning = "time from one look at a motion to the next, whatever its steps",
           .byDefault = "that from frame to frame"}),
      key("colors", &MapSettings::colours,
          Kind<MapColours>{coloursFrom,
                           [](const MapColours& all) { return inlineTable(colourKeys(), all); },
                           kExpectedColours,
                           {}},
          {.meaning =
               "the colours, and the values of the first and the last; see [maps](map.md#colours)",
           .byDefault = "`{ palette = \"inferno\", scale = \"linear\" }`",
           .affects = Affects::Picture}),
      key("marks", &MapSettings::marks, marks(),
          {.meaning = "points to mark, each with its value; see [maps](map.md#colours)",
           .byDefault = "none",
           .affects = Affects::Picture}),
      key("expect", &MapSettings::expected,
          tables<MapExpectation>(mapExpectationFrom, mapExpectationText, kExpectedMapBounds),
          {.meaning = "bounds on the smallest, largest or mean value, a share of the runs or one "
                      "value; see [expectations](vary.md#expectations)",
           .byDefault = "none",
           .affects = Affects::Text}),
      key("film", &MapSettings::film, film(),
          {.meaning = "the part of the map that `rotatebook map --film` zooms into, and the "
                      "film's length; see [maps](map.md#films)",
           .byDefault = "none",
           .affects = Affects::Picture}),
  };
  return keys;
}

}  // namespace rotatebook::scene
