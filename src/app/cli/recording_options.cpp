#include "cli/recording_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/parsed_number.h"
#include "base/text.h"
#include "recording/columns.h"

namespace rotatebook::cli {

void RecordingOptions::addTo(CLI::App& command) {
  constexpr const char* kGroup = "Recording";
  command.add_option("--from", options.from, "Where the motion starts, of the file's times")
      ->type_name("SECONDS")
      ->group(kGroup);
  command.add_option("--to", options.to, "Where it ends, likewise")
      ->type_name("SECONDS")
      ->group(kGroup);
  command
      .add_option("--rates", options.unit,
                  "Unit of a gyroscope's rates, rad/s or deg/s, if the header has none")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"rad/s", "deg/s"}))
      ->group(kGroup);
  command
      .add_option("--time-unit", options.timeUnit,
                  "Unit of the file's times, s, ms, us, ns or min, if the header has none")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"s", "ms", "us", "ns", "min"}))
      ->group(kGroup);
  command
      .add_option("--column", columns,
                  "A column without a usual name, e.g. --column \"wx=Gyro X\"; may be repeated")
      ->type_name("HOLDS=NAME")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->group(kGroup);
}

recording::ReadOptions RecordingOptions::read() const {
  recording::ReadOptions result = options;
  const auto roles = recording::columnRoles();
  for (const std::string& column : columns) {
    const std::size_t middle = std::min(column.find('='), column.size());
    const std::string role = column.substr(0, middle);
    if (middle == column.size() || std::ranges::find(roles, role) == roles.end()) {
      throw InputError("--column " + column + " must be HOLDS=NAME, where HOLDS is one of " +
                       joinedOf(roles, [](std::string_view one) { return std::string(one); }));
    }
    result.columns.emplace_back(role, column.substr(middle + 1));
  }
  return result;
}

std::string notNegative(const std::string& text) {
  const auto number = parsedNumber<double>(text);
  return number >= 0 && std::isfinite(*number) ? ""
                                               : oneLine(text, 40) + " must be a number, 0 or more";
}

Eigen::Vector3d threeNumbers(const std::string& text, const char* option) {
  Eigen::Vector3d numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [rest, error] = std::from_chars(at, end, numbers[i]);
    const bool isLast = i == 2;
    const bool isSound = error == std::errc() && numbers[i] > 0 &&
                         (isLast ? rest == end : rest != end && *rest == ',');
    if (!isSound) {
      throw InputError(std::string(option) + " " + text +
                       " must be three numbers over 0, such as 0.004,0.002,0.005");
    }
    at = rest + 1;
  }
  return numbers;
}

}  // namespace rotatebook::cli
