// Rows of keys by the kind of their value. A row names the member that a key is read into; its
// limits and choices are data. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
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

// Members, as template parameters

/// A member of a member, such as the mass of a motion's body.
template <auto kOuter, auto kInner>
struct Within {
  constexpr auto& operator()(auto& owner) const { return (owner.*kOuter).*kInner; }
};

template <typename Member>
struct OwnerOf;
template <typename S, typename T>
struct OwnerOf<T S::*> {
  using Type = S;
};
template <auto kOuter, auto kInner>
struct OwnerOf<Within<kOuter, kInner>> : OwnerOf<std::remove_const_t<decltype(kOuter)>> {};

/// The struct that has a member.
template <auto kMember>
using Owner = typename OwnerOf<std::remove_const_t<decltype(kMember)>>::Type;

template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// Returns the value that an optional one has.
template <typename T>
auto& valueIn(T& member) {
  if constexpr (kIsOptional<std::remove_const_t<T>>) {
    return *member;
  } else {
    return member;
  }
}

// Kinds in general

/// Returns the row of a key that is read into several members: by `kRead(value, into)`.
template <typename S, auto kRead, auto kText>
constexpr Key<S> keyOf(std::string_view name, const ValueForm& form,
                       const KeyText& documentation = {}) {
  return {name, form,
          [](const ValueReader& value, const ValueForm&, S& into) { kRead(value, into); },
          [](const S& from) -> std::string { return kText(from); }, documentation};
}

/// Returns the row of a key of a member that `kRead` returns, from the value and, if it takes one,
/// the form, and `kText` prints. `kPart(value, part, form, member)` reads a part of it.
template <auto kMember, auto kRead, auto kText, auto kPart = nullptr>
constexpr auto key(std::string_view name, const ValueForm& form,
                   const KeyText& documentation = {}) {
  using S = Owner<kMember>;
  Key<S> key{
      name, form,
      [](const ValueReader& value, const ValueForm& allowed, S& into) {
        if constexpr (std::is_invocable_v<decltype(kRead), const ValueReader&, const ValueForm&>) {
          std::invoke(kMember, into) = kRead(value, allowed);
        } else {
          std::invoke(kMember, into) = kRead(value);
        }
      },
      [](const S& from) -> std::string {
        const auto& member = std::invoke(kMember, from);
        if constexpr (kIsOptional<std::remove_cvref_t<decltype(member)>>) {
          if (!member) return "";
        }
        return kText(valueIn(member));
      },
      documentation};
  if constexpr (!std::is_null_pointer_v<decltype(kPart)>) {
    key.partReader = [](const ValueReader& value, std::string_view part, const ValueForm& allowed,
                        S& into) {
      kPart(value, part, allowed, valueIn(std::invoke(kMember, into)));
    };
  }
  return key;
}

/// Returns the form of values of a form of their own.
constexpr ValueForm ownForm(ValueKinds kinds, std::string_view expected) {
  return {.expected = expected, .kinds = kinds};
}

/// Returns the form of tables, or of lists of them, whose keys `members` returns.
constexpr ValueForm tableForm(ValueKinds kinds, std::string_view expected,
                              std::vector<KeyRow> (*members)()) {
  return {.expected = expected, .kinds = kinds, .members = members};
}

/// Returns the form of lists of `count` values of the form `elements`; 0 for any number of them.
constexpr ValueForm listForm(std::string_view expected, const ValueForm& elements, int count = 0) {
  return {.expected = expected, .kinds = kListKind, .elements = &elements, .count = count};
}

/// Returns the row of a key whose values have a form of their own.
template <auto kMember, auto kRead, auto kText, auto kPart = nullptr>
constexpr auto own(std::string_view name, ValueKinds kinds, std::string_view expected,
                   const KeyText& documentation = {}) {
  return key<kMember, kRead, kText, kPart>(name, ownForm(kinds, expected), documentation);
}

// Numbers

/// Wide enough for any book, and narrow enough that no product of squares leaves the range of
/// double.
inline constexpr NumberRange kDirections{
    "three numbers from -1e9 to 1e9, at least one other than 0", -1e9, 1e9};

constexpr ValueForm integerForm(int min, int max) {
  return {.type = ValueForm::Type::Integer,
          .min = static_cast<double>(min),
          .max = static_cast<double>(max)};
}

/// Returns the form of one number, or of three, within `range`.
constexpr ValueForm formOf(ValueForm::Type type, const NumberRange& range) {
  return {.type = type,
          .min = range.min,
          .max = range.max,
          .dimension = range.dimension,
          .expected = range.expected};
}

/// Returns the range of the numbers of a form.
constexpr NumberRange rangeOf(const ValueForm& form) {
  return {form.expected, form.min, form.max, form.dimension};
}

int integerFrom(const ValueReader& value, const ValueForm& form);
std::string integerText(int value);
double numberFrom(const ValueReader& value, const ValueForm& form);
inline constexpr const char* kFlags = "true or false";
bool flagFrom(const ValueReader& value);
/// Returns three numbers, each within `range`, whose description is that of all three.
Eigen::Vector3d vectorFrom(const ValueReader& value, const NumberRange& range);
Eigen::Vector3d vectorOf(const ValueReader& value, const ValueForm& form);
/// Returns "[1.0, 2.0, 3.0]".
std::string vectorText(const Eigen::Vector3d& vector);
/// Reads the element "0", "1" or "2".
void readElement(const ValueReader& number, std::string_view part, const NumberRange& range,
                 Eigen::Vector3d& into);
void readElementOf(const ValueReader& number, std::string_view part, const ValueForm& form,
                   Eigen::Vector3d& into);
/// Throws InputError if the vector is zero, or less than 1e-30 long.
void requireDirection(const ValueReader& value, const Eigen::Vector3d& direction,
                      const NumberRange& range = kDirections);
/// Like vectorFrom(), of vectors that requireDirection() takes.
Eigen::Vector3d directionFrom(const ValueReader& value, const NumberRange& range);
Eigen::Vector3d directionOf(const ValueReader& value, const ValueForm& form);

template <auto kMember>
constexpr auto integer(std::string_view name, int min, int max, const KeyText& documentation = {}) {
  return key<kMember, integerFrom, integerText>(name, integerForm(min, max), documentation);
}

template <auto kMember>
constexpr auto number(std::string_view name, const NumberRange& range,
                      const KeyText& documentation = {}) {
  return key<kMember, numberFrom, tomlNumber>(name, formOf(ValueForm::Type::Number, range),
                                              documentation);
}

template <auto kMember>
constexpr auto vector(std::string_view name, const NumberRange& range,
                      const KeyText& documentation = {}) {
  return key<kMember, vectorOf, vectorText, readElementOf>(
      name, formOf(ValueForm::Type::Vector, range), documentation);
}

/// Vectors that aren't zero.
template <auto kMember>
constexpr auto direction(std::string_view name, const KeyText& documentation = {}) {
  return key<kMember, directionOf, vectorText, readElementOf>(
      name, formOf(ValueForm::Type::Vector, kDirections), documentation);
}

// Angles about an axis

inline constexpr const char* kExpectedTilt =
    "an angle and an axis, such as [0.02, \"z\"] or [\"1 deg\", \"z\"]";
physics::Tilt tiltFrom(const ValueReader& value);
std::string tiltText(const physics::Tilt& tilt);
void readTiltPart(const ValueReader& number, std::string_view part, const ValueForm& form,
                  physics::Tilt& tilt);

/// An angle and the axis that it is about, or toward.
template <auto kMember>
constexpr auto angleAboutAxis(std::string_view name, const KeyText& documentation = {}) {
  return key<kMember, tiltFrom, tiltText, readTiltPart>(
      name, {.dimension = Dimension::Angle, .expected = kExpectedTilt, .kinds = kListKind},
      documentation);
}

// Texts and colours

std::string textFrom(const ValueReader& value, const ValueForm& form);
std::string linesFrom(const ValueReader& value, const ValueForm& form);
/// Returns the text in quotes; nothing of an empty one.
std::string optionalText(const std::string& text);

constexpr ValueForm textForm(std::size_t most) {
  return {.type = ValueForm::Type::Text, .max = static_cast<double>(most)};
}

/// Strings of at most `most` characters, on one line.
template <auto kMember>
constexpr auto text(std::string_view name, std::size_t most, const KeyText& documentation = {}) {
  return key<kMember, textFrom, tomlString>(name, textForm(most), documentation);
}

/// Strings of at most `most` characters, on several lines.
template <auto kMember>
constexpr auto lines(std::string_view name, std::size_t most, const KeyText& documentation = {}) {
  return key<kMember, linesFrom, tomlString>(name, textForm(most), documentation);
}

inline constexpr const char* kColours = "\"white\", \"black\" or a colour such as \"#2b5d8a\"";
Rgb colourFrom(const ValueReader& value);
std::string colourText(const Rgb& colour);

template <auto kMember>
constexpr auto colour(std::string_view name, const KeyText& documentation = {}) {
  return own<kMember, colourFrom, colourText>(name, kTextKind, kColours, documentation);
}

// Choices

/// Returns the one of `choices` whose name the value is.
template <typename T, std::size_t N>
T choiceFrom(const ValueReader& value, const std::array<Named<T>, N>& choices) {
  return choices[value.choice(namesOf(choices))].value;
}

/// Returns the name of `value`, in quotes.
template <typename T, std::size_t N>
std::string quotedName(const std::array<Named<T>, N>& choices, const T& value) {
  return tomlString(nameOf(choices, value));
}

template <const auto& kChoices>
inline constexpr auto kNamesOf = namesOf(kChoices);
template <const auto& kChoices>
auto choiceOf(const ValueReader& value) {
  return choiceFrom(value, kChoices);
}
template <const auto& kChoices, typename T>
std::string choiceText(const T& value) {
  return quotedName(kChoices, value);
}

/// Values that are one of kChoices. Their names are the comment, too.
template <auto kMember, const auto& kChoices>
constexpr auto choice(std::string_view name, const KeyText& documentation = {}) {
  using T = decltype(kChoices.front().value);
  return key<kMember, choiceOf<kChoices>, choiceText<kChoices, std::remove_const_t<T>>>(
      name, {.type = ValueForm::Type::Choice, .choices = kNamesOf<kChoices>}, documentation);
}

// Lists

/// Returns "[A, B]", with the text of each value.
template <typename T, typename Text>
std::string listText(const std::vector<T>& values, const Text& text) {
  std::vector<std::string> parts;
  for (const T& value : values) parts.push_back(text(value));
  return "[" + joined(parts) + "]";
}

/// Reads a list of tables. An empty one, by which the command line leaves out what is there, has
/// none. Throws InputError, also unless the value is such a list.
template <typename Read>
auto tablesFrom(const ValueReader& value, const char* expected, const Read& read) {
  std::vector<std::remove_cvref_t<std::invoke_result_t<Read, const ValueReader&>>> all;
  const auto* array = std::get_if<document::TomlNode::Array>(&value.node().value);
  if (array != nullptr && array->empty()) return all;
  readEach(value.tables(expected), [&](const ValueReader& table) { all.push_back(read(table)); });
  return all;
}

/// Returns a list of tables as TOML; nothing of an empty one.
template <typename T, typename Text>
std::string tablesText(const std::vector<T>& all, const Text& text) {
  return all.empty() ? "" : listText(all, text);
}

}  // namespace rotatebook::scene
