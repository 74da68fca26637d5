// Kinds of values that keys of several sections share. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/document/toml_text.h"
#include "base/nearest_name.h"
#include "base/rgb.h"
#include "base/text.h"
#include "scene/keys/key.h"
#include "scene/names.h"

namespace rotatebook::scene {

/// Wide enough for any book, and narrow enough that no product of squares leaves the range of
/// double.
inline constexpr NumberRange kDirections{
    "three numbers from -1e9 to 1e9, at least one other than 0", -1e9, 1e9};

ValueForm integerForm(int min, int max);
/// Returns the form of one number, or of three, within `range`.
ValueForm formOf(ValueForm::Type type, const NumberRange& range);

Kind<int> integer(int min, int max);
Kind<double> number(const NumberRange& range);
/// Strings of at most `most` characters, on one line.
Kind<std::string> text(std::size_t most);
/// Strings of at most `most` characters, on several lines.
Kind<std::string> lines(std::size_t most);
/// Returns three numbers, each within `range`, whose description is that of all three.
Eigen::Vector3d vectorFrom(const ValueReader& value, const NumberRange& range);
/// Returns three numbers likewise that aren't all zero, at least 1e-30 long.
Eigen::Vector3d directionFrom(const ValueReader& value, const NumberRange& range = kDirections);
/// Returns the one of `choices` whose name the value is.
template <typename T, std::size_t N>
T choiceFrom(const ValueReader& value, const std::array<Named<T>, N>& choices) {
  return choices[value.choice(namesOf(choices))].value;
}
/// Throws InputError for directionFrom()'s reasons.
void requireDirection(const ValueReader& value, const Eigen::Vector3d& direction,
                      const NumberRange& range = kDirections);
/// Reads the element "0", "1" or "2".
void readElement(const ValueReader& number, std::string_view part, const NumberRange& range,
                 Eigen::Vector3d& into);
Kind<Eigen::Vector3d> vector(const NumberRange& range);
/// Vectors that aren't zero.
Kind<Eigen::Vector3d> direction();

Kind<Rgb> colour();
/// An angle and the axis that it is about, or toward.
Kind<physics::Tilt> angleAboutAxis();

/// Returns "[1.0, 2.0, 3.0]".
std::string vectorText(const Eigen::Vector3d& vector);

/// Returns "[A, B]", with the text of each value.
template <typename T, typename Text>
std::string listText(const std::vector<T>& values, const Text& text) {
  std::vector<std::string> parts;
  for (const T& value : values) parts.push_back(text(value));
  return "[" + joined(parts) + "]";
}

/// Lists of tables, each of which `read` reads and `text` prints. An empty list, by which the
/// command line leaves out what is there, has none.
template <typename T>
Kind<std::vector<T>> tables(std::function<T(const ValueReader&)> read,
                            std::function<std::string(const T&)> text, const char* expected) {
  return {[=](const ValueReader& value) {
            std::vector<T> all;
            const auto* array = std::get_if<document::TomlNode::Array>(&value.node().value);
            if (array != nullptr && array->empty()) return all;
            readEach(value.tables(expected),
                     [&](const ValueReader& table) { all.push_back(read(table)); });
            return all;
          },
          [text = std::move(text)](const std::vector<T>& all) {
            return all.empty() ? "" : listText(all, text);
          },
          expected};
}

/// Returns the name of `value`, in quotes.
template <typename T, std::size_t N>
std::string quotedName(const std::array<Named<T>, N>& choices, const T& value) {
  return tomlString(nameOf(choices, value));
}

/// Values that are one of `choices`, which must outlive it. Their names are the comment, too.
template <typename T, std::size_t N>
Kind<T> oneOf(const std::array<Named<T>, N>& choices) {
  const auto names = namesOf(choices);
  const std::string allowed = quotedList(names, "or");
  return {[&choices](const ValueReader& value) { return choiceFrom(value, choices); },
          [&choices](const T& value) { return quotedName(choices, value); },
          allowed,
          allowed,
          {.type = ValueForm::Type::Choice, .choices = {names.begin(), names.end()}}};
}

}  // namespace rotatebook::scene
