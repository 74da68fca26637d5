// JSON, written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rotatebook {

/// `text` in quotation marks, as JSON has it; also within a <script>, which no "</script>" in it
/// ends.
std::string jsonString(std::string_view text);

/// "[a, b]" of values that are JSON.
std::string jsonArray(const std::vector<std::string>& values);

/// The same of `items`, each of which `asJson` makes JSON of.
template <typename Items, typename AsJson>
std::string jsonArrayOf(const Items& items, const AsJson& asJson) {
  std::vector<std::string> values;
  for (const auto& item : items) values.push_back(asJson(item));
  return jsonArray(values);
}

/// An object that is put together member by member.
class JsonObject {
 public:
  /// `json` is JSON itself.
  JsonObject& add(std::string_view key, const std::string& json);
  JsonObject& addString(std::string_view key, std::string_view text);
  /// null for an empty text.
  JsonObject& addStringOrNull(std::string_view key, std::string_view text);
  /// Finite.
  JsonObject& addNumber(std::string_view key, double value);
  JsonObject& addBool(std::string_view key, bool value);

  /// "{...}"
  std::string text() const { return "{" + members_ + "}"; }

 private:
  std::string members_;
};

}  // namespace rotatebook
