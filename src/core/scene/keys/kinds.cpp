#include "scene/keys/kinds.h"

#include "base/elementary.h"
#include "base/text.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

constexpr double kShortestDirection = 1e-30;
constexpr NumberRange kTiltAngles{"an angle from -1e6 to 1e6 rad", -kLargestAngle, kLargestAngle,
                                  Dimension::Angle};

}  // namespace

int integerFrom(const ValueReader& value, const ValueForm& form) {
  return value.integer(static_cast<int>(form.min), static_cast<int>(form.max));
}

std::string integerText(int value) {
  return std::to_string(value);
}

double numberFrom(const ValueReader& value, const ValueForm& form) {
  return value.number(rangeOf(form));
}

bool flagFrom(const ValueReader& value) {
  const bool* flag = std::get_if<bool>(&value.node().value);
  if (flag == nullptr) value.mismatch(kFlags);
  return *flag;
}

std::string textFrom(const ValueReader& value, const ValueForm& form) {
  return value.text(static_cast<std::size_t>(form.max));
}

std::string linesFrom(const ValueReader& value, const ValueForm& form) {
  return value.lines(static_cast<std::size_t>(form.max));
}

std::string optionalText(const std::string& text) {
  return text.empty() ? "" : tomlString(text);
}

void readElement(const ValueReader& number, std::string_view part, const NumberRange& range,
                 Eigen::Vector3d& into) {
  const bool isElement = part == "0" || part == "1" || part == "2";
  if (!isElement)
    number.fail(number.name() + " has the numbers 0, 1 and 2, and no " + tomlString(part));
  into[part[0] - '0'] = number.number(range);
}

void readElementOf(const ValueReader& number, std::string_view part, const ValueForm& form,
                   Eigen::Vector3d& into) {
  readElement(number, part, rangeOf(form), into);
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

Eigen::Vector3d vectorOf(const ValueReader& value, const ValueForm& form) {
  return vectorFrom(value, rangeOf(form));
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return "[" + joined({tomlNumber(vector.x()), tomlNumber(vector.y()), tomlNumber(vector.z())}) +
         "]";
}

Eigen::Vector3d directionFrom(const ValueReader& value, const NumberRange& range) {
  const Eigen::Vector3d direction = vectorFrom(value, range);
  requireDirection(value, direction, range);
  return direction;
}

Eigen::Vector3d directionOf(const ValueReader& value, const ValueForm& form) {
  return directionFrom(value, rangeOf(form));
}

void requireDirection(const ValueReader& value, const Eigen::Vector3d& direction,
                      const NumberRange& range) {
  if (direction.isZero(0)) value.mismatch(std::string(range.expected));
  if (direction.stableNorm() < kShortestDirection) {
    value.mismatch("at least " + tomlNumber(kShortestDirection) + " long");
  }
}

Rgb colourFrom(const ValueReader& value) {
  const auto* text = std::get_if<std::string>(&value.node().value);
  const std::optional<Rgb> colour = text ? parseRgb(*text) : std::nullopt;
  if (!colour) value.mismatch(kColours);
  return *colour;
}

std::string colourText(const Rgb& colour) {
  return tomlString(textOf(colour));
}

physics::Tilt tiltFrom(const ValueReader& value) {
  const auto parts = value.elements(2, kExpectedTilt);
  physics::Tilt tilt;
  readEach(parts, [&](const ValueReader& part) {
    if (&part == &parts[0]) tilt.angle = part.number(kTiltAngles);
    if (&part == &parts[1]) tilt.axis = choiceFrom(part, kAxes);
  });
  return tilt;
}

std::string tiltText(const physics::Tilt& tilt) {
  return "[" + tomlNumber(tilt.angle) + ", " + quotedName(kAxes, tilt.axis) + "]";
}

void readTiltPart(const ValueReader& number, std::string_view part, const ValueForm& form,
                  physics::Tilt& tilt) {
  if (part == "0") {
    tilt.angle = number.number(kTiltAngles);
  } else if (part == "1") {
    tilt.axis = choiceFrom(number, kAxes);
  } else {
    number.mismatch(std::string(form.expected));
  }
}

}  // namespace rotatebook::scene
