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

Eigen::Matrix3d inertiaFrom(const ValueReader& value) {
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
  failAtValue(value, [&] { rigid::checkInertia(tensor); });
  return tensor;
}

void readMoment(const ValueReader& number, std::string_view part, Eigen::Matrix3d& tensor) {
  Eigen::Vector3d moments = tensor.diagonal();
  readElement(number, part, kMoments, moments);
  tensor.diagonal() = moments;
  failAtValue(number, [&] { rigid::checkInertia(tensor); });
}

std::string inertiaText(const Eigen::Matrix3d& tensor) {
  if (tensor.isDiagonal(0)) return vectorText(tensor.diagonal());
  return "[" +
         joined({vectorText(tensor.row(0)), vectorText(tensor.row(1)), vectorText(tensor.row(2))}) +
         "]";
}

constexpr NumberRange kRates{"a number from -1e9 to 1e9, but not 0", -1e9, 1e9};
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

/// Returns a key of one of the kinds in which the spin S is given.
template <typename S>
Key<S> spinKey(physics::SpinKind kind, KeyText documentation) {
  const bool isVelocity = kind == physics::SpinKind::AngularVelocity;
  documentation.allowed = direction().allowed;
  documentation.comment = isVelocity ? "rad/s" : "kg m^2/s";
  documentation.unit = isVelocity ? "rad/s" : "kg m²/s";
  documentation.models = kOfComputed;
  NumberRange range = kDirections;
  if (isVelocity) range.dimension = Dimension::AngularVelocity;
  return {nameOf(kSpinKinds, kind),
          [kind, range](const ValueReader& value, S& spin) {
            spin.kind = kind;
            if constexpr (std::is_same_v<S, InitialSpin>) {
              spin.about.reset();
              if (std::holds_alternative<TomlNode::Table>(value.node().value)) {
                spin.about = aboutFrom(value, kind);
                return;
              }
            }
            if (std::holds_alternative<std::string>(value.node().value)) refuseText(value, kind);
            spin.value = directionFrom(value, range);
          },
          [kind](const S& spin) -> std::string {
            if (spin.kind != kind) return "";
            if constexpr (std::is_same_v<S, InitialSpin>) {
              if (spin.about) return aboutText(*spin.about);
            }
            return vectorText(spin.value);
          },
          std::move(documentation),
          formOf(ValueForm::Type::Vector, range),
          [range](const ValueReader& number, std::string_view part, S& spin) {
            readElement(number, part, range, spin.value);
            requireDirection(number, spin.value, range);
          }};
}

std::string labelFrom(const ValueReader& value) {
  std::string label = value.text(kLongestLabel);
  if (label.empty()) value.mismatch("a string that isn't empty");
  return label;
}

}  // namespace

const Keys<MotionSettings>& bodyKeys() {
  static const Keys<MotionSettings> keys{
      keyAt<MotionSettings>(
          "size", [](auto& motion) -> auto& { return motion.body.size; }, vector(kSizes),
          {.comment = "m, along x (from the spine), y (to the top), z (to the cover)",
           .meaning = "along x, y, z"}),
      keyAt<MotionSettings>("mass", [](auto& motion) -> auto& { return motion.body.mass; },
                            number(kMass), {.comment = "kg", .meaning = "in all"}),
      key("inertia", &MotionSettings::inertia,
          Kind<Eigen::Matrix3d>{inertiaFrom, inertiaText, "", "", {}, readMoment},
          {.comment = "kg m^2, in place of the solid cuboid's",
           .meaning = "about the book's axes",
           .byDefault = "the solid cuboid's",
           .allowed = "three moments, or a symmetric 3x3 tensor",
           .unit = "kg m²",
           .models = kOfRigid}),
  };
  return keys;
}

const Keys<InitialSpin>& initialKeys() {
  static const Keys<InitialSpin> keys{
      spinKey<InitialSpin>(
          physics::SpinKind::AngularVelocity,
          {.meaning = "at the start", .byDefault = "required, unless the next is given"}),
      spinKey<InitialSpin>(
          physics::SpinKind::AngularMomentum,
          {.meaning = "at the start", .byDefault = "required, unless the one before is given"}),
      key("tilt", &InitialSpin::tilt, angleAboutAxis(),
          {.comment = "rad, and the axis toward which the spin is turned",
           .meaning = "turns the vector given above toward the axis",
           .byDefault = "none",
           .models = kOfComputed}),
  };
  return keys;
}

const Keys<physics::Nudge>& nudgeKeys() {
  static const Keys<physics::Nudge> keys{
      key("at", &physics::Nudge::at, number(kNudgeTimes),
          {.comment = "s, of simulated time",
           .meaning = "when, of simulated time",
           .byDefault = "required",
           .models = kOfComputed}),
      spinKey<physics::Nudge>(physics::SpinKind::AngularVelocity,
                              {.meaning = "what is added to the spin",
                               .byDefault = "required, unless the next is given"}),
      spinKey<physics::Nudge>(physics::SpinKind::AngularMomentum,
                              {.meaning = "what is added to it",
                               .byDefault = "required, unless the one before is given"}),
      key("axes", &physics::Nudge::axes, oneOf(kNudgeAxes),
          {.meaning = "the axes that it is along, at that moment", .models = kOfComputed}),
  };
  return keys;
}

const Keys<Panel>& panelKeys() {
  static const Keys<Panel> keys{
      key("label", &Panel::label,
          Kind<std::string>{labelFrom, tomlString, document::expectedString(kLongestLabel)},
          {.meaning = "shown in the picture and the report, and part of the CSV file's name",
           .byDefault = "required",
           .affects = Affects::Text}),
  };
  return keys;
}

}  // namespace rotatebook::scene
