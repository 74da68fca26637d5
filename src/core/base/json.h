// Functions that write JSON.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.h"

namespace rotatebook {

/// Returns `text` as a JSON string, in quotation marks; bytes that aren't UTF-8 become U+FFFD. It
/// is safe within a <script>, too: no "</script>" in it ends the element.
std::string jsonString(std::string_view text);

/// Returns "[a, b]" from values that are JSON already.
std::string jsonArray(const std::vector<std::string>& values);

/// Like jsonArray(), from the JSON that `asJson` makes of each of `items`.
template <typename Items, typename AsJson>
std::string jsonArrayOf(const Items& items, const AsJson& asJson) {
  std::vector<std::string> values;
  for (const auto& item : items) values.push_back(asJson(item));
  return jsonArray(values);
}

/// Returns "[x, y, z]", whose numbers read back as what they are.
template <typename Vector>
std::string vectorJson(const Vector& vector) {
  return jsonArrayOf(std::array<double, 3>{vector[0], vector[1], vector[2]}, shortestText);
}

/// An object that is built member by member.
class JsonObject {
 public:
  /// Adds a member whose value `json` is JSON already.
  JsonObject& add(std::string_view key, const std::string& json);
  JsonObject& addString(std::string_view key, std::string_view text);
  /// Adds null if `text` is empty.
  JsonObject& addStringOrNull(std::string_view key, std::string_view text);
  /// Adds a number, which reads back as exactly `value`; null unless it is finite.
  JsonObject& addNumber(std::string_view key, double value);
  /// Adds null for no number.
  JsonObject& addNumberOrNull(std::string_view key, const std::optional<double>& value);
  JsonObject& addInteger(std::string_view key, std::int64_t value);
  JsonObject& addBool(std::string_view key, bool value);

  /// Returns "{...}".
  std::string text() const { return "{" + members_ + "}"; }

 private:
  std::string members_;
};

/// Returns an object whose first member says which command's result it is: "clip", "map" or
/// "study".
JsonObject resultOf(std::string_view kind);
/// Returns whether JSON, or its beginning, is such a result.
bool isResultOf(std::string_view kind, std::string_view json);

}  // namespace rotatebook
