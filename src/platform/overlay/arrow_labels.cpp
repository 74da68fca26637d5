#include "overlay/arrow_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Core>

namespace rotatebook::overlay {
namespace {

constexpr double kArrowGap = 2;  // between letters and arrows [pixels]

// The path along which a letter is moved: around the tip, then straight aside; and its steps. The
// unit is the letter's distance from the tip when nothing is in the way.
constexpr double kRound = std::numbers::pi / 2, kAside = 1.8, kStep = 0.06;
// Factor by which a path to the other side must be shorter. Arrows that nearly coincide pass each
// other often: their letters stay.
constexpr double kOtherSide = 1.2;

// Largest distance from the mean position at which room for a letter is sought [pixels], and the
// number of directions.
constexpr int kFarthestOff = 48, kDirections = 24;

/// Returns the position of a letter's middle after a `path` to `side`, relative to its arrow's tip:
/// along the arrow, and to its right. [distances]
Point offsetAfter(double path, Side side) {
  const Point right =
      path <= kRound ? Point(std::cos(path), std::sin(path)) : Point(0, 1 + path - kRound);
  return side == Side::Right ? right : Point(right.x(), -right.y());
}

Point directionOf(const ArrowShape& arrow) {
  const Point along = arrow.tip - arrow.from;
  return along.norm() > 1e-9 ? Point(along.normalized()) : Point(0, -1);
}

/// Returns the length of a line within a box.
double lengthWithin(const Box& box, const Point& from, const Point& to) {
  double enters = 0, leaves = 1;
  const Point low(box.x, box.y), high(box.right(), box.bottom()), along = to - from;
  for (Eigen::Index i = 0; i < 2; ++i) {
    if (std::abs(along[i]) < 1e-9) {
      if (from[i] <= low[i] || from[i] >= high[i]) return 0;
      continue;
    }
    const double a = (low[i] - from[i]) / along[i], b = (high[i] - from[i]) / along[i];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return std::max(0.0, leaves - enters) * along.norm();
}

/// Returns the ends of the head's base.
std::array<Point, 2> baseOf(const ArrowShape& arrow) {
  const Point along = directionOf(arrow);
  const Point middle = arrow.tip - arrow.headLength * along;
  const Point across = Point(-along.y(), along.x()) * arrow.headWidth / 2;
  return {middle + across, middle - across};
}

/// Returns the bounds of the pixels of `letter` that aren't transparent.
Box inkOf(const Layer& letter) {
  int left = letter.width, right = 0, top = letter.height, bottom = 0;
  for (int y = 0; y < letter.height; ++y) {
    for (int x = 0; x < letter.width; ++x) {
      if (letter.pixels[static_cast<std::size_t>(y * letter.width + x) * 4 + 3] == 0) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = std::max(bottom, y + 1);
    }
  }
  if (left >= right) return {};
  return {1.0 * (letter.x + left), 1.0 * (letter.y + top), 1.0 * (right - left),
          1.0 * (bottom - top)};
}

/// Returns the letter of arrow `index` with its middle at an `offset` like offsetAfter()'s.
ArrowLabels::Placed placedAt(const LabelledArrow& arrow, const Box& ink, const Point& offset,
                             std::size_t index) {
  const Box size = boxOf(*arrow.letter);
  const Point along = directionOf(arrow.shape), right(-along.y(), along.x());
  const Point middle = arrow.shape.tip + (along * offset.x() + right * offset.y()) * arrow.distance;
  const Point corner = middle - Point(size.width / 2, size.height / 2);
  return {size.moved(corner), ink.moved(corner), index};
}

bool isClearOfArrows(const Box& ink, std::size_t own, const std::vector<LabelledArrow>& arrows) {
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    const ArrowShape& arrow = arrows[i].shape;
    if (i == own || !arrows[i].inFront) continue;
    if (lengthWithin(ink.grown(arrow.lineWidth / 2 + kArrowGap), arrow) > 0) return false;
  }
  return true;
}

/// Returns the indices of arrows in front of the camera, in the order of their ranks.
std::vector<std::size_t> orderOf(const std::vector<LabelledArrow>& arrows) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    if (arrows[i].inFront) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return arrows[i].wish.rank; });
  return order;
}

/// Returns the first offset on the letter's paths that `isGood`; straight ahead if none is.
template <typename IsGood>
Point firstGoodOffset(Side side, const IsGood& isGood) {
  constexpr double kLongest = kRound + kAside;
  const Side other = side == Side::Right ? Side::Left : Side::Right;
  for (double path = 0; path < kLongest + kOtherSide; path += kStep) {
    if (const Point offset = offsetAfter(path, side); path < kLongest && isGood(offset)) {
      return offset;
    }
    if (path <= kOtherSide) continue;
    if (const Point offset = offsetAfter(path - kOtherSide, other); isGood(offset)) return offset;
  }
  return {1, 0};
}

/// Returns the letters' best offsets in a frame, regardless of other frames.
std::vector<Point> bestOffsets(const std::vector<LabelledArrow>& arrows, const Box& picture,
                               std::vector<Box> taken) {
  std::vector<Point> offsets(arrows.size(), Point(1, 0));
  for (const std::size_t i : orderOf(arrows)) {
    const Box ink = inkOf(*arrows[i].letter);
    offsets[i] = firstGoodOffset(arrows[i].wish.side, [&](const Point& offset) {
      const auto found = placedAt(arrows[i], ink, offset, i);
      return isFree(found.box, picture, taken) && isClearOfArrows(found.ink, i, arrows);
    });
    taken.push_back(placedAt(arrows[i], ink, offsets[i], i).box);
  }
  return offsets;
}

/// Returns `wanted`, moved as little as necessary to be free; nothing if that is too far.
std::optional<ArrowLabels::Placed> movedToFree(const ArrowLabels::Placed& wanted,
                                               const Box& picture, const std::vector<Box>& taken) {
  if (isFree(wanted.box, picture, taken)) return wanted;
  for (int off = 1; off <= kFarthestOff; ++off) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      const Point by(off * std::cos(angle), off * std::sin(angle));
      const Box box = wanted.box.moved(by);
      if (isFree(box, picture, taken))
        return ArrowLabels::Placed{box, wanted.ink.moved(by), wanted.arrow};
    }
  }
  return std::nullopt;
}

}  // namespace

double lengthWithin(const Box& box, const ArrowShape& arrow) {
  const auto [a, b] = baseOf(arrow);
  if (!arrow.visibleFrom) return 0;
  return lengthWithin(box, *arrow.visibleFrom, arrow.tip) + lengthWithin(box, a, arrow.tip) +
         lengthWithin(box, b, arrow.tip) + lengthWithin(box, a, b);
}

ArrowLabels::ArrowLabels(const Box& picture, std::vector<Box> taken, std::int64_t last,
                         std::int64_t reach)
    : picture_(picture), taken_(std::move(taken)), last_(last), reach_(reach) {}

const std::vector<Point>& ArrowLabels::bestAt(std::int64_t frame, const ArrowsAt& arrowsAt) {
  const auto known = best_.find(frame);
  if (known != best_.end()) return known->second;
  return best_[frame] = bestOffsets(arrowsAt(frame), picture_, taken_);
}

// The mean of equal offsets is exactly that offset, as the weights are whole numbers.
std::vector<Point> ArrowLabels::meanAround(std::int64_t frame, const ArrowsAt& arrowsAt) {
  std::erase_if(best_, [&](const auto& one) { return std::abs(one.first - frame) > reach_; });
  std::vector<Point> sum(arrows_.size(), Point(0, 0));
  double weights = 0;
  for (std::int64_t off = -reach_; off <= reach_; ++off) {
    const double weight = static_cast<double>(reach_ + 1 - std::abs(off));
    const auto& offsets = bestAt(std::clamp<std::int64_t>(frame + off, 0, last_), arrowsAt);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * offsets[i];
    weights += weight;
  }
  for (Point& offset : sum) offset /= weights;
  return sum;
}

void ArrowLabels::place(std::int64_t frame, const ArrowsAt& arrowsAt,
                        const std::vector<Box>& alsoTaken) {
  arrows_ = arrowsAt(frame);
  placed_.clear();
  if (arrows_.empty()) return;
  const std::vector<Point> offsets = meanAround(frame, arrowsAt);
  std::vector<Box> taken = taken_;
  taken.insert(taken.end(), alsoTaken.begin(), alsoTaken.end());
  for (const std::size_t i : orderOf(arrows_)) {
    const auto wanted = placedAt(arrows_[i], inkOf(*arrows_[i].letter), offsets[i], i);
    const auto found = movedToFree(wanted, picture_, taken);
    if (!found) continue;
    taken.push_back(found->box);
    placed_.push_back(*found);
  }
  std::ranges::sort(placed_, {}, &Placed::arrow);
}

void ArrowLabels::write(Canvas& canvas) const {
  for (const Placed& one : placed_) {
    canvas.write(*arrows_[one.arrow].letter, {one.box.x, one.box.y});
  }
}

}  // namespace rotatebook::overlay
