#include "base/document/toml_json.h"

#include <cstdint>
#include <variant>

#include "base/error.h"
#include "base/json.h"
#include "base/number_text.h"

namespace rotatebook::document {
namespace {

Json jsonFrom(const TomlNode& node);

struct JsonFrom {
  template <typename Value>
  Json operator()(const Value& value) const {
    return value;
  }
  Json operator()(TomlDate) const { return nullptr; }
  Json operator()(const TomlNode::Array& value) const { return arrayOf(value, jsonFrom); }
  Json operator()(const TomlNode::Table& value) const {
    Json object = Json::object();
    for (const TomlEntry& entry : value) object[entry.key] = jsonFrom(entry.node);
    return object;
  }
};

Json jsonFrom(const TomlNode& node) {
  return std::visit(JsonFrom{}, node.value);
}

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
  return jsonText(jsonFrom(node));
}

TomlNode nodeOfJson(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw InputError("this isn't JSON");
  return nodeOf(json);
}

}  // namespace rotatebook::document
