#include "scene/map_settings.h"

#include <array>

#include "base/elementary.h"

namespace rotatebook::scene {
namespace {

struct NumberRow {
  std::string_view name;
  std::string_view meaning;
  std::string_view label;
};

/// Rows in the order of the enumeration.
constexpr std::array<NumberRow, 5> kNumberRows{{
    {"energy_drift", "\\|energy / energy at the start - 1\\|", "|E / E₀ − 1|"},
    {"first_flip", "time at which the first half-turn is made [s]", "first half-turn  [s]"},
    {"flip_interval",
     "mean time between sign changes of the angular velocity about the median axis [s]",
     "time from flip to flip  [s]"},
    {"turned_deg",
     "angle between the body's line along its first spin and where that line was at the start "
     "[degrees]",
     "turned away from where it was  [degrees]"},
    {"growth",
     "rate at which a tilt from the median axis grows, √((I₂−I₁)(I₃−I₂)/(I₁I₃)), in e-folds for "
     "each radian of the spin; no motion is run",
     "growth of a tilt  [e-folds per radian of spin]"},
}};

/// Labels of quantities at one moment, in the order of the enumeration.
constexpr std::array<std::string_view, 10> kLabels{"flips",
                                                   "tilt  [degrees]",
                                                   "E / E₀",
                                                   "rotational E / E₀",
                                                   "L / L₀",
                                                   "stretch",
                                                   "angle to the exact motion  [degrees]",
                                                   "regime",
                                                   "drift of the centre  [m]",
                                                   "diverges at  [s]"};

const NumberRow& rowOf(MapNumber number) {
  return kNumberRows[static_cast<std::size_t>(number)];
}

/// Narrows an axis to what is seen of it at a part of the zoom, 0 to 1, to `ends`.
void zoom(MapAxis& axis, const std::vector<double>& ends, double part) {
  if (ends.empty()) return;
  const double from = shareOf(ends[0], axis.from, axis.to, axis.scale);
  const double width = shareOf(ends[1], axis.from, axis.to, axis.scale) - from;
  if (!(width < 1)) return;
  // Each moment the width shrinks by the same ratio, about the point that stays where it is.
  const double widthNow = exponential(part * logarithm(width));
  const double fromNow = from / (1 - width) * (1 - widthNow);
  const MapAxis whole = axis;
  axis.from = numberWithin(whole.from, whole.to, fromNow, whole.scale);
  axis.to = numberWithin(whole.from, whole.to, fromNow + widthNow, whole.scale);
}

}  // namespace

std::string nameOf(MapMeasure measure) {
  if (const auto* quantity = std::get_if<Quantity>(&measure)) return std::string(nameOf(*quantity));
  return std::string(rowOf(std::get<MapNumber>(measure)).name);
}

std::string meaningOf(MapMeasure measure) {
  if (const auto* quantity = std::get_if<Quantity>(&measure))
    return std::string(meaningOf(*quantity));
  return std::string(rowOf(std::get<MapNumber>(measure)).meaning);
}

std::string labelOf(MapMeasure measure) {
  if (const auto* quantity = std::get_if<Quantity>(&measure))
    return std::string(kLabels[static_cast<std::size_t>(*quantity)]);
  return std::string(rowOf(std::get<MapNumber>(measure)).label);
}

std::span<const MapMeasure> allMapMeasures() {
  static const std::vector<MapMeasure> all = [] {
    std::vector<MapMeasure> measures;
    for (const Quantity quantity : allQuantities()) measures.emplace_back(quantity);
    for (std::size_t i = 0; i < kNumberRows.size(); ++i) {
      measures.emplace_back(static_cast<MapNumber>(i));
    }
    return measures;
  }();
  return all;
}

bool isOfTheWay(MapMeasure measure) {
  return measure == MapMeasure(Quantity::DivergesAt) ||
         measure == MapMeasure(MapNumber::FirstFlip) ||
         measure == MapMeasure(MapNumber::FlipInterval);
}

MapSettings mapOfFilm(const MapSettings& map, double share) {
  MapSettings now = map;
  now.film.reset();
  const double part = share * share * (3 - 2 * share);
  zoom(now.x, map.film->x, part);
  zoom(now.y, map.film->y, part);
  std::erase_if(now.marks,
                [&](const MapMark& mark) { return !now.x.holds(mark.x) || !now.y.holds(mark.y); });
  return now;
}

}  // namespace rotatebook::scene
