#include "scene/keys/kinds.h"

#include "base/elementary.h"
#include "base/text.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

constexpr double kShortestDirection = 1e-30;

}  // namespace

ValueForm integerForm(int min, int max) {
  return {.type = ValueForm::Type::Integer,
          .min = static_cast<double>(min),
          .max = static_cast<double>(max)};
}

ValueForm formOf(ValueForm::Type type, const NumberRange& range) {
  return {.type = type, .min = range.min, .max = range.max, .dimension = range.dimension};
}

Kind<int> integer(int min, int max) {
  return {[=](const ValueReader& value) { return value.integer(min, max); },
          [](int value) { return std::to_string(value); }, document::expectedInteger(min, max), "",
          integerForm(min, max)};
}

Kind<double> number(const NumberRange& range) {
  return {[range](const ValueReader& value) { return value.number(range); }, tomlNumber,
          std::string(range.expected), "", formOf(ValueForm::Type::Number, range)};
}

Kind<std::string> text(std::size_t most) {
  return {[most](const ValueReader& value) { return value.text(most); },
          tomlString,
          document::expectedString(most),
          "",
          {.type = ValueForm::Type::Text, .max = static_cast<double>(most)}};
}

Kind<std::string> lines(std::size_t most) {
  Kind<std::string> kind = text(most);
  kind.read = [most](const ValueReader& value) { return value.lines(most); };
  return kind;
}

void readElement(const ValueReader& number, std::string_view part, const NumberRange& range,
                 Eigen::Vector3d& into) {
  const bool isElement = part == "0" || part == "1" || part == "2";
  if (!isElement)
    number.fail(number.name() + " has the numbers 0, 1 and 2, and no " + tomlString(part));
  into[part[0] - '0'] = number.number(range);
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
  requireDirection(value, direction, range);
  return direction;
}

void requireDirection(const ValueReader& value, const Eigen::Vector3d& direction,
                      const NumberRange& range) {
  if (direction.isZero(0)) value.mismatch(std::string(range.expected));
  if (direction.stableNorm() < kShortestDirection) {
    value.mismatch("at least " + tomlNumber(kShortestDirection) + " long");
  }
}

Kind<Eigen::Vector3d> vector(const NumberRange& range) {
  return {[range](const ValueReader& value) { return vectorFrom(value, range); },
          vectorText,
          std::string(range.expected),
          "",
          formOf(ValueForm::Type::Vector, range),
          [range](const ValueReader& value, std::string_view part, Eigen::Vector3d& into) {
            readElement(value, part, range, into);
          }};
}

Kind<Eigen::Vector3d> direction() {
  Kind<Eigen::Vector3d> kind = vector(kDirections);
  kind.read = [](const ValueReader& value) { return directionFrom(value); };
  return kind;
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

Kind<physics::Tilt> angleAboutAxis() {
  constexpr NumberRange kAngles{"an angle from -1e6 to 1e6 rad", -kLargestAngle, kLargestAngle,
                                Dimension::Angle};
  constexpr const char* kExpected =
      "an angle and an axis, such as [0.02, \"z\"] or [\"1 deg\", \"z\"]";
  return {[=](const ValueReader& value) {
            const auto parts = value.elements(2, kExpected);
            physics::Tilt tilt;
            readEach(parts, [&](const ValueReader& part) {
              if (&part == &parts[0]) tilt.angle = part.number(kAngles);
              if (&part == &parts[1]) tilt.axis = choiceFrom(part, kAxes);
            });
            return tilt;
          },
          [](const physics::Tilt& tilt) {
            return "[" + tomlNumber(tilt.angle) + ", " + quotedName(kAxes, tilt.axis) + "]";
          },
          kExpected,
          "",
          {.dimension = Dimension::Angle},
          [=](const ValueReader& number, std::string_view part, physics::Tilt& tilt) {
            if (part == "0") {
              tilt.angle = number.number(kAngles);
            } else if (part == "1") {
              tilt.axis = choiceFrom(number, kAxes);
            } else {
              number.mismatch(kExpected);
            }
          }};
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return "[" + joined({tomlNumber(vector.x()), tomlNumber(vector.y()), tomlNumber(vector.z())}) +
         "]";
}

}  // namespace rotatebook::scene
