#include "scene/keys/kinds.h"

#include <charconv>
#include <numbers>
#include <system_error>
#include <variant>

#include "base/text.h"

namespace rotatebook::scene {

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

Kind<bool> flag() {
  return {[](const ValueReader& value) { return value.flag(); },
          [](bool value) { return std::string(value ? "true" : "false"); },
          std::string(kExpectedFlag)};
}

Kind<int> integer(int min, int max) {
  return {[=](const ValueReader& value) { return value.integer(min, max); },
          [](int value) { return std::to_string(value); }, expectedInteger(min, max)};
}

Kind<double> number(const NumberRange& range) {
  return {[range](const ValueReader& value) { return value.number(range); }, tomlNumber,
          std::string(range.expected)};
}

Kind<std::string> text(std::size_t most) {
  return {[most](const ValueReader& value) { return value.text(most); }, tomlString,
          expectedString(most)};
}

Kind<std::string> lines(std::size_t most) {
  return {[most](const ValueReader& value) { return value.lines(most); }, tomlString,
          expectedString(most)};
}

double angleFrom(const ValueReader& value, const NumberRange& range) {
  const auto* text = std::get_if<std::string>(&value.node().value);
  if (text == nullptr) return value.number(range);
  double angle = 0;
  const auto [rest, error] = std::from_chars(text->data(), text->data() + text->size(), angle);
  const std::string_view unit = trimmed({rest, text->data() + text->size()});
  if (error != std::errc() || (unit != "deg" && unit != "rad")) {
    value.mismatch("an angle such as 0.02, in radians, \"0.02 rad\" or \"1 deg\"");
  }
  if (unit == "deg") angle *= std::numbers::pi / 180;
  if (!(angle >= range.min && angle <= range.max)) value.mismatch(std::string(range.expected));
  return angle;
}

Kind<Eigen::Vector3d> vector(const NumberRange& range) {
  return {[range](const ValueReader& value) { return value.vector(range); }, vectorText,
          std::string(range.expected)};
}

Kind<Eigen::Vector3d> direction() {
  return {[](const ValueReader& value) { return value.direction(); }, vectorText,
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
