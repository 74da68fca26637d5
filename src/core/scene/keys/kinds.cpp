#include "scene/keys/kinds.h"

#include "base/text.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

constexpr double kShortestDirection = 1e-30;

}  // namespace

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

Kind<int> integer(int min, int max) {
  return {[=](const ValueReader& value) { return value.integer(min, max); },
          [](int value) { return std::to_string(value); }, document::expectedInteger(min, max)};
}

Kind<double> number(const NumberRange& range) {
  return {[range](const ValueReader& value) { return value.number(range); }, tomlNumber,
          std::string(range.expected)};
}

Kind<std::string> text(std::size_t most) {
  return {[most](const ValueReader& value) { return value.text(most); }, tomlString,
          document::expectedString(most)};
}

Kind<std::string> lines(std::size_t most) {
  return {[most](const ValueReader& value) { return value.lines(most); }, tomlString,
          document::expectedString(most)};
}

Eigen::Vector3d vectorFrom(const ValueReader& value, const NumberRange& range) {
  const std::string expected(range.expected);
  if (const auto* array = std::get_if<TomlNode::Array>(&value.node().value);
      array && array->size() == 6) {
    value.fail(value.name() + " must be " + expected + ", not " + describe(value.node()) +
               "; a comma separates values, so write a decimal point: 5.0, not 5,0");
  }
  Eigen::Vector3d vector;
  Eigen::Index row = 0;
  readEach(value.elements(3, expected),
           [&](const ValueReader& element) { vector[row++] = element.number(range); });
  return vector;
}

Eigen::Vector3d directionFrom(const ValueReader& value, const NumberRange& range) {
  const Eigen::Vector3d direction = vectorFrom(value, range);
  if (direction.isZero(0)) value.mismatch(std::string(range.expected));
  if (direction.stableNorm() < kShortestDirection) {
    value.mismatch("at least " + tomlNumber(kShortestDirection) + " long");
  }
  return direction;
}

Kind<Eigen::Vector3d> vector(const NumberRange& range) {
  return {[range](const ValueReader& value) { return vectorFrom(value, range); }, vectorText,
          std::string(range.expected)};
}

Kind<Eigen::Vector3d> direction() {
  return {[](const ValueReader& value) { return directionFrom(value); }, vectorText,
          std::string(kDirections.expected)};
}

Kind<Rgb> colour() {
  constexpr const char* kColours = "\"white\", \"black\" or a colour such as \"#2b5d8a\"";
  return {[](const ValueReader& value) {
            const auto* text = std::get_if<std::string>(&value.node().value);
            const std::optional<Rgb> colour = text ? parseRgb(*text) : std::nullopt;
            if (!colour) value.mismatch(kColours);
            return *colour;
          },
          [](const Rgb& colour) { return tomlString(textOf(colour)); }, kColours};
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return "[" + joined({tomlNumber(vector.x()), tomlNumber(vector.y()), tomlNumber(vector.z())}) +
         "]";
}

}  // namespace rotatebook::scene
