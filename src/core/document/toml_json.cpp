#include "document/toml_json.h"

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "base/json.h"
#include "base/number_text.h"

namespace rotatebook::document {
namespace {

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
  std::string operator()(const std::shared_ptr<const Attachment>&) const { return "null"; }
  std::string operator()(const TomlNode::Array& value) const { return jsonArrayOf(value, jsonOf); }
  std::string operator()(const TomlNode::Table& value) const { return jsonOfTable(value); }
};

}  // namespace

std::string jsonOf(const TomlNode& node) {
  return std::visit(JsonOf{}, node.value);
}

}  // namespace rotatebook::document
