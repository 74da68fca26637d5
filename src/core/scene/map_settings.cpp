#include "scene/map_settings.h"

#include "base/elementary.h"

namespace rotatebook::scene {
namespace {

/// Narrows an axis to what is seen of it at a part of the zoom, 0 to 1, to `ends`.
void zoom(Axis& axis, const std::vector<double>& ends, double part) {
  if (ends.empty()) return;
  const double from = shareOf(ends[0], axis.from, axis.to, axis.scale);
  const double width = shareOf(ends[1], axis.from, axis.to, axis.scale) - from;
  if (!(width < 1)) return;
  // Each moment the width shrinks by the same ratio, about the point that stays where it is.
  const double widthNow = exponential(part * logarithm(width));
  const double fromNow = from / (1 - width) * (1 - widthNow);
  const Axis whole = axis;
  axis.from = numberWithin(whole.from, whole.to, fromNow, whole.scale);
  axis.to = numberWithin(whole.from, whole.to, fromNow + widthNow, whole.scale);
}

}  // namespace

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
