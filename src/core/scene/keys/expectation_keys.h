// Reads and prints expectations: of [expect], and of [grid] and [study], where they may be of some
// values of the axes. Inside the room only.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/axis.h"
#include "scene/expectation.h"
#include "scene/keys/axis_keys.h"
#include "scene/keys/kinds.h"

namespace rotatebook::scene {

/// One key for each quantity, in the order of the enumeration.
Keys<std::vector<Expectation>> expectKeys();

/// Returns the measure that a value names, one that `sections` take. Throws InputError.
Measure measureFrom(const ValueReader& value, MeasureSections sections);

/// The keys of a place on an axis, "column", and of the axis itself, "columns".
struct PlaceKeys {
  const char* place;
  const char* axis;
};

/// The expectations of a section whose axes are two.
struct PlacedExpectations {
  std::array<PlaceKeys, 2> keys;
  bool haveWindows;  ///< A window and what is reached in it may be stated, too.
  MeasureSections measures;
  const char* expected;  ///< In messages: "tables such as ...".

  /// Returns the rows of an expectation's keys.
  std::vector<KeyRow> rows() const;
  /// Reads a list of expectations. Throws InputError.
  std::vector<Expectation> read(const ValueReader& value) const;
  std::string text(const std::vector<Expectation>& all) const;
  /// Throws InputError if any of the section's is of no value of the axes, which may be null.
  void check(const ValueReader& section, const std::array<const Axis*, 2>& axes) const;
};

inline constexpr PlacedExpectations kGridExpectations{
    {{{"column", "columns"}, {"row", "rows"}}},
    true,
    MeasureSections::All,
    "tables such as { of = \"half_turns\", column = 10, min = 3 }"};
inline constexpr PlacedExpectations kStudyExpectations{
    {{{"x", "x"}, {"curve", "curves"}}},
    false,
    MeasureSections::Studies,
    "tables such as { of = \"diverges_at\", x = 10, min = 20 }"};

template <const PlacedExpectations& kPlaced>
std::vector<Expectation> placedFrom(const ValueReader& value) {
  return kPlaced.read(value);
}
template <const PlacedExpectations& kPlaced>
std::vector<KeyRow> placedRows() {
  return kPlaced.rows();
}
template <const PlacedExpectations& kPlaced>
std::string placedText(const std::vector<Expectation>& all) {
  return kPlaced.text(all);
}

template <auto kMember, const PlacedExpectations& kPlaced>
constexpr auto placedExpectations(std::string_view name, const KeyText& documentation) {
  return key<kMember, placedFrom<kPlaced>, placedText<kPlaced>>(
      name, tableForm(kListKind, kPlaced.expected, placedRows<kPlaced>), documentation);
}

/// Keys of bounds on a number.
Keys<Bounds> boundKeys();
/// Throws InputError if `bounds`, read from `value`, are none, or in the wrong order.
void checkBounds(const ValueReader& value, const Bounds& bounds);

}  // namespace rotatebook::scene
