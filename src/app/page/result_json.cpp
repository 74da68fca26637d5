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

/// Returns what a study or a map expects something of, such as "first_flip at 1e-05" or "share
/// never, of exact": names of measures and values stay, the words between are said.
std::string subjectIn(std::string text, const Language& say) {
  const std::pair<std::string_view, std::string> parts[]{
      {"smallest value", say("smallest value")},
      {"largest value", say("largest value")},
      {"mean value", say("mean value")},
      {"value at ", say("value at ")},
      {"share with a value", say("share with a value")},
      {"share never", say("share never")},
      {"share diverged", say("share diverged")},
      {"share refused", say("share refused")},
      {"share", say("share")},
      {" over ", say(" over ")},
      {" and under ", say(" and under ")},
      {" under ", say(" under ")},
      {" at ", say(" at ")},
      {" of ", say(" of ")},
  };
  for (const auto& [english, said] : parts) {
    const std::size_t at = text.find(english);
    const bool isFirst = english.front() != ' ';
    if (at != text.npos && (!isFirst || at == 0)) text.replace(at, english.size(), said);
  }
  return say.numbers(text);
}

Check boundCheckIn(const Json& expected, const Language& say) {
  const Json& measured = expected.at("measured");
  const double value = measured.is_null()  ? Limits::quiet_NaN()
                       : measured == "inf" ? Limits::infinity()
                                           : measured.get<double>();
  return checkOf(subjectIn(expected.at("quantity").get<std::string>(), say),
                 {numberIn(expected, "min"), numberIn(expected, "max")}, value,
                 expected.at("meaning").get<std::string>(), say);
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
                              const std::string& again, const Language& say) {
  const auto checks = readResult<std::vector<Check>>(file, sceneChecksum, [&](const Json& result) {
    std::vector<Check> all;
    for (const Json& expected : result.at("expectations"))
      all.push_back(boundCheckIn(expected, say));
    return all;
  });
  if (checks) return *checks;
  throw InputError(fmt::format(
      "{} isn't the result of the scene's {}; {} (or give this command the same --set): {}",
      file.string(), command, again, remedy(command, scene, file.parent_path())));
}

}  // namespace rotatebook::page
