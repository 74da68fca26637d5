#include "cli/json_object.h"

#include <array>
#include <cstdio>

#include "base/number_text.h"

namespace rotatebook::cli {

std::string jsonString(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') quoted += '\\';
    if (code >= 0x20) {
      quoted += letter;
      continue;
    }
    std::array<char, 8> escape;
    std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(code));
    quoted += escape.data();
  }
  return quoted + "\"";
}

std::string jsonArray(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return "[" + text + "]";
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
  return add(key, shortestText(value));
}

JsonObject& JsonObject::addBool(std::string_view key, bool value) {
  return add(key, value ? "true" : "false");
}

}  // namespace rotatebook::cli
