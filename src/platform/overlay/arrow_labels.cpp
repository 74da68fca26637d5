#include "overlay/arrow_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Core>

namespace rotatebook::overlay {
namespace {

constexpr double kLetterGap = 1;  // between words [pixels]
constexpr double kArrowGap = 2;   // between letters and arrows [pixels]

// The way of a letter that gives way: round its tip, then straight aside; and its steps. [distances
// of a letter that has nothing in its way]
constexpr double kRound = std::numbers::pi / 2, kAside = 1.8, kStep = 0.06;
// That a way to the other side must be shorter. Arrows that nearly coincide pass each other often:
// their letters stay.
constexpr double kOtherSide = 1.2;

// How far from where it should be, and in how many directions, a letter finds another place if
// words are there. [pixels]
constexpr int kFarthestOff = 48, kDirections = 24;

/// Where a letter's middle is after `way` to `side`: from its arrow's tip along the arrow and to
/// its right. [distances]
Point placeAfter(double way, Side side) {
  const Point right =
      way <= kRound ? Point(std::cos(way), std::sin(way)) : Point(0, 1 + way - kRound);
  return side == Side::Right ? right : Point(right.x(), -right.y());
}

Side opposite(Side side) {
  return side == Side::Right ? Side::Left : Side::Right;
}

Point directionOf(const ArrowShape& arrow) {
  const Point way = arrow.tip - arrow.from;
  return way.norm() > 1e-9 ? Point(way.normalized()) : Point(0, -1);
}

/// What of a line lies within a box, from 0 to 1 of its length.
std::optional<std::pair<double, double>> partWithin(const Box& box, const Point& from,
                                                    const Point& to) {
  double enters = 0, leaves = 1;
  const Point low(box.x, box.y), high(box.right(), box.bottom()), way = to - from;
  for (Eigen::Index i = 0; i < 2; ++i) {
    if (std::abs(way[i]) < 1e-9) {
      if (from[i] <= low[i] || from[i] >= high[i]) return std::nullopt;
      continue;
    }
    const double a = (low[i] - from[i]) / way[i], b = (high[i] - from[i]) / way[i];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  if (enters >= leaves) return std::nullopt;
  return std::pair(enters, leaves);
}

double lengthWithin(const Box& box, const Point& from, const Point& to) {
  const auto part = partWithin(box, from, to);
  return part ? (part->second - part->first) * (to - from).norm() : 0;
}

/// The ends of the head's base.
std::array<Point, 2> baseOf(const ArrowShape& arrow) {
  const Point along = directionOf(arrow);
  const Point middle = arrow.tip - arrow.headLength * along;
  const Point across = Point(-along.y(), along.x()) * arrow.headWidth / 2;
  return {middle + across, middle - across};
}

/// What is drawn of `letter`, as its box is at the origin.
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

/// The letter of `arrow` with its middle at `place`, which is as placeAfter() has it.
ArrowLabels::Placed placedAt(const LabelledArrow& arrow, const Box& ink, const Point& place,
                             std::size_t index) {
  const Box size = boxOf(*arrow.letter, Point(0, 0));
  const Point along = directionOf(arrow.shape), right(-along.y(), along.x());
  const Point middle = arrow.shape.tip + (along * place.x() + right * place.y()) * arrow.distance;
  const Point corner = middle - Point(size.width / 2, size.height / 2);
  return {boxOf(*arrow.letter, corner),
          {corner.x() + ink.x, corner.y() + ink.y, ink.width, ink.height},
          index};
}

bool isClearOfArrows(const Box& ink, std::size_t own, const std::vector<LabelledArrow>& arrows) {
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    const ArrowShape& arrow = arrows[i].shape;
    if (i == own || !arrows[i].inFront) continue;
    if (lengthWithin(ink.grown(arrow.lineWidth / 2 + kArrowGap), arrow) > 0) return false;
  }
  return true;
}

bool isFree(const Box& box, const Box& picture, const std::vector<Box>& taken) {
  return picture.holds(box) && std::ranges::none_of(taken, [&](const Box& other) {
           return other.grown(kLetterGap).meets(box);
         });
}

/// Indices of those in front of the camera, in the order in which they choose.
std::vector<std::size_t> orderOf(const std::vector<LabelledArrow>& arrows) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    if (arrows[i].inFront) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return arrows[i].wish.rank; });
  return order;
}

/// The nearest place on the letter's way that `isGood`, straight ahead if none is.
template <typename IsGood>
Point nearestOnWay(Side side, const IsGood& isGood) {
  constexpr double kLongest = kRound + kAside;
  for (double way = 0; way < kLongest + kOtherSide; way += kStep) {
    if (way < kLongest) {
      if (const Point place = placeAfter(way, side); isGood(place)) return place;
    }
    if (way <= kOtherSide) continue;
    if (const Point place = placeAfter(way - kOtherSide, opposite(side)); isGood(place)) {
      return place;
    }
  }
  return {1, 0};
}

/// Where the letters of a frame are best if no other frame counts.
std::vector<Point> bestPlaces(const std::vector<LabelledArrow>& arrows, const Box& picture,
                              std::vector<Box> taken) {
  std::vector<Point> places(arrows.size(), Point(1, 0));
  for (const std::size_t i : orderOf(arrows)) {
    const Box ink = inkOf(*arrows[i].letter);
    places[i] = nearestOnWay(arrows[i].wish.side, [&](const Point& place) {
      const auto found = placedAt(arrows[i], ink, place, i);
      return isFree(found.box, picture, taken) && isClearOfArrows(found.ink, i, arrows);
    });
    taken.push_back(placedAt(arrows[i], ink, places[i], i).box);
  }
  return places;
}

/// `wanted`, moved as little as it takes to be free; nothing if that is too far.
std::optional<ArrowLabels::Placed> movedToFree(const ArrowLabels::Placed& wanted,
                                               const Box& picture, const std::vector<Box>& taken) {
  if (isFree(wanted.box, picture, taken)) return wanted;
  for (int off = 1; off <= kFarthestOff; ++off) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      ArrowLabels::Placed moved = wanted;
      for (Box* box : {&moved.box, &moved.ink}) {
        box->x += off * std::cos(angle);
        box->y += off * std::sin(angle);
      }
      if (isFree(moved.box, picture, taken)) return moved;
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
  return best_[frame] = bestPlaces(arrowsAt(frame), picture_, taken_);
}

// Equal places have exactly that place as their mean, as the weights are whole numbers.
std::vector<Point> ArrowLabels::meanAround(std::int64_t frame, const ArrowsAt& arrowsAt) {
  std::erase_if(best_, [&](const auto& one) { return std::abs(one.first - frame) > reach_; });
  std::vector<Point> sum(arrows_.size(), Point(0, 0));
  double weights = 0;
  for (std::int64_t off = -reach_; off <= reach_; ++off) {
    const double weight = static_cast<double>(reach_ + 1 - std::abs(off));
    const auto& places = bestAt(std::clamp<std::int64_t>(frame + off, 0, last_), arrowsAt);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * places[i];
    weights += weight;
  }
  for (Point& place : sum) place /= weights;
  return sum;
}

void ArrowLabels::write(Canvas& canvas, std::int64_t frame, const ArrowsAt& arrowsAt,
                        const std::vector<Box>& alsoTaken) {
  arrows_ = arrowsAt(frame);
  placed_.clear();
  if (arrows_.empty()) return;
  const std::vector<Point> places = meanAround(frame, arrowsAt);
  std::vector<Box> taken = taken_;
  taken.insert(taken.end(), alsoTaken.begin(), alsoTaken.end());
  for (const std::size_t i : orderOf(arrows_)) {
    const auto wanted = placedAt(arrows_[i], inkOf(*arrows_[i].letter), places[i], i);
    const auto found = movedToFree(wanted, picture_, taken);
    if (!found) continue;
    taken.push_back(found->box);
    placed_.push_back(*found);
  }
  std::ranges::sort(placed_, {}, &Placed::arrow);
  for (const Placed& one : placed_) {
    canvas.write(*arrows_[one.arrow].letter, {one.box.x, one.box.y});
  }
}

}  // namespace rotatebook::overlay
