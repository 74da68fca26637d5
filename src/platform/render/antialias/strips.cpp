#include "render/antialias/strips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rotatebook::render {
namespace {

using Eigen::Vector2f;

// Where a strip turns away, a pixel shows one of many colours; of a flat one it shows the colour,
// if only some pixel shows it. [pixels]
constexpr float kNarrow = 1, kNarrowFlat = 0.5F;
constexpr std::size_t kLooks = 3;  // Lines across a strip that are looked at.

float cross(const Vector2f& a, const Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A line across a strip.
struct Line {
  Vector2f one, other;  // [pixels]
  float distance;

  Vector2f middle() const { return (one + other) / 2; }
};

/// Whether a part of the strip turns as triangles do that are drawn.
bool looksHere(const std::array<Line, kLooks>& lines, int winding) {
  for (std::size_t i = 0; i + 1 < kLooks; ++i) {
    const Vector2f along = lines[i + 1].one - lines[i].one;
    for (const Line& line : {lines[i], lines[i + 1]}) {
      if (winding == 0 ||
          cross(along, line.other - lines[i].one) * static_cast<float>(winding) > 0) {
        return true;
      }
    }
  }
  return false;
}

float widest(const std::array<Line, kLooks>& lines) {
  float width = 0;
  for (std::size_t i = 0; i < kLooks; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, kLooks - 1);
    const Vector2f along = lines[after].middle() - lines[before].middle();
    const Vector2f across = lines[i].other - lines[i].one;
    const float length = along.norm();
    width = std::max(width, length > 1 ? std::abs(cross(along, across)) / length : across.norm());
  }
  return width;
}

}  // namespace

float ScreenStrip::shareAt(const Eigen::Vector2f& place) const {
  const float share = std::clamp(way.dot(place - from), 0.0F, 1.0F);
  return share * distances[0] / (share * distances[0] + (1 - share) * distances[1]);
}

StripFinder::StripFinder(const BookMesh& mesh) {
  for (const BookStrip& strip : mesh.strips) {
    Strip looks{{}, DrawnStrips::kColumns * strip.length, strip.flat ? kNarrowFlat : kNarrow};
    for (std::size_t i = 0; i < kLooks; ++i) {
      const std::size_t end = i * (strip.middle.size() - 1) / (kLooks - 1);
      looks.lines.push_back({sharesOfCorners(strip.sides[0][end]).cast<float>(),
                             sharesOfCorners(strip.sides[1][end]).cast<float>()});
    }
    strips_.push_back(std::move(looks));
  }
}

void StripFinder::find(const physics::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
                       const Eigen::Vector2i& size, std::vector<ScreenStrip>& seen) const {
  const Eigen::Matrix<float, 4, 8> clip =
      (clipFromWorld * cage.colwise().homogeneous()).cast<float>();
  const Eigen::Array2f half = size.cast<float>().array() / 2;
  seen.assign(strips_.size(), {});
  // Where a corner is behind the camera, so may be a strip.
  if (((clip.row(2) + clip.row(3)).array() <= 0).any()) return;
  const auto place = [&](const Eigen::Vector4f& point) -> Vector2f {
    return ((point.head<2>().array() / point.w() + 1) * half).matrix();
  };
  for (std::size_t number = 0; number < strips_.size(); ++number) {
    std::array<Line, kLooks> lines;
    for (std::size_t i = 0; i < kLooks; ++i) {
      const auto& [one, other] = strips_[number].lines[i];
      const Eigen::Vector4f a = clip * one, b = clip * other;
      lines[i] = {place(a), place(b), (a.w() + b.w()) / 2};
    }
    if (!looksHere(lines, winding) || widest(lines) >= strips_[number].narrow) continue;
    const Vector2f way = lines.back().middle() - lines.front().middle();
    constexpr float kMin = 1e-3F;  // Of a strip seen from its end. [squared pixels]
    seen[number] = {true,
                    lines.front().middle(),
                    way / std::max(way.squaredNorm(), kMin),
                    {lines.front().distance, lines.back().distance},
                    strips_[number].columns};
  }
}

}  // namespace rotatebook::render
