// What draws each overlay, and where: a row each. Inside the room only.
#pragma once

#include <memory>
#include <span>

#include "overlay/box.h"
#include "overlay/mark.h"
#include "scene/overlays.h"

namespace rotatebook::overlay {

/// Where an overlay is drawn.
enum class Placement {
  Words,          ///< Over the whole picture of a clip, by overlay::Words.
  TopLeft,        ///< Below the words at the top left; Mark::box() is what it takes there.
  Book,           ///< On and about the book.
  BookAndLegend,  ///< The same, with a legend in Layout::legend: one alone.
  Square,         ///< In Layout::square: one alone.
  Chart,          ///< In one of Layout::charts.
};

/// Makes a mark whose place, where it has one, is in that box.
using MakeMark = std::unique_ptr<Mark> (*)(const MarkContext& context, const Box& box);

/// One overlay.
struct MarkRow {
  scene::Overlay overlay;
  Placement placement;
  MakeMark make = nullptr;  ///< None of Placement::Words.
};

/// One for each overlay, the lowest first: those on the book in the order in which they are drawn,
/// then the others likewise.
std::span<const MarkRow> markRows();

}  // namespace rotatebook::overlay
