// The keys of [body], [initial] and [[nudge]]: what moves.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/elementary.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "rigid/inertia.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

using Limits = std::numeric_limits<double>;
using document::kNumber;
using document::TomlNode;
using physics::InitialSpin;
using physics::MotionSettings;

constexpr NumberRange kSizes{"three lengths from 1e-6 to 1e6 m", 1e-6, 1e6, Dimension::Length};
constexpr NumberRange kMass{"a mass from 1e-9 to 1e9 kg", 1e-9, 1e9, Dimension::Mass};
constexpr NumberRange kMoments{"three moments of inertia up to 1e21 kg m^2", -1e21, 1e21};
constexpr NumberRange kRow{"rows of three numbers up to 1e21 kg m^2", -1e21, 1e21};
constexpr NumberRange kNudgeTimes{"a time over 0 and up to 1e100 s", Limits::denorm_min(), 1e100,
                                  Dimension::Time};

rigid::Inertia inertiaFrom(const ValueReader& value) {
  const auto rows = value.elements(
      3, "three moments, [Ix, Iy, Iz], or a tensor of three rows, [[Ixx, Ixy, Ixz], ...]");
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  if (std::holds_alternative<TomlNode::Array>(rows.front().node().value)) {
    for (int row = 0; row < 3; ++row) {
      tensor.row(row) = vectorFrom(rows[static_cast<std::size_t>(row)], kRow).transpose();
    }
  } else {
    tensor.diagonal() = vectorFrom(value, kMoments);
  }
  return failAtValue(value, [&] { return rigid::checkedInertia(tensor); });
}

void readMoment(const ValueReader& number, std::string_view part, const ValueForm&,
                rigid::Inertia& inertia) {
  Eigen::Matrix3d tensor = inertia.tensor();
  Eigen::Vector3d moments = tensor.diagonal();
  readElement(number, part, kMoments, moments);
  tensor.diagonal() = moments;
  inertia = failAtValue(number, [&] { return rigid::checkedInertia(tensor); });
}

std::string inertiaText(const rigid::Inertia& inertia) {
  const Eigen::Matrix3d& tensor = inertia.tensor();
  if (tensor.isDiagonal(0)) return vectorText(tensor.diagonal());
  return "[" +
         joined({vectorText(tensor.row(0)), vectorText(tensor.row(1)), vectorText(tensor.row(2))}) +
         "]";
}

constexpr double kMinAttitude = 1e-30;  // the length of a quaternion
constexpr NumberRange kParts{"four numbers from -1e9 to 1e9", -1e9, 1e9};

/// Reads a quaternion, or an angle about an axis.
Eigen::Vector4d attitudeFrom(const ValueReader& value) {
  constexpr const char* kExpected =
      "the quaternion [w, x, y, z], or an angle and an axis, such as [\"90 deg\", \"x\"]";
  Eigen::Vector4d attitude = Eigen::Vector4d::Zero();
  const auto* array = std::get_if<TomlNode::Array>(&value.node().value);
  if (array != nullptr && array->size() == 2) {
    const physics::Tilt turn = tiltFrom(value);
    attitude[0] = cosine(turn.angle / 2);
    attitude[1 + turn.axis] = sine(turn.angle / 2);
    return attitude;
  }
  const auto parts = value.elements(4, kExpected);
  for (Eigen::Index i = 0; i < 4; ++i)
    attitude[i] = parts[static_cast<std::size_t>(i)].number(kParts);
  if (!(attitude.stableNorm() > kMinAttitude)) value.mismatch(kExpected);
  return attitude;
}

std::string attitudeText(const Eigen::Vector4d& attitude) {
  std::vector<std::string> parts;
  for (const double part : attitude) parts.push_back(tomlNumber(part));
  return "[" + joined(parts) + "]";
}

constexpr NumberRange kRates{"a number from -1e9 to 1e9 other than 0", -1e9, 1e9};
constexpr std::array<Named<int>, 3> kRanks{{{"smallest", 0}, {"middle", 1}, {"largest", 2}}};

/// Reads { about = "middle", value = 4 }, the axis by its moment.
physics::SpinAbout aboutFrom(const ValueReader& value, physics::SpinKind kind) {
  physics::SpinAbout about;
  NumberRange range = kRates;
  if (kind == physics::SpinKind::AngularVelocity) range.dimension = Dimension::AngularVelocity;
  value.readTable(
      {{"about", [&](const ValueReader& rank) { about.rank = choiceFrom(rank, kRanks); }},
       {"value", [&](const ValueReader& rate) { about.rate = rate.number(range); }}});
  if (!value.find("about") || about.rate == 0)
    value.mismatch("three numbers, or a table such as { about = \"middle\", value = 4.0 }");
  return about;
}

/// Refuses a text such as "48 rpm", which says no axis.
[[noreturn]] void refuseText(const ValueReader& value, physics::SpinKind kind) {
  const bool isVelocity = kind == physics::SpinKind::AngularVelocity;
  const std::string& text = std::get<std::string>(value.node().value);
  const auto units = unitsOf(Dimension::AngularVelocity);
  const bool isSpeed = isVelocity && parseQuantity(text, Dimension::AngularVelocity);
  value.fail(value.name() + " = " + describe(value.node()) +
             " names no axis; write three numbers, such as [5, 0, 0], or { about = \"middle\", "
             "value = " +
             (isSpeed      ? describe(value.node())
              : isVelocity ? "\"48 rpm\""
                           : "0.03") +
             " }" + (!isVelocity || isUnit(unitIn(text)) ? "" : didYouMean(unitIn(text), units)));
}

std::string aboutText(const physics::SpinAbout& about) {
  return "{ about = " + quotedName(kRanks, about.rank) + ", value = " + tomlNumber(about.rate) +
         " }";
}

template <physics::SpinKind kKind, typename S>
void readSpin(const ValueReader& value, const ValueForm& form, S& spin) {
  spin.kind = kKind;
  if constexpr (std::is_same_v<S, InitialSpin>) {
    spin.about.reset();
    if (std::holds_alternative<TomlNode::Table>(value.node().value)) {
      spin.about = aboutFrom(value, kKind);
      return;
    }
  }
  if (std::holds_alternative<std::string>(value.node().value)) refuseText(value, kKind);
  spin.value = directionOf(value, form);
}

template <physics::SpinKind kKind, typename S>
std::string spinText(const S& spin) {
  if (spin.kind != kKind) return "";
  if constexpr (std::is_same_v<S, InitialSpin>) {
    if (spin.about) return aboutText(*spin.about);
  }
  return vectorText(spin.value);
}

template <typename S>
void readSpinElement(const ValueReader& number, std::string_view part, const ValueForm& form,
                     S& spin) {
  readElement(number, part, rangeOf(form), spin.value);
  requireDirection(number, spin.value, rangeOf(form));
}

/// Returns the row of a key of one of the kinds in which the spin S is given.
template <physics::SpinKind kKind, typename S>
constexpr Key<S> spinKey(KeyText documentation) {
  constexpr bool kIsVelocity = kKind == physics::SpinKind::AngularVelocity;
  documentation.comment = kIsVelocity ? "rad/s" : "kg m^2/s";
  documentation.unit = kIsVelocity ? "rad/s" : "kg m²/s";
  documentation.models = kOfComputed;
  ValueForm form = formOf(ValueForm::Type::Vector, kDirections);
  if (kIsVelocity) form.dimension = Dimension::AngularVelocity;
  form.kinds = kTableKind;
  return {nameOf(kSpinKinds, kKind), form,          readSpin<kKind, S>,
          spinText<kKind, S>,        documentation, readSpinElement<S>};
}

/// Returns the rows of the keys of a spin S, of which just one is stated.
template <typename S>
constexpr Key<S> velocityKey(std::string_view meaning) {
  return spinKey<physics::SpinKind::AngularVelocity, S>(
      {.meaning = meaning, .byDefault = "required, unless the next is given"});
}
template <typename S>
constexpr Key<S> momentumKey(std::string_view meaning) {
  return spinKey<physics::SpinKind::AngularMomentum, S>(
      {.meaning = meaning, .byDefault = "required, unless the one before is given"});
}

std::string labelFrom(const ValueReader& value, const ValueForm& form) {
  std::string label = textFrom(value, form);
  if (label.empty()) value.mismatch("a string that isn't empty");
  return label;
}

}  // namespace

Keys<MotionSettings> bodyKeys() {
  static constexpr std::array keys{
      vector<Within<&MotionSettings::body, &body::Cuboid::size>{}>(
          "size", kSizes,
          {.comment = "m, along x (from the spine), y (to the top), z (to the cover)",
           .meaning = "along x, y, z"}),
      number<Within<&MotionSettings::body, &body::Cuboid::mass>{}>(
          "mass", kMass, {.comment = "kg", .meaning = "in all"}),
      own<&MotionSettings::inertia, inertiaFrom, inertiaText, readMoment>(
          "inertia", kListKind, "three moments, or a symmetric 3x3 tensor",
          {.comment = "kg m^2, in place of the solid cuboid's",
           .meaning = "about the book's axes",
           .byDefault = "the solid cuboid's",
           .unit = "kg m²",
           .models = kOfRigid}),
  };
  return keys;
}

Keys<InitialSpin> initialKeys() {
  static constexpr std::array keys{
      velocityKey<InitialSpin>("at the start"),
      momentumKey<InitialSpin>("at the start"),
      angleAboutAxis<&InitialSpin::tilt>(
          "tilt", {.comment = "rad, and the axis toward which the spin is turned",
                   .meaning = "turns the vector given above toward the axis",
                   .byDefault = "none",
                   .models = kOfComputed}),
      own<&InitialSpin::attitude, attitudeFrom, attitudeText>(
          "attitude", kListKind, "the quaternion [w, x, y, z], or an angle and an axis",
          {.meaning = "how the book lies at the start: a turn from upright, facing +z; the spin is "
                      "along its axes",
           .byDefault = "upright",
           .models = kOfComputed}),
  };
  return keys;
}

Keys<physics::Nudge> nudgeKeys() {
  static constexpr std::array keys{
      number<&physics::Nudge::at>("at", kNudgeTimes,
                                  {.comment = "s, of simulated time",
                                   .meaning = "when, of simulated time",
                                   .byDefault = "required",
                                   .models = kOfComputed}),
      velocityKey<physics::Nudge>("what is added to the spin"),
      momentumKey<physics::Nudge>("what is added to it"),
      choice<&physics::Nudge::axes, kNudgeAxes>(
          "axes", {.meaning = "the axes that it is along, at that moment", .models = kOfComputed}),
  };
  return keys;
}

Keys<Panel> panelKeys() {
  static constexpr std::array keys{
      key<&Panel::label, labelFrom, tomlString>(
          "label", textForm(kLongestLabel),
          {.meaning = "shown in the picture and the report, and part of the CSV file's name",
           .byDefault = "required",
           .affects = Affects::Text}),
      choice<&Panel::frame, kFrames>(
          "frame", {.meaning = "the reference frame that the camera turns with in this panel",
                    .byDefault = "as `camera.frame`",
                    .affects = Affects::Picture}),
  };
  return keys;
}

}  // namespace rotatebook::scene
