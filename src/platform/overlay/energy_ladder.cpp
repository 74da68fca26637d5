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
#include "physics/motion_start.h"
#include "rigid/poinsot.h"
#include "rigid/regime.h"

namespace rotatebook::overlay {
namespace {

constexpr int kLadderRows = 60;        // of its outline, from each end to the middle
constexpr double kLadderShare = 0.42;  // of the box's width

/// A vertical scale of energies, in units of L^2, from the largest moment's axis to the smallest's.
/// At each its width says how far L goes to both sides of the axis that it circles in the body:
/// nowhere at the ends, to the middle axis at that one's energy.
class EnergyLadder final : public DrawnOverlay {
 public:
  EnergyLadder(const OverlayContext& context, const Box& box);
  void draw(const View& view) override;

 private:
  Point positionOf(double angle, double energy) const {
    const double share = std::clamp((energy - low()) / (high() - low()), 0.0, 1.0);
    return {ladder_.x + (0.5 + angle / std::numbers::pi) * ladder_.width,
            ladder_.bottom() - (high() > low() ? share : 0.5) * ladder_.height};
  }
  double low() const { return energies_[axes_[2]]; }
  double high() const { return energies_[axes_[0]]; }
  double reachAt(double energy) const { return rigid::reachOfMomentum(energies_, energy); }
  Layer set(const std::string& text, const Colour& colour, bool bold = false) const;
  CachedLayer background();
  void drawOutline(Canvas& canvas) const;
  void writeRungs(Canvas& canvas);
  void writeMargin(Canvas& canvas, double energy);

  OverlayContext context_;
  Box box_, ladder_;
  Eigen::Matrix3d bodyFromPrincipal_;
  std::array<int, 3> axes_;   // of the smallest, middle and largest moment
  Eigen::Vector3d energies_;  // of spins about the principal axes, for L = 1
  std::array<std::string, 3> letters_;
  std::vector<Box> written_;
  CachedLayer background_;
};

EnergyLadder::EnergyLadder(const OverlayContext& context, const Box& box)
    : context_(context), box_(box) {
  const auto inertia = physics::modelInertia(context.scene.motions[0]);
  bodyFromPrincipal_ = inertia.bodyFromPrincipal;
  axes_ = rigid::axesByInertia(inertia.moments);
  energies_ = rigid::axisEnergies(inertia.moments, 1);
  const bool principal = !bodyFromPrincipal_.isIdentity(1e-9);
  for (std::size_t i = 0; i < 3; ++i)
    letters_[i] = (principal ? "123" : "xyz")[static_cast<std::size_t>(axes_[i])];
  const double letter = context.scale.smallLetters;
  const double left = box.x + 1.5 * letter, top = box.y + 2.3 * letter;
  ladder_ = {left, top, std::max(1.0, kLadderShare * box.width - 1.5 * letter),
             std::max(1.0, box.bottom() - 0.9 * letter - top)};
  background_ = background();
}

Layer EnergyLadder::set(const std::string& text, const Colour& colour, bool bold) const {
  return context_.type.draw(
      text, {.size = context_.scale.smallLetters, .bold = bold, .colour = colour, .tabular = true},
      context_.scale.width);
}

CachedLayer EnergyLadder::background() {
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

void EnergyLadder::drawOutline(Canvas& canvas) const {
  const Scale& scale = context_.scale;
  std::vector<Point> right, left;
  const double middle = energies_[axes_[1]];
  for (const double end : {high(), low()}) {
    for (int i = 0; i <= kLadderRows; ++i) {
      // Denser toward both, where the width changes most.
      const double turn = std::numbers::pi * (end == high() ? i : kLadderRows - i) / kLadderRows;
      const double energy = end + (middle - end) * (1 - std::cos(turn)) / 2;
      right.push_back(positionOf(reachAt(energy), energy));
      left.push_back(positionOf(-reachAt(energy), energy));
    }
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  canvas.area(right, {kKineticColour, 0.16});
  right.push_back(right.front());
  canvas.line(right, {kGrey, 0.35 * scale.line, 0.8, 0});
}

void EnergyLadder::writeRungs(Canvas& canvas) {
  const Scale& scale = context_.scale;
  using scene::Word;
  const std::array words{Word::SmallestMoment, Word::MiddleMoment, Word::LargestMoment};
  const double x = ladder_.right() + 0.9 * scale.smallLetters;
  std::array<Layer, 3> labels;
  std::array<double, 3> rows;  // the lowest first
  for (const bool whole : {true, false}) {
    bool fits = true;
    for (std::size_t i = 0; i < 3; ++i) {
      std::string text = letters_[i];
      if (whole) text += "  " + context_.scene.overlay.words[words[i]];
      labels[i] = set(text, axisLetterColour(static_cast<std::size_t>(axes_[i])));
      fits = fits && x + labels[i].width < box_.right() - 0.3 * scale.smallLetters;
    }
    if (fits) break;
  }
  for (std::size_t i = 0; i < 3; ++i) rows[2 - i] = positionOf(0, energies_[axes_[i]]).y();
  stackUpward(rows, labels[0].height + 1.0, box_.bottom() - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const double energy = energies_[axes_[i]], reach = reachAt(energy);
    const Colour& colour = kAxisColours[static_cast<std::size_t>(axes_[i])];
    const Point rung = positionOf(reach, energy);
    const Point position(x, std::round(rows[2 - i] - labels[i].height / 2.0));
    if (isFree(boxOf(labels[i], position), box_, written_)) {
      canvas.line(std::array{rung, Point(ladder_.right(), rung.y()),
                             Point(x - 0.3 * scale.smallLetters, rows[2 - i])},
                  {colour, std::max(1.0, 0.3 * scale.line), 0.6, 0});
      canvas.write(labels[i], position);
      written_.push_back(boxOf(labels[i], position));
    }
    canvas.line(std::array{positionOf(-reach, energy), rung}, {colour, 0.5 * scale.line, 0.9, 0});
    for (const double side : {-1.0, 1.0})
      canvas.disc(positionOf(side * reach, energy), 0.9 * scale.line, {colour, 1});
  }
}

/// Writes by which share the energy is over or under that of the middle axis, as high at the right
/// as there is room.
void EnergyLadder::writeMargin(Canvas& canvas, double energy) {
  const double percent = 100 * (energy / energies_[axes_[1]] - 1);
  if (!std::isfinite(percent)) return;
  const double size = std::abs(percent);
  const std::string number = context_.scene.overlay.words.number(
      size < 100 ? roundedText(size, 2) : std::to_string(std::lround(size)));
  const Layer text = set(letters_[1] + (percent < 0 ? " − " : " + ") + number + " %", kGrey);
  const double letter = context_.scale.smallLetters;
  const double x = box_.right() - 0.45 * letter - text.width;
  for (double y = box_.y + 0.22 * letter; y < box_.bottom(); y += 0.25 * letter) {
    const Point corner(x, std::round(y));
    if (x < ladder_.right() || !isFree(boxOf(text, corner), box_, written_)) continue;
    canvas.write(text, corner);
    return;
  }
}

void EnergyLadder::draw(const View& view) {
  view.canvas.lay(background_, view.picture);
  const Scale& scale = context_.scale;
  const physics::Sample& sample = context_.trajectory.samples[static_cast<std::size_t>(view.frame)];
  const Eigen::Vector3d momentum =
      bodyFromPrincipal_.transpose() * (sample.attitude.conjugate() * sample.angularMomentum);
  const double energy = sample.total() / momentum.squaredNorm();
  if (!std::isfinite(energy)) return;
  if (!context_.scene.textless) writeMargin(view.canvas, energy);
  const double reach = reachAt(energy);
  const Point left = positionOf(-reach, energy), right = positionOf(reach, energy);
  view.canvas.line(std::array{left, right}, {kWhite, 0.5 * scale.line, 1, 0.5 * scale.halo});
  const double size = 0.55 * scale.smallLetters;
  const Point tip(ladder_.x - 0.25 * scale.smallLetters, left.y());
  view.canvas.area(
      std::array{tip, Point(tip - Point(size, size / 2)), Point(tip - Point(size, -size / 2))},
      {kWhite, 1});
  const int circled = axes_[energy > energies_[axes_[1]] ? 0 : 2];
  const double angle = std::atan2(momentum[axes_[1]], std::abs(momentum[circled]));
  const Point now = positionOf(std::clamp(angle, -reach, reach), energy);
  view.canvas.disc(now, 1.5 * scale.line + scale.halo, {kDark, 0.8});
  view.canvas.disc(now, 1.5 * scale.line, {kMomentumColour, 1});
}

}  // namespace

std::unique_ptr<DrawnOverlay> makeEnergyLadder(const OverlayContext& context, const Box& box) {
  return std::make_unique<EnergyLadder>(context, box);
}

}  // namespace rotatebook::overlay
