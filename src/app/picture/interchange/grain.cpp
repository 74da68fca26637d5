#include "picture/interchange/grain.h"

#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

namespace rotatebook::interchange {
namespace {

constexpr int kPixels = 128;     // Of a tile's side.
constexpr int kFineGrains = 46;  // surface.frag's are 2.3 times as fine.
// surface.frag's 0.65 and 0.35, and 0.86, as noise in space varies less than in a plane.
constexpr float kCoarse = 0.56F, kFine = 0.30F;

/// Returns a number from 0 to 1 that follows from a grain's place, as surface.frag's randomOf().
float randomOf(int x, int y) {
  std::uint32_t hash =
      static_cast<std::uint32_t>(x) * 0x8da6b343U ^ static_cast<std::uint32_t>(y) * 0xd8163841U;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6dU;
  hash = (hash ^ (hash >> 12)) * 0x297a2d39U;
  return static_cast<float>(hash >> 8) / 16777216;
}

/// Returns value noise from -1 to 1 at a pixel of a tile of so many grains.
float noiseAt(int column, int row, int grains) {
  const auto along = [grains](int pixel, std::array<int, 2>& around) {
    const float place = (static_cast<float>(pixel) + 0.5F) * static_cast<float>(grains) / kPixels;
    const float low = std::floor(place), inside = place - low;
    around = {static_cast<int>(low), (static_cast<int>(low) + 1) % grains};
    return inside * inside * (3 - 2 * inside);
  };
  std::array<int, 2> x{}, y{};
  const float across = along(column, x), down = along(row, y);
  const auto rowAt = [&](int at) {
    return randomOf(x[0], at) + across * (randomOf(x[1], at) - randomOf(x[0], at));
  };
  return 2 * (rowAt(y[0]) + down * (rowAt(y[1]) - rowAt(y[0]))) - 1;
}

/// Returns the sRGB value of linear light, both 0 to 1, as tone_curve.frag has it.
float encoded(float light) {
  const float root = std::sqrt(light), quarter = std::sqrt(root);
  return 0.280456565F * root + 0.874423457F * std::sqrt(root * quarter) - 0.0982486709F * quarter -
         0.00405176873F * light - 0.0525840109F;
}

}  // namespace

image::Image grainTile(float contrast) {
  image::Image tile(kPixels, kPixels, image::PixelFormat::Rgb8);
  for (int y = 0; y < kPixels; ++y) {
    std::uint8_t* pixel = tile.row(y);
    for (int x = 0; x < kPixels; ++x, pixel += 3) {
      const float grain =
          kCoarse * noiseAt(x, y, kGrainsOfTile) + kFine * noiseAt(x, y, kFineGrains);
      const float light = (1 + contrast * grain) / (1 + contrast);
      for (int i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(255 * encoded(light) + 0.5F);
    }
  }
  return tile;
}

int facedAxis(const geometry::Mesh& mesh, const std::uint32_t* corners,
              const Eigen::Vector3f& size) {
  const auto at = [&](int i) -> Eigen::Vector3f {
    return mesh.vertices[corners[i]].position.cwiseProduct(size);
  };
  int axis = 0;
  (at(1) - at(0)).cross(at(2) - at(0)).cwiseAbs().maxCoeff(&axis);
  return axis;
}

Eigen::Vector2f placeOnTiles(const Eigen::Vector3f& position, int axis,
                             const Eigen::Vector3f& grains) {
  const int across = (axis + 1) % 3, up = (axis + 2) % 3;
  return Eigen::Vector2f(position[across] * grains[across], position[up] * grains[up]) /
         kGrainsOfTile;
}

}  // namespace rotatebook::interchange
