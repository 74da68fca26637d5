// Colours of a map's values.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "image/image.h"
#include "scene/map_settings.h"
#include "study/map_result.h"

namespace rotatebook::plot {

/// Returns the colour of a palette at `share`, 0 to 1; of shares outside the nearest.
Rgb colourAt(scene::Palette palette, double share);

/// The colours of a map: the values' between its ends, and those of runs without a number.
class MapColouring {
 public:
  /// Takes the ends from the settings, or else the smallest and the largest value.
  MapColouring(const scene::MapColours& settings, const study::MapFacts& facts);

  Rgb of(double value) const;
  double from() const { return from_; }
  double to() const { return to_; }
  scene::Scale scale() const { return settings_.scale; }
  /// Returns the share of the palette at which a value is; outside 0 to 1 beyond its ends.
  double shareOf(double value) const;
  /// Returns the colour at such a share.
  Rgb at(double share) const {
    return colourAt(settings_.palette, settings_.reversed ? 1 - share : share);
  }

 private:
  scene::MapColours settings_;
  double from_, to_;
};

/// The colours of runs that never do what is measured, that diverged and that were refused. They
/// are in no palette.
inline constexpr Rgb kNeverColour{62, 72, 88};
inline constexpr Rgb kDivergedColour{94, 200, 255};
inline constexpr Rgb kRefusedColour{36, 39, 46};

/// Writes a colour as the three bytes of a pixel.
void putColour(const Rgb& colour, std::uint8_t* bytes);

/// Returns a panel's values with one pixel for each of those runs of which there is one in `stride`
/// across and up.
image::Image mapPixels(const std::vector<double>& values, const scene::MapSettings& map,
                       const MapColouring& colouring, int stride);

/// Returns the map with one pixel a run; panels side by side.
image::Image plainMap(const study::MapResult& result, const scene::MapSettings& map);

}  // namespace rotatebook::plot
