// Charts over the time of the clip. Inside the room only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// A number of each sample, and how it is drawn.
struct Series {
  std::string name;    ///< May be empty: no legend.
  std::string letter;  ///< In place of the name where there is no room.
  Colour colour;
  std::vector<double> values;
};

/// A level with its name at the left.
struct Tick {
  double value;
  std::string text;
};

/// What a chart shows; values beyond its range are drawn at its edge.
struct ChartContent {
  std::string title;
  std::string shortTitle;  ///< In its place where there is no room.
  double low = 0, high = 1;
  std::vector<Tick> ticks;     ///< The most important first: others give way.
  std::vector<Series> series;  ///< The last is above the others.
};

/// A chart from the clip's first frame to its last, drawn up to the present one.
class StripChart final : public DrawnOverlay {
 public:
  StripChart(const OverlayContext& context, const Box& box, const ChartContent& content);
  void draw(const View& view) override;

 private:
  Point placeOf(std::int64_t frame, double value) const;
  CachedLayer stillPart() const;
  CachedLayer curves() const;

  OverlayContext context_;
  Box box_;
  ChartContent content_;
  Box plot_;
  CachedLayer cached_;
  CachedLayer curves_;
};

/// Where the chart of this motion's energy ends if it stands alone, as a share of the start's
/// total.
double energyTop(const physics::Trajectory& trajectory);
/// Kinetic, spring and total energy as shares of the start's total, from 0 to `top`.
ChartContent energyContent(const OverlayContext& context, double top);
/// The angle to the exact motion.
ChartContent errorContent(const OverlayContext& context);

/// The chart of energyContent(), up to energyTop() or OverlayContext::energyTop, whichever is
/// higher.
std::unique_ptr<DrawnOverlay> makeEnergyChart(const OverlayContext& context, const Box& box);
/// The chart of errorContent().
std::unique_ptr<DrawnOverlay> makeErrorChart(const OverlayContext& context, const Box& box);

}  // namespace rotatebook::overlay
