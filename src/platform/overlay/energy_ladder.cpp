#include "rigid/energy_ladder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "overlay/drawn_overlay.h"
#include "overlay/label_placement.h"
#include "physics/free_motion.h"
#include "physics/motion_start.h"
#include "rigid/inertia.h"

namespace rotatebook::overlay {
namespace {

constexpr double kLadderShare = 0.42;  // of the box's width

/// Draws rigid::EnergyLadder.
class DrawnLadder final : public DrawnOverlay {
 public:
  DrawnLadder(const OverlayContext& context, const Box& box);
  const CachedLayer* still(std::int64_t) const override { return &background_; }
  void draw(const View& view) override;

 private:
  Point positionOf(const rigid::LadderPlace& place) const {
    return {sides_.x + (0.5 + place.angle / std::numbers::pi) * sides_.width,
            sides_.bottom() - place.height * sides_.height};
  }
  /// The left end, -1, or the right one, 1, of the ladder at an energy.
  Point endOf(double side, double energy) const {
    return positionOf({ladder_.heightOf(energy), side * ladder_.reachAt(energy)});
  }
  Layer set(const std::string& text, const Colour& colour, bool bold = false) const;
  CachedLayer background();
  void drawOutline(Canvas& canvas) const;
  void writeRungs(Canvas& canvas);
  void writeMargin(Canvas& canvas, double energy);

  OverlayContext context_;
  Box box_, sides_;
  rigid::PrincipalAxes inertia_;
  rigid::EnergyLadder ladder_;
  std::array<std::string, 3> letters_;
  std::vector<Box> written_;
  CachedLayer background_;
};

DrawnLadder::DrawnLadder(const OverlayContext& context, const Box& box)
    : context_(context),
      box_(box),
      inertia_(physics::modelInertia(context.scene.motions[0])),
      ladder_(inertia_.moments) {
  const bool principal = !inertia_.bodyFromPrincipal.isIdentity(1e-9);
  for (std::size_t i = 0; i < 3; ++i)
    letters_[i] = (principal ? "123" : "xyz")[static_cast<std::size_t>(ladder_.axes()[i])];
  const double letter = context.scale.smallLetters;
  const double left = box.x + 1.5 * letter, top = box.y + 2.3 * letter;
  sides_ = {left, top, std::max(1.0, kLadderShare * box.width - 1.5 * letter),
            std::max(1.0, box.bottom() - 0.9 * letter - top)};
  background_ = background();
}

Layer DrawnLadder::set(const std::string& text, const Colour& colour, bool bold) const {
  return context_.type.draw(
      text, {.size = context_.scale.smallLetters, .bold = bold, .colour = colour, .tabular = true},
      context_.scale.width);
}

CachedLayer DrawnLadder::background() {
  const Scale& scale = context_.scale;
  Canvas canvas = context_.canvas();
  canvas.roundedBox(box_, 0.5 * scale.smallLetters, {kDark, kBacking});
  const Layer title = set(context_.scene.overlay.words[scene::Word::EnergiesAtThisL], kWhite, true);
  const Point corner(box_.x + 0.45 * scale.smallLetters,
                     std::round(box_.y + 0.22 * scale.smallLetters));
  if (box_.holds(boxOf(title, corner))) {
    canvas.write(title, corner);
    written_.push_back(boxOf(title, corner));
  }
  drawOutline(canvas);
  writeRungs(canvas);
  return canvas.take();
}

void DrawnLadder::drawOutline(Canvas& canvas) const {
  const Scale& scale = context_.scale;
  std::vector<Point> right, left;
  for (const rigid::LadderPlace& place : ladder_.outline()) {
    right.push_back(positionOf(place));
    left.push_back(positionOf({place.height, -place.angle}));
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  canvas.area(right, {kKineticColour, 0.16});
  right.push_back(right.front());
  canvas.line(right, {kGrey, 0.35 * scale.line, 0.8, 0});
}

void DrawnLadder::writeRungs(Canvas& canvas) {
  const Scale& scale = context_.scale;
  using scene::Word;
  const std::array words{Word::SmallestMoment, Word::MiddleMoment, Word::LargestMoment};
  const double x = sides_.right() + 0.9 * scale.smallLetters;
  std::array<Layer, 3> labels;
  std::array<double, 3> rows;  // the lowest first
  for (const bool whole : {true, false}) {
    bool fits = true;
    for (std::size_t i = 0; i < 3; ++i) {
      std::string text = letters_[i];
      if (whole) text += "  " + context_.scene.overlay.words[words[i]];
      labels[i] = set(text, axisLetterColour(static_cast<std::size_t>(ladder_.axes()[i])));
      fits = fits && x + labels[i].width < box_.right() - 0.3 * scale.smallLetters;
    }
    if (fits) break;
  }
  for (std::size_t i = 0; i < 3; ++i)
    rows[2 - i] = endOf(1, ladder_.energyOf(ladder_.axes()[i])).y();
  stackUpward(rows, labels[0].height + 1.0, box_.bottom() - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = ladder_.axes()[i];
    const double energy = ladder_.energyOf(axis);
    const Colour& colour = kAxisColours[static_cast<std::size_t>(axis)];
    const Point rung = endOf(1, energy);
    const Point position(x, std::round(rows[2 - i] - labels[i].height / 2.0));
    if (isFree(boxOf(labels[i], position), box_, written_)) {
      canvas.line(std::array{rung, Point(sides_.right(), rung.y()),
                             Point(x - 0.3 * scale.smallLetters, rows[2 - i])},
                  {colour, std::max(1.0, 0.3 * scale.line), 0.6, 0});
      canvas.write(labels[i], position);
      written_.push_back(boxOf(labels[i], position));
    }
    canvas.line(std::array{endOf(-1, energy), rung}, {colour, 0.5 * scale.line, 0.9, 0});
    for (const double side : {-1.0, 1.0})
      canvas.disc(endOf(side, energy), 0.9 * scale.line, {colour, 1});
  }
}

/// Writes by which share the energy is over or under that of the middle axis, as high at the right
/// as there is room.
void DrawnLadder::writeMargin(Canvas& canvas, double energy) {
  const double percent = 100 * ladder_.aboveMiddle(energy);
  if (!std::isfinite(percent)) return;
  const double size = std::abs(percent);
  const std::string number = context_.scene.overlay.words.number(
      size < 100 ? roundedText(size, 2) : std::to_string(std::lround(size)));
  const Layer text = set(letters_[1] + (percent < 0 ? " − " : " + ") + number + " %", kGrey);
  const double letter = context_.scale.smallLetters;
  const double x = box_.right() - 0.45 * letter - text.width;
  for (double y = box_.y + 0.22 * letter; y < box_.bottom(); y += 0.25 * letter) {
    const Point corner(x, std::round(y));
    if (x < sides_.right() || !isFree(boxOf(text, corner), box_, written_)) continue;
    canvas.write(text, corner);
    return;
  }
}

void DrawnLadder::draw(const View& view) {
  const Scale& scale = context_.scale;
  const physics::Sample& sample = context_.trajectory.samples[static_cast<std::size_t>(view.frame)];
  const Eigen::Vector3d momentum = physics::momentumAlong(inertia_, sample);
  const double energy = sample.total() / momentum.squaredNorm();
  if (!std::isfinite(energy)) return;
  if (!context_.scene.textless) writeMargin(view.canvas, energy);
  const Point left = endOf(-1, energy), right = endOf(1, energy);
  view.canvas.line(std::array{left, right}, {kWhite, 0.5 * scale.line, 1, 0.5 * scale.halo});
  const double size = 0.55 * scale.smallLetters;
  const Point tip(sides_.x - 0.25 * scale.smallLetters, left.y());
  view.canvas.area(
      std::array{tip, Point(tip - Point(size, size / 2)), Point(tip - Point(size, -size / 2))},
      {kWhite, 1});
  const Point now = positionOf(ladder_.placeOf(momentum, energy));
  view.canvas.disc(now, 1.5 * scale.line + scale.halo, {kDark, 0.8});
  view.canvas.disc(now, 1.5 * scale.line, {kMomentumColour, 1});
}

}  // namespace

std::unique_ptr<DrawnOverlay> makeEnergyLadder(const OverlayContext& context, const Box& box) {
  return std::make_unique<DrawnLadder>(context, box);
}

}  // namespace rotatebook::overlay
