#include "scene/scene_schema.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "base/document/toml_json.h"
#include "base/document/toml_tree.h"
#include "base/json.h"
#include "base/text.h"
#include "base/units.h"
#include "scene/key_rows.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

/// Returns Markdown without the targets of its links, and without the marks of code.
std::string plainText(std::string_view markdown) {
  std::string text;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    if (markdown.substr(i).starts_with("](")) {
      text.erase(text.rfind('['), 1);
      i = markdown.find(')', i);
    } else if (markdown[i] != '`') {
      text += markdown[i];
    }
  }
  return text;
}

/// Returns the units that numbers of a form may have: of its dimension, or any if texts are
/// numbers, too.
std::vector<std::string> unitsIn(const ValueForm& form) {
  std::vector<std::string> units;
  for (const Dimension dimension : {Dimension::Length, Dimension::Mass, Dimension::Time,
                                    Dimension::Angle, Dimension::AngularVelocity}) {
    if (form.dimension ? form.dimension != dimension : !form.kinds.text) continue;
    for (const std::string_view unit : unitsOf(dimension)) units.emplace_back(unit);
  }
  return units;
}

/// Returns the schema of a number within the limits of a form; with a unit, of a string, too.
Json numberSchema(const ValueForm& form) {
  Json number{{"type", "number"}};
  const auto isLimit = [](double value) {
    return std::abs(value) < std::numeric_limits<double>::max();
  };
  if (isLimit(form.min)) number["minimum"] = form.min;
  if (isLimit(form.max)) number["maximum"] = form.max;
  const std::vector<std::string> units = unitsIn(form);
  if (units.empty()) return number;
  const std::string pattern =
      R"(^\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?\s*()" + joined(units, "|") + R"()\s*$)";
  return {{"anyOf", Json::array({number, {{"type", "string"}, {"pattern", pattern}}})}};
}

Json typesOf(const ValueKinds& kinds) {
  Json types = Json::array();
  if (kinds.text) types.push_back("string");
  if (kinds.number) types.push_back("number");
  if (kinds.flag) types.push_back("boolean");
  if (kinds.list) types.push_back("array");
  if (kinds.table) types.push_back("object");
  return types;
}

Json textSchema(const ValueForm& form) {
  Json schema{{"type", "string"}, {"maxLength", static_cast<int>(form.max)}};
  if (form.pattern != nullptr) schema["pattern"] = form.pattern();
  return schema;
}

void addKey(Json& schema, std::string_view name, const KeyRow& row);
Json formSchema(const ValueForm& form);

Json tableSchema(const ValueForm& form) {
  Json schema{{"type", "object"}};
  if (form.members == nullptr) return schema;
  for (const KeyRow& row : form.members()) addKey(schema, row.name, row);
  return schema;
}

Json listSchema(const ValueForm& form) {
  Json schema{{"type", "array"}};
  if (form.elements != nullptr) schema["items"] = formSchema(*form.elements);
  if (form.members != nullptr) schema["items"] = tableSchema(form);
  if (!form.choices.empty()) schema["items"] = {{"enum", form.choices}};
  if (form.count > 0) schema["minItems"] = schema["maxItems"] = form.count;
  return schema;
}

/// Returns the schema of a form of its own: of a table, of a list, or of other types.
Json ownSchema(const ValueForm& form) {
  Json all = Json::array();
  if (form.kinds.table) all.push_back(tableSchema(form));
  if (form.kinds.list) all.push_back(listSchema(form));
  ValueKinds others = form.kinds;
  others.table = others.list = false;
  if (const Json types = typesOf(others); !types.empty()) all.push_back({{"type", types}});
  if (all.empty()) return Json::object();
  return all.size() == 1 ? all.front() : Json{{"anyOf", all}};
}

Json formSchema(const ValueForm& form) {
  switch (form.type) {
    case ValueForm::Type::Integer:
      return {{"type", "integer"},
              {"minimum", static_cast<int>(form.min)},
              {"maximum", static_cast<int>(form.max)}};
    case ValueForm::Type::Number:
      return numberSchema(form);
    case ValueForm::Type::Vector:
      return {{"type", "array"}, {"items", numberSchema(form)}, {"minItems", 3}, {"maxItems", 3}};
    case ValueForm::Type::Text:
      return textSchema(form);
    case ValueForm::Type::Choice:
      return {{"enum", form.choices}};
    case ValueForm::Type::Own:
      break;
  }
  return ownSchema(form);
}

/// Returns what is known of a key, on a line each.
std::string descriptionOf(const KeyRow& row) {
  std::vector<std::string> lines;
  if (!row.meaning.empty()) lines.push_back(row.meaning);
  if (!row.allowed.empty()) lines.push_back("Value: " + row.allowed);
  if (row.byDefault.size() > 2) lines.push_back("Default: " + row.byDefault);
  return plainText(joined(lines, "\n"));
}

Json keySchema(const KeyRow& row) {
  Json schema = formSchema(row.form);
  const Json others = typesOf(row.form.kinds);
  if (row.form.type == ValueForm::Type::Vector && !others.empty())
    schema = {{"anyOf", Json::array({schema, {{"type", others}}})}};
  schema["description"] = descriptionOf(row);
  if (row.value.empty()) return schema;
  if (const auto value = document::parseTomlValue(row.value, row.name))
    schema["default"] = Json::parse(document::jsonOf(*value));
  return schema;
}

/// Returns the schema of a member of the table that `schema` is of.
Json& member(Json& schema, const std::string& name) {
  schema["type"] = "object";
  schema["additionalProperties"] = false;
  return schema["properties"][name];
}

/// Adds the row of the key `name`, such as "nudge.N.at", to the schema of the table that has it.
void addKey(Json& schema, std::string_view name, const KeyRow& row) {
  const std::size_t dot = name.find('.');
  const std::string part(name.substr(0, dot));
  Json& own = member(schema, part);
  if (dot == name.npos) {
    own = keySchema(row);
    if (row.byDefault == "required") schema["required"].push_back(part);
    return;
  }
  const std::string_view rest = name.substr(dot + 1);
  if (!rest.starts_with("N.")) return addKey(own, rest, row);
  own["type"] = "array";
  addKey(own["items"], rest.substr(2), row);
}

}  // namespace

std::string sceneSchema() {
  Json schema{{"$schema", "http://json-schema.org/draft-04/schema#"},
              {"title", "A scene of rotatebook"}};
  for (const KeyRow& row : allKeys()) addKey(schema, row.name, row);
  // All panels share one clock.
  for (const auto& section : motionSections()) {
    for (const KeyRow& row : section.rows)
      if (row.name != "simulation.time_per_frame") addKey(schema, "panel.N." + row.name, row);
  }
  return schema.dump(1) + "\n";
}

}  // namespace rotatebook::scene
