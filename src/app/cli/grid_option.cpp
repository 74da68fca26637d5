#include "cli/grid_option.h"

#include <cstdint>
#include <regex>

#include "base/document/toml_text.h"
#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/text.h"
#include "scene/grid_settings.h"

namespace rotatebook::cli {
namespace {

std::string optionText(const std::string& text) {
  constexpr std::size_t kMaxShown = 200;
  return "--grid " + oneLine(text, kMaxShown);
}

[[noreturn]] void fail(const std::string& text, const std::string& problem) {
  throw InputError(optionText(text) + ": " + problem);
}

/// Returns a value as TOML: words in quotes.
std::string tomlOf(const std::string& value, const std::string& option) {
  if (value.empty()) fail(option, "a value is empty; write values with commas between them");
  return document::parseTomlValue(value, "") ? value : document::tomlString(value);
}

/// Returns the list of the whole numbers `first` to `last`.
std::string wholeNumbers(std::int64_t first, std::int64_t last, const std::string& option) {
  const std::string range = std::to_string(first) + ".." + std::to_string(last);
  if (first > last) fail(option, range + " runs downward; write the smaller number first");
  if (last - first >= static_cast<std::int64_t>(scene::kMaxGridSide)) {
    fail(option, range + " has " + std::to_string(last - first + 1) + " values; a side has up to " +
                     std::to_string(scene::kMaxGridSide) + ": list some, such as 1,2,4,8");
  }
  std::string list;
  for (std::int64_t i = first; i <= last; ++i) list += (i > first ? ", " : "") + std::to_string(i);
  return "values = [" + list + "]";
}

/// Returns the keys of an axis that state its values.
std::string valuesOf(const std::string& values, const std::string& option) {
  static const std::regex kRange(R"((-?[0-9]{1,9})\.\.(-?[0-9]{1,9}))");
  if (values.starts_with('[') || values.starts_with('{')) {
    if (document::parseTomlValue(values, "")) {
      return values[0] == '[' ? "values = " + values : values.substr(1, values.size() - 2);
    }
    fail(option, values +
                     " isn't TOML; write a list such as [1, 10] or a table such as "
                     "{ from = 1, to = 100, count = 5 }");
  }
  std::smatch range;
  if (std::regex_match(values, range, kRange)) {
    return wholeNumbers(std::stoll(range[1]), std::stoll(range[2]), option);
  }
  if (values.find("..") != values.npos) {
    fail(option,
         values +
             " is no range of whole numbers, such as 1..8; list other numbers, such as 0.1,1,10");
  }
  std::string list;
  for (std::size_t begin = 0; begin <= values.size();) {
    const std::size_t end = std::min(values.find(',', begin), values.size());
    const std::string value(trimmed(std::string_view(values).substr(begin, end - begin)));
    list += (begin > 0 ? ", " : "") + tomlOf(value, option);
    begin = end + 1;
  }
  return "values = [" + list + "]";
}

/// Returns the table of one axis from "KEY=VALUES".
std::string axisOf(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  const std::string key(trimmed(std::string_view(text).substr(0, std::min(equals, text.size()))));
  if (equals == text.npos || key.empty()) {
    fail(option,
         "not a grid; write \"KEY=VALUES\" or \"KEY=VALUES x KEY=VALUES\", for example "
         "\"initial.tilt=1e-2,1e-4 x simulation.substeps=1..8\"");
  }
  const std::string values(trimmed(std::string_view(text).substr(equals + 1)));
  return "{ key = " + document::tomlString(key) + ", " + valuesOf(values, option) + " }";
}

}  // namespace

std::vector<Shorthand> gridShorthands(const std::string& text) {
  static const std::regex kBetween(R"(\s+x\s+(?=[^\s=]+\s*=))");
  std::vector<std::string> axes(std::sregex_token_iterator(text.begin(), text.end(), kBetween, -1),
                                {});
  if (axes.size() > 2) fail(text, "a grid has one key or two, columns and rows");
  std::string grid = "columns = " + axisOf(axes.front(), text);
  if (axes.size() > 1) grid += ", rows = " + axisOf(axes.back(), text);
  return {{optionText(text), "grid={ " + grid + " }"}, {optionText(text), "expect={}"}};
}

}  // namespace rotatebook::cli
