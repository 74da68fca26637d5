// [map]: what `rotatebook map` runs for each pixel of a picture, and what must come out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/axis.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// The time of the motions that a map measures.
enum class MapMoment {
  End,      ///< Their end.
  Largest,  ///< Of all samples the largest, as studies measure it.
};

/// A point that is marked on a map.
struct MapMark {
  double x = 0, y = 0;
  std::string label{};
  /// Moments of inertia, in any unit, whose ratios x and y are; none if these are stated.
  std::optional<std::vector<double>> moments{};

  friend bool operator==(const MapMark&, const MapMark&) = default;
};

/// The colours of a map, named as in the field.
enum class Palette {
  Inferno,   ///< Black over red to pale yellow.
  Viridis,   ///< Dark violet over green to yellow.
  Gray,      ///< Black to white.
  Coolwarm,  ///< Blue over grey to red: for values on both sides of one in the middle.
};

struct MapColours {
  Palette palette = Palette::Inferno;
  bool reversed = false;
  Scale scale = Scale::Linear;
  std::optional<double> from{};    ///< The value of the first colour; without it, the smallest.
  std::optional<double> to{};      ///< The value of the last colour; without it, the largest.
  std::vector<double> contours{};  ///< Values at which lines are drawn.

  friend bool operator==(const MapColours&, const MapColours&) = default;
};

/// A film of a map, which zooms from the whole map into a part of it, at a constant rate but for a
/// gentle start and end. It has the clip's frame rate.
struct MapFilm {
  std::vector<double> x{}, y{};  ///< The part's ends along each axis; empty for all of it.
  double duration = 10;          ///< [s]

  friend bool operator==(const MapFilm&, const MapFilm&) = default;
};

/// The outcome of one run.
enum class Outcome { Value, Never, Diverged, Refused };

/// Bounds on a number of a whole map.
struct MapExpectation {
  enum class Of { Smallest, Largest, Mean, Share, Value };

  Of of = Of::Largest;
  std::optional<Outcome> outcome{};         ///< For Share: of these runs.
  std::optional<double> over{}, under{};    ///< For Share: of runs with a value within.
  std::optional<std::vector<double>> at{};  ///< For Value: of the run at this x and y.
  std::optional<std::string> panel{};       ///< Of the panel with this label; without it, all.
  Bounds bounds{};

  friend bool operator==(const MapExpectation&, const MapExpectation&) = default;
};

/// A map: one run of the scene's motion for each pixel; of each panel, side by side.
struct MapSettings {
  Axis x, y;
  Measure measure = Measure::HalfTurns;
  MapMoment moment = MapMoment::End;
  int width = 960, height = 540;  ///< Runs across and up.
  /// Length of the motions, > 0; without it, the clip's. [s]
  std::optional<double> duration{};
  /// Time from one look at a motion to the next, > 0; without it, its timePerFrame. [s]
  std::optional<double> interval{};
  MapColours colours{};
  std::vector<MapMark> marks{};
  std::vector<MapExpectation> expected{};
  std::optional<MapFilm> film{};

  std::int64_t runs() const { return static_cast<std::int64_t>(width) * height; }
  /// Returns the axis along which time goes; null if none does.
  const Axis* timeAxis() const {
    return x.kind == AxisKind::Time ? &x : y.kind == AxisKind::Time ? &y : nullptr;
  }
  friend bool operator==(const MapSettings&, const MapSettings&) = default;
};

/// Returns the map that a film shows at `share`, 0 to 1, of its length; of the marks those that are
/// on it. Takes a map that has a film; the returned one has none.
MapSettings mapOfFilm(const MapSettings& map, double share);

/// Most runs of a map's panel, and of a side.
inline constexpr std::int64_t kMaxMapRuns = 100'000'000;
inline constexpr int kMaxMapSide = 16'384;

}  // namespace rotatebook::scene
