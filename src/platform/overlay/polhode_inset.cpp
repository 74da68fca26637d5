#include "overlay/polhode_inset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include <Eigen/Cholesky>

#include "overlay/drawn_overlay.h"
#include "overlay/label_placement.h"
#include "physics/free_motion.h"
#include "physics/motion_start.h"

namespace rotatebook::overlay {
namespace {

constexpr int kCurvePoints = 180;
constexpr double kFilled = 0.44;    // share of the box, from its centre to the farthest point
constexpr double kFarthest = 1.25;  // larger momenta are drawn at this distance
constexpr double kPolhodeTrailTime = 1.5;  // of the clip [s]
constexpr Colour kEllipsoidColour{0.46, 0.54, 0.68};

/// Returns the rotation from the principal axes to right, up and toward the viewer, who looks from
/// the side of the middle axis and from a little above.
Eigen::Matrix3d viewFromAxes() {
  constexpr double kAzimuth = 1.02, kElevation = 0.42;  // [rad]
  const double ca = std::cos(kAzimuth), sa = std::sin(kAzimuth);
  const double ce = std::cos(kElevation), se = std::sin(kElevation);
  Eigen::Matrix3d view;
  view << ca, 0, -sa,          //
      -sa * se, ce, -ca * se,  //
      sa * ce, se, ca * ce;
  return view;
}

/// Returns the matrix A of the ellipsoid p^T A p = 1 with these half axes, in view coordinates.
Eigen::Matrix3d quadricOf(const Eigen::Vector3d& halfAxes) {
  const Eigen::Matrix3d view = viewFromAxes();
  return view * halfAxes.cwiseAbs2().cwiseInverse().asDiagonal() * view.transpose();
}

/// Returns the depth, toward the viewer, of the surface's near side at (x, y); nothing beside it.
std::optional<double> depthOf(const Eigen::Matrix3d& quadric, double x, double y) {
  const Point p(x, y);
  const double a = quadric(2, 2);
  const double b = quadric.block<1, 2>(2, 0).dot(p);
  const double c = p.dot(quadric.topLeftCorner<2, 2>() * p) - 1;
  const double root = b * b - a * c;
  if (root < 0) return std::nullopt;
  return (std::sqrt(root) - b) / a;
}

/// Returns the diffuse shading by a light from the upper left, 0.34 to 1.
double shadingOf(const Eigen::Matrix3d& quadric, const Eigen::Vector3d& point) {
  const Eigen::Vector3d light = Eigen::Vector3d(-0.45, 0.65, 0.62).normalized();
  const Eigen::Vector3d normal = (quadric * point).normalized();
  return 0.34 + 0.66 * std::max(0.0, normal.dot(light));
}

}  // namespace

MomentumSurfaces::MomentumSurfaces(const Eigen::Vector3d& moments,
                                   const Eigen::Vector3d& momentum) {
  const double twiceEnergy = momentum.cwiseAbs2().cwiseQuotient(moments).sum();
  halfAxes_ = (twiceEnergy * moments).cwiseSqrt() / momentum.norm();
}

double MomentumSurfaces::farthest() const {
  return std::max(1.0, halfAxes_.maxCoeff());
}

int MomentumSurfaces::roundAxis(double radius) const {
  Eigen::Index least = 0, most = 0;
  halfAxes_.minCoeff(&least);
  halfAxes_.maxCoeff(&most);
  const auto middle = 3 - least - most;
  return static_cast<int>(least == most || radius > halfAxes_[middle] ? most : least);
}

std::vector<Eigen::Vector3d> MomentumSurfaces::polhode(double radius, bool positive) const {
  const int axis = roundAxis(radius), b = (axis + 1) % 3, c = (axis + 2) % 3;
  const Eigen::Vector3d inverse = halfAxes_.cwiseAbs2().cwiseInverse();
  // The sphere's equation eliminates the axis's component from the ellipsoid's; this remains.
  const double rest = radius * radius * inverse[axis] - 1;
  const double widthB = std::sqrt(rest / (inverse[axis] - inverse[b]));
  const double widthC = std::sqrt(rest / (inverse[axis] - inverse[c]));
  if (!(std::isfinite(widthB) && std::isfinite(widthC) && widthB + widthC > 0)) return {};
  std::vector<Eigen::Vector3d> curve;
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCurvePoints;
    Eigen::Vector3d point;
    point[b] = widthB * std::cos(angle);
    point[c] = widthC * std::sin(angle);
    const double square = radius * radius - point[b] * point[b] - point[c] * point[c];
    point[axis] = (positive ? 1 : -1) * std::sqrt(std::max(0.0, square));
    curve.push_back(point);
  }
  return curve;
}

namespace {

/// Returns the angular momenta of all samples along the principal axes, in units of that of sample
/// `start` and no longer than kFarthest.
std::vector<Eigen::Vector3d> momentaOf(const OverlayContext& context,
                                       const rigid::PrincipalAxes& inertia, std::size_t start) {
  const auto& samples = context.trajectory.samples;
  const double unit = samples[start].angularMomentum.norm();
  std::vector<Eigen::Vector3d> momenta;
  for (const physics::Sample& sample : samples) {
    Eigen::Vector3d momentum = physics::momentumAlong(inertia, sample);
    if (unit > 0) momentum /= unit;
    const double size = momentum.stableNorm();
    momenta.push_back(size > kFarthest ? momentum * (kFarthest / size) : momentum);
  }
  return momenta;
}

/// An inset with both surfaces, their curves, and the present angular momentum among them, for a
/// body that moves freely from sample `start` on.
class FreePolhode {
 public:
  FreePolhode(const OverlayContext& context, const Box& box, const rigid::PrincipalAxes& inertia,
              std::size_t start)
      : context_(context),
        start_(start),
        bodyFromPrincipal_(inertia.bodyFromPrincipal),
        momenta_(momentaOf(context, inertia, start)),
        surfaces_(inertia.moments, momenta_[start]),
        ellipsoid_(quadricOf(surfaces_.halfAxes())) {
    const double titleRow = 1.2 * context.scale.smallLetters;
    centre_ = {box.x + box.width / 2, box.y + (titleRow + box.height) / 2};
    unit_ = kFilled * std::min(box.width, box.height - titleRow) / surfaces_.farthest();
    background_ = background(box);
  }

  std::size_t start() const { return start_; }

  const CachedLayer& still() const { return background_; }
  void draw(const View& view) const {
    const Scale& scale = context_.scale;
    const auto length = context_.scene.clip.frameRate.framesIn(kPolhodeTrailTime);
    std::vector<Point> trail;
    const auto start = static_cast<std::int64_t>(start_);
    for (auto i = std::max(start, view.frame - length); i <= view.frame; ++i) {
      trail.push_back(positionOf(momenta_[static_cast<std::size_t>(i)]));
    }
    view.canvas.line(trail, {kWhite, 0.6 * scale.line, 0.75, 0});
    const Eigen::Vector3d& now = momenta_[static_cast<std::size_t>(view.frame)];
    const double radius = 1.5 * scale.line, opacity = isInFront(now) ? 1 : 0.55;
    view.canvas.disc(positionOf(now), radius + 1.2 * scale.halo, {kDark, 0.8 * opacity});
    view.canvas.disc(positionOf(now), radius, {kWhite, opacity});
  }

 private:
  /// Returns the position on the picture of a point in the space of momenta.
  Point positionOf(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d seen = viewFromAxes() * point;
    return centre_ + unit_ * Point(seen.x(), -seen.y());
  }

  /// Returns whether a point of the ellipsoid is on its near side.
  bool isInFront(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d seen = viewFromAxes() * point;
    return (ellipsoid_ * seen).z() > 0;
  }

  CachedLayer background(const Box& box) const {
    const Scale& scale = context_.scale;
    Canvas canvas = context_.canvas();
    canvas.roundedBox(box, 0.5 * scale.smallLetters, {kDark, kBacking});
    drawSolids(canvas);
    drawPolhodes(canvas);
    writeTexts(canvas, box);
    return canvas.take();
  }

  /// Draws the two solids, shaded; the sphere has its own colour where it is in front.
  void drawSolids(Canvas& canvas) const {
    const int reach = static_cast<int>(std::ceil(1.05 * unit_ * surfaces_.farthest()));
    const Point corner(std::floor(centre_.x()) - reach, std::floor(centre_.y()) - reach);
    Layer layer{0, 0, 2 * reach, 2 * reach, {}};
    for (int y = 0; y < layer.height; ++y) {
      for (int x = 0; x < layer.width; ++x) addPixel(layer, corner + Point(x, y));
    }
    canvas.paint(layer, corner);
  }

  /// Appends the pixel at `position`, the mean of some samples in it.
  void addPixel(Layer& layer, const Point& position) const {
    constexpr int kSide = 3;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int i = 0; i < kSide * kSide; ++i) {
      const double dx = (i % kSide + 0.5) / kSide, dy = (i / kSide + 0.5) / kSide;
      sum += colourAt((position.x() + dx - centre_.x()) / unit_,
                      (centre_.y() - position.y() - dy) / unit_);
    }
    for (const Eigen::Index channel : {2, 1, 0, 3}) {
      layer.pixels.push_back(
          static_cast<std::uint8_t>(std::lround(255 * sum[channel] / (kSide * kSide))));
    }
  }

  /// Returns red, green, blue, premultiplied, and alpha.
  Eigen::Vector4d colourAt(double x, double y) const {
    const Eigen::Matrix3d sphere = Eigen::Matrix3d::Identity();
    const auto near = depthOf(ellipsoid_, x, y), ball = depthOf(sphere, x, y);
    if (!near && !ball) return Eigen::Vector4d::Zero();
    if (!near) return shaded(sphere, {x, y, *ball}, kMomentumColour, 0.3);
    const bool inside = ball && *ball > *near;
    return shaded(ellipsoid_, {x, y, *near},
                  mixed(kEllipsoidColour, kMomentumColour, inside ? 0.45 : 0), 0.92);
  }

  static Eigen::Vector4d shaded(const Eigen::Matrix3d& quadric, const Eigen::Vector3d& point,
                                const Colour& colour, double alpha) {
    const double light = alpha * shadingOf(quadric, point);
    return {light * colour.red, light * colour.green, light * colour.blue, alpha};
  }

  void drawPolhodes(Canvas& canvas) const {
    const Scale& scale = context_.scale;
    Eigen::Vector3d sorted = surfaces_.halfAxes();
    std::sort(sorted.begin(), sorted.end());
    const auto both = [&](double radius, const Pen& pen) {
      for (const bool side : {false, true}) drawCurve(canvas, surfaces_.polhode(radius, side), pen);
    };
    for (const Eigen::Index i : {0, 1}) {
      for (const double share : {0.25, 0.7}) {
        both(sorted[i] + share * (sorted[i + 1] - sorted[i]), {kWhite, 0.35 * scale.line, 0.42, 0});
      }
    }
    both(sorted[1], {kWhite, 0.5 * scale.line, 0.85, 0});
    const bool positive = momenta_[start_][surfaces_.roundAxis(1)] > 0;
    drawCurve(canvas, surfaces_.polhode(1, !positive), {kMomentumColour, 0.5 * scale.line, 0.8, 0});
    drawCurve(canvas, surfaces_.polhode(1, positive),
              {kMomentumColour, 0.9 * scale.line, 1, 0.7 * scale.halo});
  }

  /// Draws a curve on the ellipsoid, its far side fainter.
  void drawCurve(Canvas& canvas, const std::vector<Eigen::Vector3d>& points, Pen pen) const {
    const Pen farPen{pen.colour, pen.width, 0.3 * pen.opacity, 0};
    for (const bool front : {false, true}) drawSide(canvas, points, front, front ? pen : farPen);
  }

  /// Draws the parts of a curve on one side, each up to its first point beyond.
  void drawSide(Canvas& canvas, const std::vector<Eigen::Vector3d>& points, bool front,
                const Pen& pen) const {
    std::vector<Point> run;
    for (const Eigen::Vector3d& point : points) {
      run.push_back(positionOf(point));
      if (isInFront(point) == front) continue;
      if (run.size() > 2) canvas.line(run, pen);
      run.assign(1, run.back());
    }
    if (run.size() > 1) canvas.line(run, pen);
  }

  /// Writes the title, and draws the ends of the axes with their letters.
  void writeTexts(Canvas& canvas, const Box& box) const {
    const Scale& scale = context_.scale;
    TextStyle style{.size = scale.smallLetters, .bold = true, .colour = kWhite, .halo = scale.halo};
    const Layer title =
        context_.type.draw(context_.scene.overlay.words[scene::Word::Polhode], style, scale.width);
    const double padding = 0.5 * scale.smallLetters;
    const Point corner(box.x + padding, box.y + 0.6 * padding);
    std::vector<Box> taken;
    if (box.holds(boxOf(title, corner))) {
      canvas.write(title, corner);
      taken.push_back(boxOf(title, corner).grown(padding));
    }
    const auto tipOf = [&](std::size_t axis) {
      return Eigen::Vector3d(Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis)) *
                             surfaces_.farthest() * 1.08);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      canvas.line(std::array{positionOf(tipOf(i) * 0.92), positionOf(tipOf(i))},
                  {kAxisColours[i], 0.5 * scale.line, 0.9, 0});
    }
    const bool principal = !bodyFromPrincipal_.isIdentity(1e-9);
    for (std::size_t i = 0; i < 3; ++i) {
      style.colour = kAxisColours[i];
      const std::string name(1, (principal ? "123" : "xyz")[i]);
      const Point tip = positionOf(tipOf(i));
      writeBeside(canvas, context_.type.draw(name, style, scale.width), tip,
                  tip - positionOf(Eigen::Vector3d::Zero()), 0.65 * scale.smallLetters, box, taken);
    }
  }

  OverlayContext context_;
  std::size_t start_;
  Eigen::Matrix3d bodyFromPrincipal_;
  std::vector<Eigen::Vector3d> momenta_;  // of each sample, see momentaOf()
  MomentumSurfaces surfaces_;
  Eigen::Matrix3d ellipsoid_;  // see quadricOf()
  Point centre_;
  double unit_;  // length of a momentum of 1 [pixels]
  CachedLayer background_;
};

/// The insets of a motion, a new one after each nudge.
class PolhodeInset final : public DrawnOverlay {
 public:
  PolhodeInset(const OverlayContext& context, const Box& box) {
    const auto inertia = physics::modelInertia(context.scene.motions[0]);
    for (const std::size_t start :
         physics::freeStarts(context.trajectory.samples, context.scene.motions[0].nudges))
      insets_.emplace_back(context, box, inertia, start);
  }

  const CachedLayer* still(std::int64_t frame) const override { return &at(frame).still(); }
  void draw(const View& view) override { at(view.frame).draw(view); }

 private:
  const FreePolhode& at(std::int64_t frame) const {
    const auto number = static_cast<std::size_t>(frame);
    return *(std::ranges::upper_bound(insets_, number, {}, &FreePolhode::start) - 1);
  }

  std::vector<FreePolhode> insets_;
};

}  // namespace

std::unique_ptr<DrawnOverlay> makePolhode(const OverlayContext& context, const Box& box) {
  return std::make_unique<PolhodeInset>(context, box);
}

}  // namespace rotatebook::overlay
