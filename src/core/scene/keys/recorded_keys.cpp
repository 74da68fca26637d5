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

/// Texts of which an empty one isn't printed.
Kind<std::string> optionalText(std::string (*read)(const ValueReader&), std::string allowed) {
  return {read, [](const std::string& one) { return one.empty() ? "" : tomlString(one); },
          std::move(allowed)};
}

/// Returns a key of the recording that a motion is taken from.
template <typename Field, typename T>
Key<SimulationSettings> recordedKey(std::string_view name, Field field, const Kind<T>& kind,
                                    KeyText documentation) {
  documentation.models = kOfRecorded;
  return keyAt<SimulationSettings>(
      name, [field](auto& settings) -> auto& { return settings.recorded.*field; }, kind,
      std::move(documentation));
}

}  // namespace

const Keys<SimulationSettings>& recordedKeys() {
  static const Keys<SimulationSettings> keys{
      recordedKey("file", &RecordedFile::file,
                  optionalText([](const ValueReader& value) { return value.text(kLongestPath); },
                               "a path relative to the scene's folder"),
                  {.meaning = "a table (CSV), see [recorded motion](recorded.md)",
                   .byDefault = "required for `\"recorded\"`"}),
      recordedKey("columns", &RecordedFile::columns,
                  Kind<Columns>{columnsFrom, columnsText,
                                "a table such as { time = \"t\", wx = \"Gyro X\" }"},
                  {.meaning = "the names of columns without a usual one",
                   .byDefault = "[usual names](recorded.md#columns)"}),
      recordedKey(
          "time_unit", &RecordedFile::timeUnit,
          optionalText(wordFrom<recording::kTimeUnits>, "\"s\", \"ms\", \"us\", \"ns\" or \"min\""),
          {.meaning = "the unit of the file's times", .byDefault = "the header's"}),
      recordedKey("rates", &RecordedFile::rates,
                  optionalText(wordFrom<recording::kRateUnits>, "\"rad/s\" or \"deg/s\""),
                  {.meaning = "the unit of a gyroscope's rates", .byDefault = "the header's"}),
      recordedKey("rates_along", &RecordedFile::ratesAlong,
                  optionalText(wordFrom<recording::kRateAxes>, "\"world\" or \"body\""),
                  {.meaning = "whose axes the rates beside attitudes are along",
                   .byDefault = "`\"body\"` for a gyroscope's columns, `\"world\"` for others"}),
      recordedKey("from", &RecordedFile::from, number(kFileTimes),
                  {.meaning = "where the motion starts, of the file's times",
                   .byDefault = "the first row"}),
      recordedKey("to", &RecordedFile::to, number(kFileTimes),
                  {.meaning = "where it ends, likewise", .byDefault = "the last row"}),
      recordedKey(
          "bias", &RecordedFile::bias,
          Kind<Eigen::Vector3d>{
              [](const ValueReader& value) { return vectorFrom(value, kBias); },
              [](const Eigen::Vector3d& bias) { return bias.isZero(0) ? "" : vectorText(bias); },
              std::string(kBias.expected)},
          {.meaning = "subtracted from a gyroscope's rates", .byDefault = "none", .unit = "rad/s"}),
      recordedKey(
          "checksum", &RecordedFile::checksum,
          optionalText([](const ValueReader& value) { return value.text(kLongestName); },
                       "32 hexadecimal digits"),
          {.meaning = "XXH128 of the file, which must have it", .byDefault = "that of the file"}),
  };
  return keys;
}

}  // namespace rotatebook::scene
