#include "scene/keys/kinds.h"

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

Kind<Eigen::Vector3d> vector(const NumberRange& range) {
  return {[range](const ValueReader& value) { return value.vector(range); }, vectorText,
          std::string(range.expected)};
}

Kind<Eigen::Vector3d> direction() {
  return {[](const ValueReader& value) { return value.direction(); }, vectorText,
          std::string(kDirections.expected)};
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return "[" + joined({tomlNumber(vector.x()), tomlNumber(vector.y()), tomlNumber(vector.z())}) +
         "]";
}

}  // namespace rotatebook::scene
