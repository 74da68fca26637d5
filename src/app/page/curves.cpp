#include "page/curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "base/number_text.h"

namespace rotatebook::page {
namespace {

// Lengths in the drawing's units; it is shown some 230 pixels wide.
constexpr double kWidth = 240, kHeight = 135, kMargin = 18;
constexpr int kDigits = 4;
constexpr std::size_t kColours = 6;  // The page's --series-1 and so on.

constexpr std::string_view kDrawing =
    R"(<svg viewBox="0 0 240 135" aria-hidden="true"><path class="axes" d="M18 12V117H228"/>{{curves}}</svg>)";

constexpr std::string_view kCurve =
    R"~(<path style="stroke:var(--series-{{colour}})" d="{{path}}"/>)~";

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Returns 0 for the low end, 1 for the high one.
  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

bool isFinite(const Curve::value_type& point) {
  return std::isfinite(point.first) && std::isfinite(point.second);
}

std::string pathOf(const Curve& curve, const Range& xs, const Range& ys) {
  std::string path;
  for (const auto& point : curve) {
    if (!isFinite(point)) continue;
    const double x = kMargin + 8 + xs.share(point.first) * (kWidth - 2 * kMargin - 8);
    const double y = kHeight - kMargin - 8 - ys.share(point.second) * (kHeight - 2 * kMargin - 8);
    path += (path.empty() ? "M" : "L") + roundedText(x, kDigits) + " " + roundedText(y, kDigits);
  }
  return path;
}

}  // namespace

Html curvesSvg(const std::vector<Curve>& curves) {
  Range xs, ys;
  for (const Curve& curve : curves) {
    for (const auto& point : curve) {
      if (!isFinite(point)) continue;
      xs.include(point.first);
      ys.include(point.second);
    }
  }
  Html paths;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string path = pathOf(curves[i], xs, ys);
    if (path.empty()) continue;
    paths += filled(kCurve, {{"colour", {std::to_string(i % kColours + 1)}}, {"path", {path}}});
  }
  return filled(kDrawing, {{"curves", paths}});
}

}  // namespace rotatebook::page
