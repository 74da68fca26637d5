#include "cli/option_checks.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

#include "base/nearest_name.h"
#include "base/number_text.h"
#include "base/parsed_number.h"
#include "base/text.h"
#include "cli/commands.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace {

/// Returns the refusal of a value that isn't `what`.
std::string refusalOf(const std::string& text, const std::string& what) {
  constexpr std::size_t kLongest = 40;  // [letters]
  const std::string shown = oneLine(text, kLongest);
  return kMust + what + ", not " + (parsedNumber<double>(text) ? shown : quotedText(shown));
}

/// Returns `range` with other words for its refusal, and its own in the help.
CLI::Validator saying(const CLI::Range& range, const std::string& what) {
  return {
      [range, what](std::string& text) { return range(text).empty() ? "" : refusalOf(text, what); },
      range.get_description()};
}

}  // namespace

CLI::Validator wholeNumber(std::int64_t least, std::int64_t most) {
  return saying(CLI::Range(least, most), fmt::format("a whole number from {} to {}", least, most));
}

CLI::Validator numberWithin(double least, double most) {
  return saying(CLI::Range(least, most),
                fmt::format("a number from {} to {}", shortestText(least), shortestText(most)));
}

CLI::Validator oneOf(const std::vector<std::string>& words) {
  return {[words](std::string& text) -> std::string {
            if (std::ranges::count(words, text) > 0) return "";
            return refusalOf(text, listed(words, "or")) +
                   didYouMean(text, std::vector<std::string_view>(words.begin(), words.end()));
          },
          ""};
}

std::string notNegative(const std::string& text) {
  const auto number = parsedNumber<double>(text);
  return number >= 0 && std::isfinite(*number) ? "" : refusalOf(text, "a number, 0 or more");
}

std::string notStandardInput(const std::string& path) {
  if (path != system::kStandardInput) return "";
  return "the standard input isn't read here; name a file or folder; one that is named - is "
         "written ./-";
}

std::string notStandardOutput(const std::string& path) {
  if (path != kStandardOutput) return "";
  return "nothing is written to the standard output; a file or folder named - is written ./-";
}

}  // namespace rotatebook::cli
