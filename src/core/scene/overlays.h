// The overlays that can be drawn over the pictures: their names in scenes, and where each is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "physics/motion_settings.h"

namespace rotatebook::scene {

/// An overlay: something drawn over the pictures. Each has a row in overlay_list.inc.
enum class Overlay {
#define ROTATEBOOK_OVERLAY(enumerator, ...) enumerator,
#include "scene/overlay_list.inc"
#undef ROTATEBOOK_OVERLAY
};

/// The models that an overlay applies to.
enum class OverlayModels {
  All,
  Particles,  ///< Model::Particles alone, of eight.
  Rigid,      ///< All but Model::Particles.
  Stepwise,   ///< All but Model::Exact: the overlay shows the difference from it.
};

/// The part of a picture on which an overlay is drawn.
enum class Placement {
  WholeClip,      ///< The whole picture of a clip, once for all motions.
  TopLeft,        ///< Below the text at the top left.
  Body,           ///< On and around the body.
  BodyAndLegend,  ///< Like Body, with a legend beside it: one overlay at a time.
  Square,         ///< A square inset: only one overlay.
  Chart,          ///< One of the charts over time.
};

/// A row of overlay_list.inc.
struct OverlayRow {
  std::string_view name;  ///< Name in a scene's overlay.show.
  Overlay overlay = Overlay::Caption;
  OverlayModels models = OverlayModels::All;
  Placement placement = Placement::WholeClip;
};

/// The rows, in drawing order, which is the order of Overlay.
inline constexpr std::array kOverlayRows{
#define ROTATEBOOK_OVERLAY(enumerator, word, models, placement) \
  OverlayRow{word, Overlay::enumerator, OverlayModels::models, Placement::placement},
#include "scene/overlay_list.inc"
#undef ROTATEBOOK_OVERLAY
};

/// Returns the row of `overlay`.
constexpr const OverlayRow& rowOf(Overlay overlay) {
  return kOverlayRows[static_cast<std::size_t>(overlay)];
}

/// Returns whether `overlay` is drawn on or around the body, not beside it.
constexpr bool onTheBody(Overlay overlay) {
  const Placement placement = rowOf(overlay).placement;
  return placement == Placement::Body || placement == Placement::BodyAndLegend;
}

/// Returns whether motions with these settings have what `overlay` shows.
inline bool isFor(const physics::SimulationSettings& settings, Overlay overlay) {
  switch (rowOf(overlay).models) {
    case OverlayModels::Particles:
      return settings.model == physics::Model::Particles &&
             areEight(settings.particles.arrangement);
    case OverlayModels::Rigid:
      return settings.model != physics::Model::Particles;
    case OverlayModels::Stepwise:
      return settings.model != physics::Model::Exact;
    case OverlayModels::All:
      break;
  }
  return true;
}

}  // namespace rotatebook::scene
