#include "scene/keys/key.h"

#include <utility>

#include "base/nearest_name.h"
#include "base/text.h"
#include "scene/names.h"

namespace rotatebook::scene {
namespace {

/// Returns `text` with whatever is in "quotes" as Markdown code.
std::string quotedAsCode(std::string_view text) {
  std::string result;
  bool isQuoted = false;
  for (const char letter : text) {
    if (letter != '"') {
      result += letter;
      continue;
    }
    result += isQuoted ? "\"`" : "`\"";
    isQuoted = !isQuoted;
  }
  return result;
}

std::string meaningOf(const KeyText& key, const ValueForm& form, const std::string& unit) {
  const std::string models = key.models == kOfParticles    ? "particles: "
                             : key.models == kOfRecorded   ? "recorded: "
                             : key.models == kOfRigid      ? "rigid models: "
                             : key.models == kOfRigidSteps ? "matrix and quaternion: "
                                                           : "";
  return models + (key.meaning.empty() ? commentOf(key, form) : std::string(key.meaning)) +
         (unit.empty() ? "" : " [" + unit + "]");
}

}  // namespace

std::string allowedOf(const KeyText& key, const ValueForm& form) {
  if (!key.allowed.empty()) return std::string(key.allowed);
  if (form.type == ValueForm::Type::Integer)
    return document::expectedInteger(static_cast<int>(form.min), static_cast<int>(form.max));
  if (form.type == ValueForm::Type::Text)
    return document::expectedString(static_cast<std::size_t>(form.max));
  if (form.type == ValueForm::Type::Choice) return quotedList(form.choices, "or");
  return std::string(form.expected);
}

std::string commentOf(const KeyText& key, const ValueForm& form) {
  if (!key.comment.empty() || form.choices.empty()) return std::string(key.comment);
  const bool isOne = form.type == ValueForm::Type::Choice;
  return isOne ? quotedList(form.choices, "or") : "of " + quotedList(form.choices, "and");
}

KeyRow rowOf(std::string name, const KeyText& key, const ValueForm& form, std::string value) {
  std::string unit(key.unit);
  if (unit.empty() && form.dimension) unit = unitsOf(*form.dimension).front();
  return {.name = std::move(name),
          .byDefault = key.byDefault.empty() ? "`" + value + "`" : std::string(key.byDefault),
          .allowed = quotedAsCode(allowedOf(key, form)),
          .meaning = meaningOf(key, form, unit),
          .value = std::move(value),
          .form = form,
          .unit = unit,
          .models = key.models,
          .affects = key.affects};
}

void addRow(std::vector<KeyRow>& rows, std::string_view section, std::string_view name,
            const KeyText& key, const ValueForm& form, std::string value) {
  rows.push_back(rowOf(std::string(section) + std::string(name), key, form, std::move(value)));
}

}  // namespace rotatebook::scene
