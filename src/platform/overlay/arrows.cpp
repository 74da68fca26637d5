#include "overlay/arrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "overlay/body_box.h"
#include "scene/reference_frame.h"

namespace rotatebook::overlay {
namespace {

// In units of the distance from the body's centre to its corners; arrows of up to 1 stay, with
// their letters, within the picture.
constexpr double kAxisBeyond = 0.17, kShortestAxis = 0.75;
constexpr double kOmegaLength = 0.86, kMomentumLength = 1;
// Velocities above this many times the start's don't shorten the arrows of all others.
constexpr double kLargestVelocity = 2;
constexpr double kLargestMomentum = 1.05;
constexpr double kTipTrailTime = 4;  // of the clip [s]
constexpr int kTrailParts = 24;      // each has its own opacity

// L's arrow is mostly the longest, and its letter is placed first; the letters of arrows that
// coincide with it are placed to its left and right.
constexpr LetterWish kMomentumWish{Side::Right, 0}, kVelocityWish{Side::Right, 1},
    kAxisWish{Side::Left, 2};

double reachOf(const body::Cuboid& body) {
  return body.size.norm() / 2;
}

Layer letter(const OverlayContext& context, const std::string& text, const Colour& colour) {
  const TextStyle style{.size = 1.15 * context.scale.arrowLetters,
                        .bold = true,
                        .colour = colour,
                        .halo = context.scale.halo};
  return context.type.draw(text, style, context.scale.width);
}

/// Scales `vector` such that the norm `whole` becomes the length `full`, and no length exceeds
/// `max`.
Eigen::Vector3d scaledTip(const Eigen::Vector3d& vector, double whole, double full, double max) {
  const double size = vector.stableNorm();
  if (!(size > 0 && whole > 0)) return Eigen::Vector3d::Zero();
  return vector / size * std::min(size / whole * full, max);
}

double largestVelocity(const physics::Trajectory& trajectory) {
  double largest = 0;
  for (const physics::Sample& sample : trajectory.samples) {
    largest = std::max(largest, sample.angularVelocity.stableNorm());
  }
  const double start = trajectory.samples.front().angularVelocity.stableNorm();
  return std::min(largest, kLargestVelocity * start);
}

void drawArrows(const View& view, const OverlayContext& context, const std::vector<Arrow>& arrows) {
  const BodyBox box(context.scene.motions[0].body, view.sample.cage);
  for (const Arrow& arrow : arrows) drawArrow(view, box, arrow);
}

/// The body's axes, from its centre out through its faces.
class Axes final : public DrawnOverlay {
 public:
  explicit Axes(const OverlayContext& context);
  void draw(const View& view) override;
  std::vector<Arrow> arrows(const physics::Sample& sample) const override;

 private:
  OverlayContext context_;
  std::array<Layer, 3> letters_;
};

Axes::Axes(const OverlayContext& context)
    : context_(context),
      letters_{letter(context, "x", kAxisColours[0]), letter(context, "y", kAxisColours[1]),
               letter(context, "z", kAxisColours[2])} {}

std::vector<Arrow> Axes::arrows(const physics::Sample& sample) const {
  const body::Cuboid& body = context_.scene.motions[0].body;
  const BodyBox box(body, sample.cage);
  const double reach = reachOf(body);
  std::vector<Arrow> arrows;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const double stretch = box.map().col(axis).norm();
    const double length =
        stretch * std::max(body.size[axis] / 2 + kAxisBeyond * reach, kShortestAxis * reach);
    const Eigen::Vector3d tip =
        box.centre() + length * (sample.attitude * Eigen::Vector3d::Unit(axis));
    const Pen pen{kAxisColours[i], 0.85 * context_.scale.line, 1, context_.scale.halo};
    arrows.push_back({box.centre(), tip, pen, &letters_[i], kAxisWish});
  }
  return arrows;
}

void Axes::draw(const View& view) {
  drawArrows(view, context_, arrows(view.sample));
}

}  // namespace

ArrowScale::ArrowScale(const OverlayContext& context)
    : reach_(reachOf(context.scene.motions[0].body)),
      velocity_(largestVelocity(context.trajectory)),
      momentum_(context.trajectory.samples.front().angularMomentum.stableNorm()) {}

Eigen::Vector3d ArrowScale::omegaTip(const Eigen::Vector3d& angularVelocity) const {
  return scaledTip(angularVelocity, velocity_, kOmegaLength * reach_, kOmegaLength * reach_);
}

Eigen::Vector3d ArrowScale::momentumTip(const Eigen::Vector3d& angularMomentum) const {
  const double full = kMomentumLength * reach_;
  return scaledTip(angularMomentum, momentum_, full, kLargestMomentum * full);
}

namespace {

/// The vector that a VectorArrow shows.
struct ShownVector {
  const char* letter;
  Colour colour;
  LetterWish wish;
  Eigen::Vector3d (*tip)(const ArrowScale& scale, const physics::Sample& sample);  ///< [m]
};

const ShownVector kOmega{"ω", kVelocityColour, kVelocityWish,
                         [](const ArrowScale& scale, const physics::Sample& sample) {
                           return scale.omegaTip(sample.angularVelocity);
                         }};
const ShownVector kMomentum{"L", kMomentumColour, kMomentumWish,
                            [](const ArrowScale& scale, const physics::Sample& sample) {
                              return scale.momentumTip(sample.angularMomentum);
                            }};

/// An arrow from the body's centre along a vector of the motion.
class VectorArrow final : public DrawnOverlay {
 public:
  VectorArrow(const OverlayContext& context, const ShownVector& shown)
      : context_(context),
        shown_(shown),
        scale_(context),
        letter_(letter(context, shown.letter, shown.colour)) {}

  void draw(const View& view) override { drawArrows(view, context_, arrows(view.sample)); }

  std::vector<Arrow> arrows(const physics::Sample& sample) const override {
    const Eigen::Vector3d centre = sample.cage.rowwise().mean();
    const Pen pen{shown_.colour, 1.5 * context_.scale.line, 1, context_.scale.halo};
    return {{centre, centre + shown_.tip(scale_, sample), pen, &letter_, shown_.wish}};
  }

 private:
  OverlayContext context_;
  ShownVector shown_;
  ArrowScale scale_;
  Layer letter_;
};

/// The path of the angular velocity's tip during the last seconds, in the camera's frame of
/// reference.
class Trail final : public DrawnOverlay {
 public:
  explicit Trail(const OverlayContext& context);
  void draw(const View& view) override;

 private:
  OverlayContext context_;
  std::vector<Eigen::Vector3d> tips_;  // of each sample
  std::int64_t length_;                // in samples
};

Trail::Trail(const OverlayContext& context)
    : context_(context), length_(context.scene.clip.frameRate.framesIn(kTipTrailTime)) {
  const ArrowScale scale(context);
  for (const physics::Sample& sample : context.trajectory.samples) {
    const Eigen::Matrix3d rotation = context.frame.fromWorld(sample);
    tips_.push_back(rotation * scale.omegaTip(sample.angularVelocity));
  }
}

void Trail::draw(const View& view) {
  const std::int64_t first = std::max<std::int64_t>(0, view.frame - length_);
  const std::int64_t step = std::max<std::int64_t>(1, length_ / kTrailParts);
  // Parts begin at multiples of their length, so that they don't crawl along the path.
  for (std::int64_t start = first / step * step; start < view.frame; start += step) {
    std::vector<Point> points;
    const std::int64_t end = std::min(start + step, view.frame);
    for (std::int64_t i = std::max(start, first); i <= end; ++i) {
      if (const auto point = view.projector(tips_[static_cast<std::size_t>(i)])) {
        points.push_back(*point);
      }
    }
    const double age = static_cast<double>(view.frame - end) / static_cast<double>(length_);
    view.canvas.line(points, {kVelocityColour, 0.75 * context_.scale.line, 0.9 * (1 - age),
                              0.6 * context_.scale.halo});
  }
}

}  // namespace

std::unique_ptr<DrawnOverlay> makeAxes(const OverlayContext& context, const Box&) {
  return std::make_unique<Axes>(context);
}

std::unique_ptr<DrawnOverlay> makeOmega(const OverlayContext& context, const Box&) {
  return std::make_unique<VectorArrow>(context, kOmega);
}

std::unique_ptr<DrawnOverlay> makeMomentum(const OverlayContext& context, const Box&) {
  return std::make_unique<VectorArrow>(context, kMomentum);
}

std::unique_ptr<DrawnOverlay> makeTrail(const OverlayContext& context, const Box&) {
  return std::make_unique<Trail>(context);
}

}  // namespace rotatebook::overlay
