// The table of overlays: where each is drawn, and by what. Inside the room only.
#pragma once

#include <memory>
#include <span>

#include "overlay/box.h"
#include "overlay/drawn_overlay.h"
#include "scene/overlays.h"

namespace rotatebook::overlay {

/// The part of a picture on which an overlay is drawn.
enum class Placement {
  WholeClip,      ///< The whole picture of a clip, once for all motions, by CaptionAndClock.
  TopLeft,        ///< Below the text at the top left; DrawnOverlay::box() is what it takes there.
  Book,           ///< On and around the book.
  BookAndLegend,  ///< Like Book, with a legend in Layout::legend: only one overlay.
  Square,         ///< In Layout::square: only one overlay.
  Chart,          ///< In one of Layout::charts.
};

/// Makes an overlay in a box, if its placement has one.
using MakeOverlay = std::unique_ptr<DrawnOverlay> (*)(const OverlayContext& context,
                                                      const Box& box);

/// A row of the table.
struct OverlayRow {
  scene::Overlay overlay;
  Placement placement;
  MakeOverlay make = nullptr;  ///< Null for Placement::WholeClip.
};

/// Returns a row for each overlay in drawing order: first those on the book, then the others.
std::span<const OverlayRow> overlayRows();

}  // namespace rotatebook::overlay
