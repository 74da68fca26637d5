#include "render/antialias/strips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace rotatebook::render {
namespace {

using Eigen::Vector2f;

// Widths below which a strip is narrow. Across a curved strip colours vary, so that a pixel shows
// any one of them; a flat strip has one, which any pixel that shows it has. [pixels]
constexpr float kNarrow = 1, kNarrowFlat = 0.5F;
constexpr std::size_t kLines = 3;  // Lines across a strip at which it is measured.

float cross(const Vector2f& a, const Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A line across a strip.
struct Line {
  Vector2f one, other;  // [pixels]
  float distance;       // From the camera, up to a common factor.

  Vector2f middle() const { return (one + other) / 2; }
};

/// Returns whether a part of the strip has the winding of a front face.
bool hasFrontFace(const std::array<Line, kLines>& lines, int winding) {
  for (std::size_t i = 0; i + 1 < kLines; ++i) {
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

/// Returns the strip's greatest width. [pixels]
float maxWidth(const std::array<Line, kLines>& lines) {
  float width = 0;
  for (std::size_t i = 0; i < kLines; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, kLines - 1);
    const Vector2f along = lines[after].middle() - lines[before].middle();
    const Vector2f across = lines[i].other - lines[i].one;
    const float length = along.norm();
    width = std::max(width, length > 1 ? std::abs(cross(along, across)) / length : across.norm());
  }
  return width;
}

}  // namespace

float ScreenStrip::shareAt(const Eigen::Vector2f& position) const {
  const float share = std::clamp(direction.dot(position - from), 0.0F, 1.0F);
  // Interpolate in perspective
  return share * distances[0] / (share * distances[0] + (1 - share) * distances[1]);
}

StripFinder::StripFinder(const geometry::Mesh& mesh) {
  for (const geometry::MeshStrip& strip : mesh.strips) {
    Strip measured{{}, DrawnStrips::kColumns * strip.length, strip.flat ? kNarrowFlat : kNarrow};
    for (std::size_t i = 0; i < kLines; ++i) {
      const std::size_t end = i * (strip.middle.size() - 1) / (kLines - 1);
      measured.lines.push_back({geometry::trilinearWeights(strip.sides[0][end]).cast<float>(),
                                geometry::trilinearWeights(strip.sides[1][end]).cast<float>()});
    }
    strips_.push_back(std::move(measured));
  }
}

void StripFinder::find(const body::Cage& cage, const Eigen::Matrix4d& clipFromWorld, int winding,
                       const Eigen::Vector2i& size, std::vector<ScreenStrip>& onScreen) const {
  const Eigen::Matrix<float, 4, 8> clip =
      (clipFromWorld * cage.colwise().homogeneous()).cast<float>();
  const Eigen::Array2f half = size.cast<float>().array() / 2;
  onScreen.assign(strips_.size(), {});
  // If a corner is behind the camera, a strip may be, too: leave all as not narrow.
  if (((clip.row(2) + clip.row(3)).array() <= 0).any()) return;
  const auto onPicture = [&](const Eigen::Vector4f& point) -> Vector2f {
    return ((point.head<2>().array() / point.w() + 1) * half).matrix();
  };
  for (std::size_t number = 0; number < strips_.size(); ++number) {
    std::array<Line, kLines> lines;
    for (std::size_t i = 0; i < kLines; ++i) {
      const auto& [one, other] = strips_[number].lines[i];
      const Eigen::Vector4f a = clip * one, b = clip * other;
      lines[i] = {onPicture(a), onPicture(b), (a.w() + b.w()) / 2};
    }
    if (!hasFrontFace(lines, winding) || maxWidth(lines) >= strips_[number].maxNarrowWidth)
      continue;
    const Vector2f line = lines.back().middle() - lines.front().middle();
    constexpr float kMinSquaredLength = 1e-3F;  // For a strip seen end-on. [pixels^2]
    onScreen[number] = {true,
                        lines.front().middle(),
                        line / std::max(line.squaredNorm(), kMinSquaredLength),
                        {lines.front().distance, lines.back().distance},
                        strips_[number].columns};
  }
}

}  // namespace rotatebook::render
