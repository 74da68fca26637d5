#include "scene/keys/recorded_keys.h"

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "base/text.h"
#include "recording/columns.h"
#include "recording/read_options.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;
using physics::RecordedFile;
using physics::SimulationSettings;

constexpr NumberRange kBias{"three numbers from -1e3 to 1e3", -1e3, 1e3};
constexpr NumberRange kFileTimes{"a time", std::numeric_limits<double>::lowest(),
                                 std::numeric_limits<double>::max(), Dimension::Time};

using Columns = std::vector<std::pair<std::string, std::string>>;

Columns columnsFrom(const ValueReader& value) {
  Columns columns;
  std::vector<Field> fields;
  for (const std::string_view role : recording::columnRoles()) {
    fields.push_back({role, [&columns, role](const ValueReader& name) {
                        columns.emplace_back(role, name.text(kLongestName));
                      }});
  }
  value.readTable(fields);
  return columns;
}

std::string columnsText(const Columns& columns) {
  if (columns.empty()) return "";
  const auto text = [](const auto& one) { return one.first + " = " + tomlString(one.second); };
  return "{ " + joinedOf(columns, text) + " }";
}

/// Reads one of a few words.
template <const auto& kWords>
std::string wordFrom(const ValueReader& value) {
  return std::string(kWords[value.choice(kWords)]);
}

std::string biasText(const Eigen::Vector3d& bias) {
  return bias.isZero(0) ? "" : vectorText(bias);
}

/// A member of the recording that a motion is taken from.
template <auto kMember>
constexpr Within<&SimulationSettings::recorded, kMember> kRecorded{};

/// One of a few words; none is printed as nothing.
template <auto kMember, const auto& kWords>
constexpr auto word(std::string_view name, const char* expected, const KeyText& documentation) {
  return own<kRecorded<kMember>, wordFrom<kWords>, optionalText>(name, kTextKind, expected,
                                                                 documentation);
}

/// A text, of which an empty one isn't printed.
template <auto kMember>
constexpr auto optional(std::string_view name, std::size_t most, const KeyText& documentation) {
  return key<kRecorded<kMember>, textFrom, optionalText>(name, textForm(most), documentation);
}

}  // namespace

Keys<SimulationSettings> recordedKeys() {
  static constexpr auto keys = allOf(
      kOfRecorded,
      std::array{
          optional<&RecordedFile::file>(
              "file", kLongestPath,
              {.meaning = "a table (CSV), see [recorded motion](recorded.md)",
               .byDefault = "required for `\"recorded\"`",
               .allowed = "a path relative to the scene's folder"}),
          own<kRecorded<&RecordedFile::columns>, columnsFrom, columnsText>(
              "columns", kTableKind, "a table such as { time = \"t\", wx = \"Gyro X\" }",
              {.meaning = "the names of columns without a usual one",
               .byDefault = "[usual names](recorded.md#columns)"}),
          word<&RecordedFile::timeUnit, recording::kTimeUnits>(
              "time_unit", "\"s\", \"ms\", \"us\", \"ns\" or \"min\"",
              {.meaning = "the unit of the file's times", .byDefault = "the header's"}),
          word<&RecordedFile::rates, recording::kRateUnits>(
              "rates", "\"rad/s\" or \"deg/s\"",
              {.meaning = "the unit of a gyroscope's rates", .byDefault = "the header's"}),
          word<&RecordedFile::ratesAlong, recording::kRateAxes>(
              "rates_along", "\"world\" or \"body\"",
              {.meaning = "whose axes the rates beside attitudes are along",
               .byDefault = "`\"body\"` for a gyroscope's columns, `\"world\"` for others"}),
          number<kRecorded<&RecordedFile::from>>(
              "from", kFileTimes,
              {.meaning = "where the motion starts, of the file's times",
               .byDefault = "the first row"}),
          number<kRecorded<&RecordedFile::to>>(
              "to", kFileTimes,
              {.meaning = "where it ends, likewise", .byDefault = "the last row"}),
          key<kRecorded<&RecordedFile::bias>, vectorOf, biasText>(
              "bias",
              {.min = kBias.min, .max = kBias.max, .expected = kBias.expected, .kinds = kListKind},
              {.meaning = "subtracted from a gyroscope's rates",
               .byDefault = "none",
               .unit = "rad/s"}),
          optional<&RecordedFile::checksum>("checksum", kLongestName,
                                            {.meaning = "XXH128 of the file, which must have it",
                                             .byDefault = "that of the file",
                                             .allowed = "32 hexadecimal digits"}),
      });
  return keys;
}

}  // namespace rotatebook::scene
