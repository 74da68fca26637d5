// What draws each overlay, and where: a row each. Inside the room only.
#pragma once

#include <memory>
#include <span>

#include "overlay/box.h"
#include "overlay/drawn_overlay.h"
#include "scene/overlays.h"

namespace rotatebook::overlay {

/// Where an overlay is drawn.
enum class Placement {
  WholePicture,   ///< Over the whole picture of a clip, by overlay::CaptionAndClock.
  TopLeft,        ///< Below the words at the top left; DrawnOverlay::box() is what it takes there.
  Book,           ///< On and about the book.
  BookAndLegend,  ///< The same, with a legend in Layout::legend: one alone.
  Square,         ///< In Layout::square: one alone.
  Chart,          ///< In one of Layout::charts.
};

/// Makes a overlay whose place, where it has one, is in that box.
using MakeOverlay = std::unique_ptr<DrawnOverlay> (*)(const OverlayContext& context,
                                                      const Box& box);

/// One overlay.
struct OverlayRow {
  scene::Overlay overlay;
  Placement placement;
  MakeOverlay make = nullptr;  ///< None of Placement::WholePicture.
};

/// One for each overlay, the lowest first: those on the book in the order in which they are drawn,
/// then the others likewise.
std::span<const OverlayRow> overlayRows();

}  // namespace rotatebook::overlay
