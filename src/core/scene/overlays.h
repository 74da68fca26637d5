// The overlays that can be drawn over the pictures, and their names in scenes: one row each.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "physics/motion_settings.h"

namespace rotatebook::scene {

/// An overlay: something drawn over the pictures.
enum class Overlay {
  Caption,    ///< Title, caption, and how the motion was simulated; at the bottom.
  Clock,      ///< Simulated time; at the top left.
  Axes,       ///< The body's axes, labelled.
  Omega,      ///< An arrow along the angular velocity.
  Momentum,   ///< An arrow along the angular momentum.
  Trail,      ///< The path of the angular velocity's tip.
  Polhode,    ///< An inset: the energy ellipsoid, the momentum sphere, and their intersection.
  Energy,     ///< A chart: kinetic, spring and total energy over time.
  Error,      ///< A chart: the angle to the exact motion.
  HalfTurns,  ///< The number of half-turns so far; at the top left.
  Springs,    ///< The springs, coloured by strain.
  Ghost,      ///< The exact motion's outline. Stays last: kOverlayCount depends on it.
};

inline constexpr std::size_t kOverlayCount = static_cast<std::size_t>(Overlay::Ghost) + 1;

/// The models that an overlay applies to.
enum class OverlayModels {
  All,
  Particles,  ///< Model::Particles alone.
  Stepwise,   ///< All but Model::Exact: the overlay shows the difference from it.
};

/// A row of the table of overlays.
struct OverlayRow {
  std::string_view name;  ///< Name in a scene's overlay.show.
  Overlay overlay = Overlay::Caption;
  OverlayModels models = OverlayModels::All;
  bool onTheBook = false;  ///< True if it is drawn on or around the book, not beside it.
};

/// The rows, in the order of Overlay. The rows of overlay/overlay_rows.cpp say what draws each.
inline constexpr std::array<OverlayRow, kOverlayCount> kOverlayRows{{
    {"caption", Overlay::Caption},
    {"clock", Overlay::Clock},
    {"axes", Overlay::Axes, OverlayModels::All, true},
    {"omega", Overlay::Omega, OverlayModels::All, true},
    {"momentum", Overlay::Momentum, OverlayModels::All, true},
    {"trail", Overlay::Trail, OverlayModels::All, true},
    {"polhode", Overlay::Polhode},
    {"energy", Overlay::Energy},
    {"error", Overlay::Error, OverlayModels::Stepwise},
    {"half_turns", Overlay::HalfTurns},
    {"springs", Overlay::Springs, OverlayModels::Particles, true},
    {"ghost", Overlay::Ghost, OverlayModels::Stepwise, true},
}};

/// Returns the row of `overlay`.
constexpr const OverlayRow& rowOf(Overlay overlay) {
  return kOverlayRows[static_cast<std::size_t>(overlay)];
}

static_assert(
    [] {
      for (std::size_t i = 0; i < kOverlayCount; ++i) {
        const auto overlay = static_cast<Overlay>(i);
        if (rowOf(overlay).overlay != overlay || rowOf(overlay).name.empty()) return false;
      }
      return true;
    }(),
    "an overlay has no row, or the rows aren't in the order of Overlay");

/// Returns whether motions of `model` have what `overlay` shows.
constexpr bool isFor(physics::Model model, Overlay overlay) {
  switch (rowOf(overlay).models) {
    case OverlayModels::Particles:
      return model == physics::Model::Particles;
    case OverlayModels::Stepwise:
      return model != physics::Model::Exact;
    case OverlayModels::All:
      break;
  }
  return true;
}

}  // namespace rotatebook::scene
