#include "overlay/overlay_rows.h"

#include <algorithm>
#include <array>
#include <concepts>

#include "overlay/arrows.h"
#include "overlay/ghost.h"
#include "overlay/motion_text.h"
#include "overlay/polhode_inset.h"
#include "overlay/springs.h"
#include "overlay/strip_chart.h"

namespace rotatebook::overlay {
namespace {

using scene::Overlay;

template <std::derived_from<DrawnOverlay> T>
std::unique_ptr<DrawnOverlay> make(const OverlayContext& context, const Box& box) {
  if constexpr (std::constructible_from<T, const OverlayContext&, const Box&>) {
    return std::make_unique<T>(context, box);
  } else {
    return std::make_unique<T>(context);
  }
}

constexpr std::array<OverlayRow, scene::kOverlayCount> kRows{{
    {Overlay::Springs, Placement::BookAndLegend, make<Springs>},
    {Overlay::Ghost, Placement::Book, make<Ghost>},
    {Overlay::Axes, Placement::Book, make<Axes>},
    {Overlay::Trail, Placement::Book, make<Trail>},
    {Overlay::Momentum, Placement::Book, makeMomentum},
    {Overlay::Omega, Placement::Book, makeOmega},
    {Overlay::HalfTurns, Placement::TopLeft, make<HalfTurns>},
    {Overlay::Polhode, Placement::Square, makePolhodeInset},
    {Overlay::Energy, Placement::Chart, makeEnergyChart},
    {Overlay::Error, Placement::Chart, makeErrorChart},
    {Overlay::Caption, Placement::WholeClip},
    {Overlay::Clock, Placement::WholeClip},
}};

constexpr bool isOnTheBook(const OverlayRow& row) {
  return row.placement == Placement::Book || row.placement == Placement::BookAndLegend;
}

static_assert(std::ranges::all_of(scene::kOverlayRows,
                                  [](const scene::OverlayRow& overlay) {
                                    return std::ranges::count(kRows, overlay.overlay,
                                                              &OverlayRow::overlay) == 1;
                                  }),
              "an overlay of scene/overlays.h has no row here");
static_assert(std::ranges::all_of(kRows,
                                  [](const OverlayRow& row) {
                                    return isOnTheBook(row) == rowOf(row.overlay).onTheBook;
                                  }),
              "a row and scene/overlays.h differ on what is on the book");
static_assert(std::ranges::count(kRows, Placement::Square, &OverlayRow::placement) == 1 &&
                  std::ranges::count(kRows, Placement::BookAndLegend, &OverlayRow::placement) == 1,
              "layOut() has only one box for each of these");

}  // namespace

std::span<const OverlayRow> overlayRows() {
  return kRows;
}

}  // namespace rotatebook::overlay
