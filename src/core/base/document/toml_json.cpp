#include "base/document/toml_json.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <variant>

#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"

namespace rotatebook::document {
namespace {

using Json = nlohmann::ordered_json;

std::string jsonOfTable(const TomlNode::Table& table) {
  JsonObject object;
  for (const TomlEntry& entry : table) object.add(entry.key, jsonOf(entry.node));
  return object.text();
}

struct JsonOf {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const {
    return std::isfinite(value) ? shortestText(value) : "null";
  }
  std::string operator()(const std::string& value) const { return jsonString(value); }
  std::string operator()(TomlDate) const { return "null"; }
  std::string operator()(const TomlNode::Array& value) const { return jsonArrayOf(value, jsonOf); }
  std::string operator()(const TomlNode::Table& value) const { return jsonOfTable(value); }
};

TomlNode nodeOf(const Json& json) {
  if (json.is_boolean()) return {json.get<bool>(), ""};
  if (json.is_number_integer()) return {json.get<std::int64_t>(), ""};
  if (json.is_number()) return {json.get<double>(), ""};
  if (json.is_string()) return {json.get<std::string>(), ""};
  if (json.is_array()) {
    TomlNode::Array array;
    for (const Json& element : json) array.push_back(nodeOf(element));
    return {std::move(array), ""};
  }
  if (!json.is_object()) throw InputError("TOML has no null");
  TomlNode::Table table;
  for (const auto& [key, value] : json.items()) table.push_back({key, "", nodeOf(value)});
  return {std::move(table), ""};
}

}  // namespace

std::string jsonOf(const TomlNode& node) {
  return std::visit(JsonOf{}, node.value);
}

TomlNode nodeOfJson(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw InputError("this isn't JSON");
  return nodeOf(json);
}

}  // namespace rotatebook::document
