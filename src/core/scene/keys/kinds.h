// Kinds of values that keys of several sections have; for this room alone.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/text.h"
#include "scene/keys/key.h"
#include "scene/names.h"
#include "scene/nearest_name.h"
#include "scene/toml_text.h"

namespace rotatebook::scene {

Kind<bool> flag();
Kind<int> integer(int min, int max);
Kind<double> number(const NumberRange& range);
/// Of at most `most` letters.
Kind<std::string> text(std::size_t most);
Kind<Eigen::Vector3d> vector(const NumberRange& range);
/// A vector that isn't zero.
Kind<Eigen::Vector3d> direction();

/// "[1.0, 2.0, 3.0]"
std::string vectorText(const Eigen::Vector3d& vector);

/// "[A, B]", with the text of each value.
template <typename T, typename Text>
std::string listText(const std::vector<T>& values, const Text& text) {
  std::vector<std::string> parts;
  for (const T& value : values) parts.push_back(text(value));
  return "[" + joined(parts) + "]";
}

/// The word for `value`, in quotes.
template <typename T, std::size_t N>
std::string word(const std::array<Named<T>, N>& choices, const T& value) {
  return tomlString(nameOf(choices, value));
}

/// One of `choices`, which outlive it. They are the comment, too.
template <typename T, std::size_t N>
Kind<T> oneOf(const std::array<Named<T>, N>& choices) {
  const std::string words = quotedList(namesOf(choices), "or");
  return {[&choices](const ValueReader& value) { return value.oneOf(choices); },
          [&choices](const T& value) { return word(choices, value); }, words, words};
}

}  // namespace rotatebook::scene
