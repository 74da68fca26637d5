#include "scene/keys/moments.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "base/document/toml_text.h"
#include "base/parsed_number.h"
#include "base/units.h"
#include "scene/names.h"

namespace rotatebook::scene {
namespace {

using document::NumberRange;
using document::ValueReader;

constexpr double kLatest = 1e100;  // [s]
constexpr NumberRange kMomentTimes{kExpectedMoments, 0, kLatest, Dimension::Time};

constexpr std::array<Named<Event>, 4> kEvents{{
    {"flip", Event::Flip},
    {"nudge", Event::Nudge},
    {"burst", Event::Burst},
    {"end", Event::End},
}};

bool isCounted(Event event) {
  return event == Event::Flip || event == Event::Nudge;
}

/// Reads "flip 2" or "end"; returns whether it is an event.
bool readEvent(std::string_view text, Moment& moment) {
  const std::size_t space = text.find(' ');
  for (const auto& [name, event] : kEvents) {
    if (text.substr(0, space) != name || isCounted(event) != (space != text.npos)) continue;
    moment.event = event;
    if (!isCounted(event)) return true;
    moment.number = parsedNumber<int>(text.substr(space + 1)).value_or(0);
    return moment.number >= 1;
  }
  return false;
}

/// Cuts "0.5 s before " or "1 s after " off `text`; returns nothing if that isn't a time.
std::optional<double> takeOffset(std::string_view& text) {
  for (const auto& [word, sign] : {std::pair{std::string_view(" before "), -1}, {" after ", 1}}) {
    const std::size_t at = text.find(word);
    if (at == text.npos) continue;
    const auto time = parseQuantity(text.substr(0, at), Dimension::Time);
    text.remove_prefix(at + word.size());
    if (!time || !(0 <= *time && *time <= kLatest)) return std::nullopt;
    return sign * *time;
  }
  return 0;
}

}  // namespace

bool isOfEvent(const ValueReader& value) {
  const auto* text = std::get_if<std::string>(&value.node().value);
  return text != nullptr && !parseQuantity(*text, Dimension::Time);
}

Moment momentFrom(const ValueReader& value) {
  Moment moment;
  if (!isOfEvent(value)) {
    moment.offset = value.number(kMomentTimes);
    return moment;
  }
  std::string_view text = std::get<std::string>(value.node().value);
  constexpr std::string_view kOf = " of ";
  if (const std::size_t of = text.find(kOf); of != text.npos) {
    moment.label = text.substr(of + kOf.size());
    text = text.substr(0, of);
  }
  const std::optional<double> offset = takeOffset(text);
  if (!offset || !readEvent(text, moment)) value.mismatch(kExpectedMoments);
  moment.offset = *offset;
  return moment;
}

std::string eventText(const Moment& moment) {
  std::string text(nameOf(kEvents, moment.event));
  if (isCounted(moment.event)) text += " " + std::to_string(moment.number);
  return text + (moment.label.empty() ? "" : " of " + moment.label);
}

std::string momentText(const Moment& moment) {
  using document::tomlNumber;
  if (moment.event == Event::Start) return tomlNumber(moment.offset);
  std::string text = eventText(moment);
  if (moment.offset != 0) {
    text = tomlNumber(std::fabs(moment.offset)) + " s " +
           (moment.offset < 0 ? "before " : "after ") + text;
  }
  return document::tomlString(text);
}

}  // namespace rotatebook::scene
