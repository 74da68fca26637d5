#include "rigid/poinsot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "overlay/body_box.h"
#include "overlay/drawn_overlay.h"
#include "overlay/polhode_inset.h"
#include "physics/free_motion.h"
#include "physics/motion_start.h"

namespace rotatebook::overlay {
namespace {

constexpr Colour kRollingColour{0.72, 0.86, 1.0};
constexpr int kAround = 120;             // points of a circle
constexpr int kSpokes = 24;              // of the plane
constexpr double kBehind = 0.3;          // opacity of what the ellipsoid or the body hides
constexpr double kRollingTrail = 20;     // of the clip [s]
constexpr double kPlaneBeyond = 1.25;    // radius of the plane, in those of the herpolhode
constexpr double kSmallestPlane = 0.62;  // likewise, in the ellipsoid's longest semi-axis

using Curve = std::vector<Eigen::Vector3d>;

/// Returns a circle, closed.
Curve circle(const Eigen::Vector3d& centre, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Curve points;
  for (int i = 0; i <= kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    points.emplace_back(centre + std::cos(angle) * a + std::sin(angle) * b);
  }
  return points;
}

/// Returns the polhodes of the ellipsoid as curves of the unit sphere, of which it is an affine
/// image: the separatrix first, then some to each side of it.
std::vector<Curve> unitPolhodes(const Eigen::Vector3d& moments) {
  const MomentumSurfaces surfaces(moments, Eigen::Vector3d::Ones());
  Eigen::Vector3d sorted = surfaces.halfAxes();
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> radii{sorted[1]};
  for (const Eigen::Index i : {0, 1}) {
    for (const double share : {0.2, 0.6}) {
      radii.push_back(sorted[i] + share * (sorted[i + 1] - sorted[i]));
    }
  }
  std::vector<Curve> curves;
  for (const double radius : radii) {
    for (const bool side : {false, true}) {
      Curve curve = surfaces.polhode(radius, side);
      for (Eigen::Vector3d& point : curve) point = point.cwiseQuotient(surfaces.halfAxes());
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

/// The ellipsoid and the plane at one moment, in the camera's frame of reference.
struct Rolling {
  Eigen::Vector3d centre, eye;
  Eigen::Matrix3d frameFromUnit;  // from the sphere of which the ellipsoid is an image [m]
  Eigen::Matrix3d unitFromFrame;
  Eigen::Matrix3d plane;  // two unit vectors in it, which are at rest in the world; normal
  Eigen::Vector3d foot;   // of the normal through the centre
  double radius;          // of the plane's disc [m]
  BodyBox box;

  Eigen::Vector3d unitOf(const Eigen::Vector3d& point) const {
    return unitFromFrame * (point - centre);
  }
  /// Returns whether a point of the ellipsoid is on its side away from the camera.
  bool isFar(const Eigen::Vector3d& point) const { return unitOf(point).dot(unitOf(eye)) < 1; }
  /// Returns how far a point is beyond the plane, as the centre isn't. [m]
  double beyondPlane(const Eigen::Vector3d& point) const {
    return (point - foot).dot(plane.col(2));
  }
  bool isBeyondPlane() const { return beyondPlane(eye) > 0; }
};

/// Returns those points that are in front of the camera.
std::vector<Point> projected(const View& view, const Curve& curve) {
  std::vector<Point> points;
  for (const Eigen::Vector3d& point : curve) {
    if (const auto seen = view.projector(point)) points.push_back(*seen);
  }
  return points;
}

/// Returns the part of a convex polygon on the camera's side of the plane.
Curve beforePlane(const Curve& corners, const Rolling& rolling) {
  const double side = rolling.isBeyondPlane() ? 1 : -1;
  Curve part;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = corners[i];
    const Eigen::Vector3d& b = corners[(i + 1) % corners.size()];
    const double atA = side * rolling.beyondPlane(a), atB = side * rolling.beyondPlane(b);
    if (atA >= 0) part.push_back(a);
    if (atA * atB < 0) part.emplace_back(a + atA / (atA - atB) * (b - a));
  }
  return part;
}

/// Draws a curve; where `isFaint` says so of the middle of two points, faint.
template <typename IsFaint>
void drawCurveOf(const View& view, const Curve& curve, const Pen& pen, const IsFaint& isFaint) {
  const Pen faint{pen.colour, pen.width, kBehind * pen.opacity, 0};
  std::vector<Point> run;
  bool wasFaint = false;
  const auto end = [&] {
    view.canvas.line(run, wasFaint ? faint : pen);
    if (!run.empty()) run.assign(1, run.back());
  };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto point = view.projector(curve[i]);
    if (!point) {
      end();
      run.clear();
      continue;
    }
    const bool now = i > 0 && isFaint((curve[i - 1] + curve[i]) / 2);
    if (now != wasFaint) end();
    wasFaint = now;
    run.push_back(*point);
  }
  end();
}

/// Poinsot's construction around the body.
class PoinsotRolling final : public DrawnOverlay {
 public:
  explicit PoinsotRolling(const OverlayContext& context);
  void draw(const View& view) override;

 private:
  Rolling rollingAt(const View& view) const;
  void drawEllipsoid(const View& view, const Rolling& rolling) const;
  void drawPlane(const View& view, const Rolling& rolling) const;
  void drawTrails(const View& view, const Rolling& rolling) const;
  void drawTrail(const View& view, const Curve& trail, const Colour& colour, const Rolling& rolling,
                 bool onEllipsoid) const;

  OverlayContext context_;
  std::vector<std::size_t> starts_;
  Eigen::Vector3d semiAxes_;  // [m]
  Eigen::Matrix3d bodyFromPrincipal_;
  std::vector<Curve> polhodes_;
  // Of each sample.
  std::vector<rigid::Poinsot> moments_;  // lengths in m, contact point in body axes
};

PoinsotRolling::PoinsotRolling(const OverlayContext& context)
    : context_(context),
      starts_(physics::freeStarts(context.trajectory.samples, context.scene.motions[0].nudges)) {
  const auto inertia = physics::modelInertia(context.scene.motions[0]);
  bodyFromPrincipal_ = inertia.bodyFromPrincipal;
  polhodes_ = unitPolhodes(inertia.moments);
  semiAxes_ = rigid::inertiaSemiAxes(inertia.moments);
  const double scale = context.scene.motions[0].body.largestDimension() / 2 / semiAxes_.maxCoeff();
  semiAxes_ *= scale;
  for (const physics::Sample& sample : context.trajectory.samples) {
    const rigid::Poinsot poinsot =
        rigid::poinsotOf(inertia.moments, physics::momentumAlong(inertia, sample));
    moments_.push_back({scale * (bodyFromPrincipal_ * poinsot.contact), scale * poinsot.distance});
  }
}

Rolling PoinsotRolling::rollingAt(const View& view) const {
  const auto frame = static_cast<std::size_t>(view.frame);
  const physics::Sample& sample = context_.trajectory.samples[frame];
  const body::Cage& cage = view.sample.cage;
  const Eigen::Vector3d centre = cage.rowwise().mean();
  const Eigen::Vector3d normal = sample.angularMomentum.normalized();
  Eigen::Matrix3d plane;
  plane.col(0) = normal.unitOrthogonal();
  plane.col(1) = normal.cross(plane.col(0));
  plane.col(2) = normal;
  plane = context_.frame.fromWorld(sample) * plane;
  const Eigen::Matrix3d frameFromUnit =
      view.sample.attitude * bodyFromPrincipal_ * semiAxes_.asDiagonal();
  const double greatest = rigid::herpolhodeRadii(semiAxes_, moments_[frame].distance).greatest;
  return {centre,
          view.projector.eye(),
          frameFromUnit,
          frameFromUnit.inverse(),
          plane,
          centre + moments_[frame].distance * plane.col(2),
          std::max(kPlaneBeyond * greatest, kSmallestPlane * semiAxes_.maxCoeff()),
          BodyBox(context_.scene.motions[0].body, cage)};
}

void PoinsotRolling::draw(const View& view) {
  if (!moments_[static_cast<std::size_t>(view.frame)].contact.allFinite()) return;
  const Rolling rolling = rollingAt(view);
  if (rolling.isBeyondPlane()) {
    drawEllipsoid(view, rolling);
    drawPlane(view, rolling);
  } else {
    drawPlane(view, rolling);
    drawEllipsoid(view, rolling);
  }
  drawTrails(view, rolling);
}

void PoinsotRolling::drawEllipsoid(const View& view, const Rolling& rolling) const {
  const Scale& scale = context_.scale;
  const auto placed = [&](const Curve& unit) {
    Curve curve;
    for (const Eigen::Vector3d& point : unit)
      curve.emplace_back(rolling.centre + rolling.frameFromUnit * point);
    return curve;
  };
  const auto isFaint = [&](const Eigen::Vector3d& point) {
    return rolling.isFar(point) || rolling.box.hides(point, rolling.eye);
  };
  const Eigen::Vector3d eye = rolling.unitOf(rolling.eye);
  if (eye.norm() > 1) {
    const Eigen::Vector3d a = eye.unitOrthogonal(), b = eye.normalized().cross(a);
    const double size = std::sqrt(1 - 1 / eye.squaredNorm());
    const Curve rim = placed(circle(eye / eye.squaredNorm(), size * a, size * b));
    const std::vector<Point> outline = projected(view, rim);
    view.canvas.area(outline, {kRollingColour, 0.13});
    view.canvas.line(outline, {kRollingColour, 0.5 * scale.line, 0.75, 0.4 * scale.halo});
  }
  for (std::size_t i = 0; i < polhodes_.size(); ++i) {
    const bool isSeparatrix = i < 2;
    drawCurveOf(view, placed(polhodes_[i]),
                {isSeparatrix ? kWhite : kRollingColour, (isSeparatrix ? 0.45 : 0.35) * scale.line,
                 isSeparatrix ? 0.85 : 0.6, 0},
                isFaint);
  }
}

void PoinsotRolling::drawPlane(const View& view, const Rolling& rolling) const {
  const Scale& scale = context_.scale;
  const auto ring = [&](double radius) {
    return circle(rolling.foot, radius * rolling.plane.col(0), radius * rolling.plane.col(1));
  };
  const auto isFaint = [&](const Eigen::Vector3d& point) {
    return rolling.box.hides(point, rolling.eye);
  };
  std::vector<std::vector<Point>> body;
  for (const Curve& side : rolling.box.sidesFacing(rolling.eye))
    body.push_back(projected(view, beforePlane(side, rolling)));
  view.canvas.areaWithout(body, projected(view, ring(rolling.radius)), {kMomentumColour, 0.12});
  const double distance = moments_[static_cast<std::size_t>(view.frame)].distance;
  const auto radii = rigid::herpolhodeRadii(semiAxes_, distance);
  drawCurveOf(view, ring(rolling.radius),
              {kMomentumColour, 0.6 * scale.line, 0.8, 0.4 * scale.halo}, isFaint);
  for (const double radius : {radii.least, radii.greatest}) {
    drawCurveOf(view, ring(radius), {kMomentumColour, 0.4 * scale.line, 0.6, 0}, isFaint);
  }
  for (int i = 0; i < kSpokes; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSpokes;
    const Eigen::Vector3d along =
        std::cos(angle) * rolling.plane.col(0) + std::sin(angle) * rolling.plane.col(1);
    Curve spoke;
    for (const double share : {0.86, 0.93, 1.0})
      spoke.emplace_back(rolling.foot + share * rolling.radius * along);
    drawCurveOf(view, spoke, {kMomentumColour, 0.4 * scale.line, 0.5, 0}, isFaint);
  }
}

void PoinsotRolling::drawTrails(const View& view, const Rolling& rolling) const {
  const auto frame = static_cast<std::size_t>(view.frame);
  const auto length =
      static_cast<std::size_t>(context_.scene.clip.frameRate.framesIn(kRollingTrail));
  std::size_t first = *(std::ranges::upper_bound(starts_, frame) - 1);
  if (frame > length) first = std::max(first, frame - length);
  const physics::Sample& sample = context_.trajectory.samples[frame];
  const Eigen::Matrix3d frameFromWorld = context_.frame.fromWorld(sample);
  Curve polhode, herpolhode;
  for (std::size_t i = first; i <= frame; ++i) {
    if (!moments_[i].contact.allFinite()) continue;
    polhode.emplace_back(rolling.centre + view.sample.attitude * moments_[i].contact);
    const Eigen::Vector3d inWorld = context_.trajectory.samples[i].attitude * moments_[i].contact;
    herpolhode.emplace_back(rolling.centre + frameFromWorld * inWorld);
  }
  drawTrail(view, herpolhode, kMomentumColour, rolling, false);
  drawTrail(view, polhode, kVelocityColour, rolling, true);
  const Scale& scale = context_.scale;
  const auto c = view.projector(rolling.centre), f = view.projector(rolling.foot),
             p = view.projector(polhode.back());
  if (!c || !f || !p) return;
  view.canvas.line(std::array{*c, *f}, {kMomentumColour, 0.6 * scale.line, 0.9, 0.5 * scale.halo});
  view.canvas.line(std::array{*c, *p}, {kVelocityColour, 0.6 * scale.line, 0.9, 0.5 * scale.halo});
  view.canvas.disc(*f, 1.1 * scale.line, {kMomentumColour, 1});
  view.canvas.disc(*p, 1.8 * scale.line + scale.halo, {kDark, 0.7});
  view.canvas.disc(*p, 1.8 * scale.line, {kWhite, 1});
}

void PoinsotRolling::drawTrail(const View& view, const Curve& trail, const Colour& colour,
                               const Rolling& rolling, bool onEllipsoid) const {
  const Scale& scale = context_.scale;
  const auto isFaint = [&](const Eigen::Vector3d& point) {
    return rolling.box.hides(point, rolling.eye) || (onEllipsoid && rolling.isFar(point));
  };
  drawCurveOf(view, trail, {colour, 0.55 * scale.line, 0.6, 0}, isFaint);
  for (const double time : {1.6, 0.8, 0.4}) {
    const auto length = static_cast<std::size_t>(context_.scene.clip.frameRate.framesIn(time));
    const Curve last(trail.end() - static_cast<std::ptrdiff_t>(std::min(length, trail.size())),
                     trail.end());
    drawCurveOf(view, last, {colour, 0.9 * scale.line, 0.45, 0}, isFaint);
  }
}

}  // namespace

std::unique_ptr<DrawnOverlay> makePoinsot(const OverlayContext& context, const Box&) {
  return std::make_unique<PoinsotRolling>(context);
}

}  // namespace rotatebook::overlay
