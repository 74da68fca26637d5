// Thumbnails of a study's plot: curves without text. Inside the room only.
#pragma once

#include <utility>
#include <vector>

#include "page/html.h"

namespace rotatebook::page {

/// Points (x, y) that are joined in their order.
using Curve = std::vector<std::pair<double, double>>;

/// Draws the curves and two axes as an <svg> in the page's colours. Leaves out a curve without
/// finite points.
Html curvesSvg(const std::vector<Curve>& curves);

}  // namespace rotatebook::page
