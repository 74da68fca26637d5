// JSON as it is written: by nlohmann's library, members in their order, on one line.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook {

using Json = nlohmann::ordered_json;

/// Returns a value's JSON; null for none.
template <typename Value>
Json orNull(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}
/// Returns a text's JSON; null for an empty one.
inline Json orNull(std::string_view text) {
  return text.empty() ? Json() : Json(text);
}

/// Returns an array of the JSON that `asJson` makes of each of `items`.
template <typename Items, typename AsJson>
Json arrayOf(const Items& items, const AsJson& asJson) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(asJson(item));
  return array;
}

/// Returns [x, y, z].
template <typename Vector>
Json vectorJson(const Vector& vector) {
  return Json::array({vector[0], vector[1], vector[2]});
}

/// Returns the rows of a matrix of 3 x 3.
template <typename Matrix>
Json matrixJson(const Matrix& matrix) {
  return Json::array(
      {vectorJson(matrix.row(0)), vectorJson(matrix.row(1)), vectorJson(matrix.row(2))});
}

/// Returns `value` rounded to `digits` significant digits, 1 to 17; null unless it is finite.
Json roundedJson(double value, int digits);

/// Returns `json` on one line. Numbers read back as what they are, or are null unless they are
/// finite; bytes that aren't UTF-8 become U+FFFD.
std::string jsonText(const Json& json);
/// Returns jsonText() and the line's end, as commands print it and files hold it.
std::string jsonLine(const Json& json);

/// Returns whether `text`, or its beginning, is a result of a command: "clip", "map" or "study",
/// as the object's first member says.
bool isResultOf(std::string_view kind, std::string_view text);

}  // namespace rotatebook
