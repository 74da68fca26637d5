#include "overlay/forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "base/number_text.h"
#include "overlay/body_box.h"
#include "overlay/drawn_overlay.h"
#include "overlay/rounded.h"
#include "scene/body_forces.h"

namespace rotatebook::overlay {
namespace {

using Eigen::Vector3d;
using rigid::ForcesPerMass;
using scene::ReferenceFrame;
using scene::Word;

constexpr double kLongestForce = 0.65;   // arrow [distances from the body's centre to its corners]
constexpr double kShortestForce = 0.02;  // of a force that is drawn [likewise]

/// A kind of force: its name, its colour, and the frames in which there is one.
struct ForceKind {
  Word word;
  Colour colour;
  Vector3d ForcesPerMass::*force;
  bool (*isIn)(const scene::MotionFrame& frame);
};

const std::array kForceKinds{
    ForceKind{Word::HeldByTheBody, kWhite, &ForcesPerMass::held, [](const auto&) { return true; }},
    ForceKind{Word::Centrifugal, kCentrifugalColour, &ForcesPerMass::centrifugal,
              [](const auto& frame) { return frame.turns(); }},
    ForceKind{Word::Coriolis, kCoriolisColour, &ForcesPerMass::coriolis,
              [](const auto& frame) { return frame.kind() == ReferenceFrame::Turning; }},
    ForceKind{Word::Euler, kEulerColour, &ForcesPerMass::euler,
              [](const auto& frame) { return frame.kind() == ReferenceFrame::Body; }},
};

std::vector<ForceKind> kindsIn(const scene::MotionFrame& frame) {
  std::vector<ForceKind> kinds;
  std::ranges::copy_if(kForceKinds, std::back_inserter(kinds),
                       [&](const ForceKind& kind) { return kind.isIn(frame); });
  return kinds;
}

/// Returns a box so small that it hides no arrow: forces are seen through the body.
BodyBox hidingNothing(double reach) {
  const body::Cuboid tiny{Vector3d::Constant(1e-6 * reach)};
  return {tiny, tiny.corners()};
}

/// The forces on the body's masses, for each kilogram of them, as arrows to one scale, which the
/// legend states; of a body that isn't rigid, as if it were at that moment.
class Forces final : public DrawnOverlay {
 public:
  /// Takes the box of the legend.
  Forces(const OverlayContext& context, const Box& legend);
  void draw(const View& view) override;

 private:
  void drawMass(const View& view, const BodyBox& box, std::size_t mass,
                const ForcesPerMass& forces) const;
  void makeLegend(const Box& legend);
  void drawBar(const View& view);

  OverlayContext context_;
  std::vector<ForceKind> kinds_;
  scene::BodyForces bodyForces_;
  double reach_;        // of the body from its centre [m]
  double largest_ = 0;  // has the longest arrow [N/kg]
  double bar_ = 0;      // of the legend [N/kg]
  BodyBox nothing_;
  Point barAt_{0, 0};  // its left end [pixels]
  CachedLayer legend_;
};

Forces::Forces(const OverlayContext& context, const Box& legend)
    : context_(context),
      kinds_(kindsIn(context.frame)),
      bodyForces_(context.scene.motions[0], context.frame),
      reach_(context.scene.motions[0].body.size.norm() / 2),
      nothing_(hidingNothing(reach_)) {
  for (const physics::Sample& sample : context.trajectory.samples)
    largest_ = std::max(largest_, bodyForces_.largestAt(sample));
  const double first = bodyForces_.largestAt(context.trajectory.samples.front());
  largest_ = std::min(largest_, scene::kLargestForce * first);
  if (largest_ > 0 && !context.scene.textless) makeLegend(legend);
}

void Forces::makeLegend(const Box& legend) {
  const Scale& scale = context_.scale;
  const double row = kForcesScale * scale.smallLetters;
  const double height = std::min(row * static_cast<double>(kinds_.size() + 1), legend.height);
  const Box box{legend.x, legend.bottom() - height, legend.width, height};
  const TextStyle style{.size = scale.smallLetters, .colour = kWhite, .halo = scale.halo};
  const scene::Words& words = context_.scene.overlay.words;
  Canvas canvas = context_.canvas();
  canvas.roundedBox(box.grown(0.4 * scale.smallLetters), 0.4 * scale.smallLetters,
                    {kDark, kBacking});
  const double sample = 1.6 * scale.smallLetters;
  double y = box.y;
  for (const ForceKind& kind : kinds_) {
    if (height < 2 * row) break;  // the scale alone has room
    const double middle = y + 0.6 * scale.smallLetters;
    const std::array ends{Point(box.x, middle), Point(box.x + sample, middle)};
    canvas.line(ends, {kind.colour, 1.2 * scale.line, 1, 0});
    canvas.write(context_.type.draw(words[kind.word], style, scale.width),
                 {box.x + sample + 0.6 * scale.smallLetters, y});
    y += row;
  }
  bar_ = roundedDown(0.35 * largest_);
  const Layer label =
      context_.type.draw(words.number(shortestText(bar_)) + " N/kg", style, scale.width);
  canvas.write(label, {std::round(box.x + box.width - boxOf(label).width), y});
  barAt_ = {box.x, y + 0.6 * scale.smallLetters};
  legend_ = canvas.take();
}

void Forces::drawBar(const View& view) {
  // As long as a force at the body's centre across the view
  const Vector3d centre = view.sample.cage.rowwise().mean();
  const Vector3d across = (view.projector.eye() - centre).cross(Vector3d(0.3, 1, 0.2)).normalized();
  const double length = bar_ / largest_ * kLongestForce * reach_;
  const auto a = view.projector(centre), b = view.projector(centre + length * across);
  if (!a || !b) return;
  const double tick = 0.3 * context_.scale.smallLetters, width = (*b - *a).norm();
  const std::array<Point, 6> ends{barAt_,
                                  barAt_ + Point(width, 0),
                                  barAt_ - Point(0, tick),
                                  barAt_ + Point(0, tick),
                                  barAt_ + Point(width, -tick),
                                  barAt_ + Point(width, tick)};
  view.canvas.lines(ends, {kWhite, 0.5 * context_.scale.line, 1, 0});
}

void Forces::drawMass(const View& view, const BodyBox& box, std::size_t mass,
                      const ForcesPerMass& forces) const {
  const Scale& scale = context_.scale;
  const Vector3d place = box.centre() + box.map() * bodyForces_.places()[mass];
  for (const ForceKind& kind : kinds_) {
    const Vector3d force = forces.*kind.force;
    const double size = force.stableNorm();
    const double length = std::min(size / largest_, 1.0) * kLongestForce * reach_;
    if (!(length > kShortestForce * reach_)) continue;
    const bool isHeld = kind.word == Word::HeldByTheBody;
    const Pen pen{kind.colour, (isHeld ? 0.7 : 1.2) * scale.line, isHeld ? 0.75 : 1.0, scale.halo};
    drawArrow(view, nothing_, {place, place + length / size * force, pen, nullptr, {}});
  }
  const auto point = view.projector(place);
  if (!point) return;
  view.canvas.disc(*point, 1.5 * scale.line + scale.halo, {kDark, 0.6});
  view.canvas.disc(*point, 1.5 * scale.line, {kWhite, 1});
}

void Forces::draw(const View& view) {
  if (!(largest_ > 0)) return;
  const BodyBox box(context_.scene.motions[0].body, view.sample.cage);
  const std::vector<ForcesPerMass> forces = bodyForces_.at(view.sample);
  for (std::size_t i = 0; i < forces.size(); ++i) drawMass(view, box, i, forces[i]);
  if (context_.scene.textless) return;
  view.canvas.lay(legend_, view.picture);
  drawBar(view);
}

}  // namespace

std::unique_ptr<DrawnOverlay> makeForces(const OverlayContext& context, const Box& legend) {
  return std::make_unique<Forces>(context, legend);
}

}  // namespace rotatebook::overlay
