// Curves without words: what a study's plot looks like from afar. Inside the room only.
#pragma once

#include <utility>
#include <vector>

#include "page/html.h"

namespace rotatebook::page {

/// Points (x, y) that are joined in their order.
using Curve = std::vector<std::pair<double, double>>;

/// The curves between two axes, as an <svg> in the page's colours. A curve of no finite point is
/// left out.
Html curvesSvg(const std::vector<Curve>& curves);

}  // namespace rotatebook::page
