#include "base/json.h"

#include <cmath>

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook {

std::string jsonString(std::string_view text) {
  std::string json;
  for (const char character : quotedText(validUtf8(text))) {
    character == '<' ? json += "\\u003C" : json += character;
  }
  return json;
}

std::string jsonArray(const std::vector<std::string>& values) {
  return "[" + joined(values) + "]";
}

JsonObject& JsonObject::add(std::string_view key, const std::string& json) {
  members_ += (members_.empty() ? "" : ", ") + jsonString(key) + ": " + json;
  return *this;
}

JsonObject& JsonObject::addString(std::string_view key, std::string_view text) {
  return add(key, jsonString(text));
}

JsonObject& JsonObject::addStringOrNull(std::string_view key, std::string_view text) {
  return add(key, text.empty() ? "null" : jsonString(text));
}

JsonObject& JsonObject::addNumber(std::string_view key, double value) {
  return add(key, std::isfinite(value) ? shortestText(value) : "null");
}

JsonObject& JsonObject::addNumberOrNull(std::string_view key, const std::optional<double>& value) {
  return value ? addNumber(key, *value) : add(key, "null");
}

JsonObject& JsonObject::addInteger(std::string_view key, std::int64_t value) {
  return add(key, std::to_string(value));
}

JsonObject& JsonObject::addBool(std::string_view key, bool value) {
  return add(key, value ? "true" : "false");
}

JsonObject resultOf(std::string_view kind) {
  JsonObject object;
  object.addString("result", kind);
  return object;
}

bool isResultOf(std::string_view kind, std::string_view json) {
  return json.starts_with("{\"result\": " + jsonString(kind));
}

}  // namespace rotatebook
