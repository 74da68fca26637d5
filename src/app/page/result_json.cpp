#include "page/result_json.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "page/figure.h"

namespace rotatebook::page {
namespace {

using Limits = std::numeric_limits<double>;

/// Returns the measure called `name`. Throws InputError if there is none.
scene::Measure measureIn(const Json& name) {
  const auto text = name.get<std::string>();
  const auto row = std::ranges::find(scene::kMeasureRows, text, &scene::MeasureRow::name);
  if (row == scene::kMeasureRows.end()) throw InputError("no measure is called " + text);
  return row->measure;
}

Check boundCheckIn(const Json& expected) {
  const Json& measured = expected.at("measured");
  const double value = measured.is_null()  ? Limits::quiet_NaN()
                       : measured == "inf" ? Limits::infinity()
                                           : measured.get<double>();
  return checkOf(expected.at("quantity").get<std::string>(),
                 {numberIn(expected, "min"), numberIn(expected, "max")}, value,
                 expected.at("meaning").get<std::string>());
}

}  // namespace

std::optional<double> numberIn(const Json& object, const char* key) {
  const Json& number = object.at(key);
  return number.is_null() ? std::nullopt : std::optional(number.get<double>());
}

scene::ExpectationResult expectationIn(const Json& expected) {
  const scene::Expectation expectation{
      .measure = measureIn(expected.at("quantity")),
      .min = numberIn(expected, "min"),
      .max = numberIn(expected, "max"),
      .risesTo = numberIn(expected, "rises_to"),
      .fallsTo = numberIn(expected, "falls_to"),
      .from = expected.at("from_s").get<double>(),
      .to = numberIn(expected, "to_s").value_or(Limits::infinity())};
  // A motion that never does what is measured has neither
  const double none =
      expectation.measure == scene::Measure::DivergesAt ? Limits::infinity() : Limits::quiet_NaN();
  return {expectation, numberIn(expected, "lowest").value_or(none),
          numberIn(expected, "highest").value_or(none), expected.at("met").get<bool>(),
          numberIn(expected, "ends_early_s")};
}

std::vector<Check> readChecks(const std::filesystem::path& file, const scene::Scene& scene,
                              const std::string& sceneChecksum, const std::string& command,
                              const std::string& again) {
  const auto checks = readResult<std::vector<Check>>(file, sceneChecksum, [](const Json& result) {
    std::vector<Check> all;
    for (const Json& expected : result.at("expectations")) all.push_back(boundCheckIn(expected));
    return all;
  });
  if (checks) return *checks;
  throw InputError(fmt::format(
      "{} isn't the result of the scene's {}; {} (or give this command the same --set): {}",
      file.string(), command, again, remedy(command, scene, file.parent_path())));
}

}  // namespace rotatebook::page
