#include "overlay/polhode_inset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include <Eigen/Cholesky>

#include "overlay/label_placement.h"
#include "physics/motion_start.h"

namespace rotatebook::overlay {
namespace {

constexpr int kCurvePoints = 180;
constexpr double kFilled = 0.44;    // of the box, from its middle to the surfaces' farthest point
constexpr double kFarthest = 1.25;  // a momentum that grows without limit is drawn there
constexpr double kTrailTime = 1.5;  // of the clip [s]
constexpr Colour kEllipsoidColour{0.46, 0.54, 0.68};

/// From the principal axes to right, up and toward the viewer: from the side of the median axis, a
/// little above.
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

/// The matrix A of the ellipsoid p^T A p = 1 with these half axes, in the view's coordinates.
Eigen::Matrix3d quadricOf(const Eigen::Vector3d& halfAxes) {
  const Eigen::Matrix3d view = viewFromAxes();
  return view * halfAxes.cwiseAbs2().cwiseInverse().asDiagonal() * view.transpose();
}

/// How near to the viewer the surface is at (x, y); nothing beside it.
std::optional<double> depthOf(const Eigen::Matrix3d& quadric, double x, double y) {
  const Point p(x, y);
  const double a = quadric(2, 2);
  const double b = quadric.block<1, 2>(2, 0).dot(p);
  const double c = p.dot(quadric.topLeftCorner<2, 2>() * p) - 1;
  const double root = b * b - a * c;
  if (root < 0) return std::nullopt;
  return (std::sqrt(root) - b) / a;
}

/// Where a point of the momentum's space is on the picture.
Point placeOn(const Point& middle, double pixels, const Eigen::Vector3d& point) {
  const Eigen::Vector3d seen = viewFromAxes() * point;
  return middle + pixels * Point(seen.x(), -seen.y());
}

/// From dark to light, by the light from above on the left.
double lightOn(const Eigen::Matrix3d& quadric, const Eigen::Vector3d& point) {
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
  const auto median = 3 - least - most;
  return static_cast<int>(least == most || radius > halfAxes_[median] ? most : least);
}

std::vector<Eigen::Vector3d> MomentumSurfaces::polhode(double radius, bool positive) const {
  const int axis = roundAxis(radius), b = (axis + 1) % 3, c = (axis + 2) % 3;
  const Eigen::Vector3d inverse = halfAxes_.cwiseAbs2().cwiseInverse();
  // What is left of the ellipsoid's equation, once the sphere's has taken the axis out of it.
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

/// Draws on the inset's still part.
class SurfacePainter {
 public:
  SurfacePainter(Canvas& canvas, const MomentumSurfaces& surfaces, const Point& middle,
                 double pixels)
      : canvas_(canvas),
        surfaces_(surfaces),
        ellipsoid_(quadricOf(surfaces.halfAxes())),
        middle_(middle),
        pixels_(pixels) {}

  Point placeOf(const Eigen::Vector3d& point) const { return placeOn(middle_, pixels_, point); }

  /// The two solids, shaded; the sphere where it is before the ellipsoid in its own colour.
  void solids() {
    const int reach = static_cast<int>(std::ceil(1.05 * pixels_ * surfaces_.farthest()));
    Layer layer{static_cast<int>(std::floor(middle_.x())) - reach,
                static_cast<int>(std::floor(middle_.y())) - reach,
                2 * reach,
                2 * reach,
                {}};
    for (int y = 0; y < layer.height; ++y) {
      for (int x = 0; x < layer.width; ++x) addPixel(layer, x, y);
    }
    const Point place(layer.x, layer.y);
    layer.x = layer.y = 0;
    canvas_.paint(layer, place);
  }

  /// A curve on the ellipsoid, its far side fainter.
  void curve(const std::vector<Eigen::Vector3d>& points, const Pen& pen) {
    for (const bool front : {false, true}) {
      Pen side = pen;
      if (!front) {
        side.opacity *= 0.3;
        side.halo = 0;
      }
      drawSide(points, front, side);
    }
  }

 private:
  /// The parts of a curve on the near side or on the other, each on to its first point beyond.
  void drawSide(const std::vector<Eigen::Vector3d>& points, bool front, const Pen& pen) {
    std::vector<Point> run;
    for (const Eigen::Vector3d& point : points) {
      run.push_back(placeOf(point));
      if (((ellipsoid_ * viewFromAxes() * point).z() > 0) == front) continue;
      if (run.size() > 2) canvas_.line(run, pen);
      run.assign(1, run.back());
    }
    if (run.size() > 1) canvas_.line(run, pen);
  }

  /// The mean of some points of the pixel.
  void addPixel(Layer& layer, int x, int y) const {
    constexpr int kSide = 3;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int i = 0; i < kSide * kSide; ++i) {
      const double dx = (i % kSide + 0.5) / kSide, dy = (i / kSide + 0.5) / kSide;
      sum += colourAt((layer.x + x + dx - middle_.x()) / pixels_,
                      (middle_.y() - layer.y - y - dy) / pixels_);
    }
    for (const Eigen::Index channel : {2, 1, 0, 3}) {
      layer.pixels.push_back(
          static_cast<std::uint8_t>(std::lround(255 * sum[channel] / (kSide * kSide))));
    }
  }

  /// Red, green, blue, alpha; colours times alpha.
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
    const double light = alpha * lightOn(quadric, point);
    return {light * colour.red, light * colour.green, light * colour.blue, alpha};
  }

  Canvas& canvas_;
  const MomentumSurfaces& surfaces_;
  Eigen::Matrix3d ellipsoid_;
  Point middle_;
  double pixels_;
};

/// Levels between `low` and `high`, the ends left out.
std::vector<double> levelsBetween(double low, double high) {
  std::vector<double> levels;
  for (const double share : {0.25, 0.7}) levels.push_back(low + share * (high - low));
  return levels;
}

void drawPolhodes(SurfacePainter& painter, const MomentumSurfaces& surfaces, const Scale& scale,
                  bool positive) {
  Eigen::Vector3d sorted = surfaces.halfAxes();
  std::sort(sorted.begin(), sorted.end());
  const auto both = [&](double radius, const Pen& pen) {
    for (const bool side : {false, true}) painter.curve(surfaces.polhode(radius, side), pen);
  };
  const Pen thin{kWhite, 0.35 * scale.line, 0.42, 0};
  for (const double radius : levelsBetween(sorted[0], sorted[1])) both(radius, thin);
  for (const double radius : levelsBetween(sorted[1], sorted[2])) both(radius, thin);
  both(sorted[1], {kWhite, 0.5 * scale.line, 0.85, 0});
  painter.curve(surfaces.polhode(1, !positive), {kMomentumColour, 0.5 * scale.line, 0.8, 0});
  painter.curve(surfaces.polhode(1, positive),
                {kMomentumColour, 0.9 * scale.line, 1, 0.7 * scale.halo});
}

/// Titles and letters of the inset: "x" where a half axis ends.
void writeLetters(Canvas& canvas, const OverlayContext& context, const SurfacePainter& painter,
                  const Box& box, double farthest, bool principal) {
  const Scale& scale = context.scale;
  const TextStyle style{
      .size = scale.smallLetters, .bold = true, .colour = kWhite, .halo = scale.halo};
  const Layer title = context.type.draw("Polhode", style, scale.width);
  const double padding = 0.5 * scale.smallLetters;
  const Point corner(box.x + padding, box.y + 0.6 * padding);
  const bool titled = box.holds(boxOf(title, corner));
  if (titled) canvas.write(title, corner);
  LabelPlacement letters;
  std::array<Layer, 3> words;
  for (std::size_t i = 0; i < 3; ++i) {
    TextStyle own = style;
    own.colour = kAxisColours[i];
    words[i] = context.type.draw(principal ? std::string(1, "123"[i]) : std::string(1, "xyz"[i]),
                                 own, scale.width);
    const auto axis = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d end = Eigen::Vector3d::Unit(axis) * farthest * 1.08;
    canvas.line(std::array{painter.placeOf(end * 0.92), painter.placeOf(end)},
                {own.colour, 0.5 * scale.line, 0.9, 0});
    const Point tip = painter.placeOf(end);
    letters.add(words[i], tip, tip - painter.placeOf(Eigen::Vector3d::Zero()),
                0.65 * scale.smallLetters);
  }
  letters.write(canvas, box, titled ? std::vector{boxOf(title, corner)} : std::vector<Box>{});
}

/// What the title takes of the inset's height. [pixels]
double titleRow(const OverlayContext& context) {
  return 1.2 * context.scale.smallLetters;
}

physics::PrincipalAxes inertiaOf(const OverlayContext& context) {
  return physics::modelInertia(context.scene.motion());
}

std::vector<Eigen::Vector3d> momentaOf(const OverlayContext& context,
                                       const physics::PrincipalAxes& inertia) {
  const auto& samples = context.trajectory.samples;
  const double start = samples.front().angularMomentum.norm();
  std::vector<Eigen::Vector3d> momenta;
  for (const physics::Sample& sample : samples) {
    Eigen::Vector3d momentum = inertia.bodyFromPrincipal.transpose() *
                               (sample.attitude.conjugate() * sample.angularMomentum);
    if (start > 0) momentum /= start;
    const double size = momentum.stableNorm();
    momenta.push_back(size > kFarthest ? momentum * (kFarthest / size) : momentum);
  }
  return momenta;
}

}  // namespace

PolhodeInset::PolhodeInset(const OverlayContext& context, const Box& box)
    : context_(context),
      inertia_(inertiaOf(context)),
      momenta_(momentaOf(context, inertia_)),
      surfaces_(inertia_.moments, momenta_.front()),
      middle_(box.x + box.width / 2, box.y + (titleRow(context) + box.height) / 2),
      pixels_(kFilled * std::min(box.width, box.height - titleRow(context)) / surfaces_.farthest()),
      cached_(stillPart(box)) {}

CachedLayer PolhodeInset::stillPart(const Box& box) const {
  const Scale& scale = context_.scale;
  Canvas canvas(scale.width, scale.height);
  canvas.roundedBox(box, 0.5 * scale.smallLetters, {kDark, 0.62});
  SurfacePainter painter(canvas, surfaces_, middle_, pixels_);
  painter.solids();
  const int axis = surfaces_.roundAxis(1);
  drawPolhodes(painter, surfaces_, scale, momenta_.front()[axis] > 0);
  const bool principal = !inertia_.bodyFromPrincipal.isIdentity(1e-9);
  writeLetters(canvas, context_, painter, box, surfaces_.farthest(), principal);
  return canvas.take();
}

void PolhodeInset::draw(const View& view) {
  view.canvas.lay(cached_, view.picture);
  const Scale& scale = context_.scale;
  const auto length = context_.scene.clip.frameRate.framesIn(kTrailTime);
  std::vector<Point> trail;
  for (auto i = std::max<std::int64_t>(0, view.frame - length); i <= view.frame; ++i) {
    trail.push_back(placeOn(middle_, pixels_, momenta_[static_cast<std::size_t>(i)]));
  }
  view.canvas.line(trail, {kWhite, 0.6 * scale.line, 0.75, 0});
  const Eigen::Vector3d& now = momenta_[static_cast<std::size_t>(view.frame)];
  const Eigen::Vector3d seen = viewFromAxes() * now;
  const bool front = (quadricOf(surfaces_.halfAxes()) * seen).z() > 0;
  const double radius = 1.5 * scale.line, opacity = front ? 1 : 0.55;
  const Point place = placeOn(middle_, pixels_, now);
  view.canvas.disc(place, radius + 1.2 * scale.halo, {kDark, 0.8 * opacity});
  view.canvas.disc(place, radius, {kWhite, opacity});
}

}  // namespace rotatebook::overlay
