// Books to draw, and short ways to draw them.
#pragma once

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "body/cuboid.h"
#include "image/image.h"
#include "render/renderer.h"

namespace rotatebook::render::testing {

inline constexpr double kDegree = std::numbers::pi / 180;

/// A picture with a camera that sees the default book whole from +z, in any attitude.
inline RenderSettings settingsOf(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.camera.position = {0, 0, 0.9};
  return settings;
}

inline BookTextures builtinTextures() {
  return {builtinFront(), builtinSpine(), builtinBack()};
}

/// A turn about an axis by an angle. [degrees]
struct Turn {
  double angleDeg;
  Eigen::Vector3d axis;
};

/// `corners` after these turns, the first one first.
inline body::Cage turned(body::Cage corners, std::initializer_list<Turn> turns) {
  for (const Turn& turn : turns) {
    const Eigen::AngleAxisd rotation(turn.angleDeg * kDegree, turn.axis.normalized());
    corners = rotation.toRotationMatrix() * corners;
  }
  return corners;
}

/// The default book after these turns.
inline body::Cage book(std::initializer_list<Turn> turns = {}) {
  return turned(body::Cuboid{}.corners(), turns);
}

inline const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
inline const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
inline const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

/// A book bent far from a cuboid: twisted, tapered and with one corner pulled out.
inline body::Cage skewedBook() {
  body::Cage corners = body::Cuboid{}.corners();
  for (int i = 0; i < 8; ++i) {
    const double height = corners(1, i);
    corners.col(i) = Eigen::AngleAxisd(3 * height, kY) * corners.col(i);
    corners.col(i).x() *= 1 - 1.5 * height;
  }
  corners.col(7) += Eigen::Vector3d(0.05, 0.03, 0.08);
  return turned(corners, {{25, kY}, {20, kX}});
}

/// A book whose covers have passed through each other.
inline body::Cage insideOutBook() {
  body::Cage corners = body::Cuboid{}.corners();
  corners.row(2) *= -1;
  return turned(corners, {{-35, kY}, {20, kX}});
}

/// A book flying apart, with corners behind the camera of settingsOf().
inline body::Cage explodingBook() {
  body::Cage corners = book({{-30, kY}, {25, kX}});
  corners.col(7) += Eigen::Vector3d(0.3, 0.1, 1.2);
  corners.col(5) += Eigen::Vector3d(0.2, -0.4, 1.0);
  corners.col(0) *= 6;
  return corners;
}

/// Red, green, blue of one pixel.
struct Colour {
  int red = 0;
  int green = 0;
  int blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

inline Colour colourAt(const image::Image& picture, int x, int y) {
  const auto* pixel = picture.row(y) + x * image::bytesPerPixel(picture.format());
  return {pixel[0], pixel[1], pixel[2]};
}

inline void setColour(image::Image& picture, int x, int y, const Colour& colour) {
  auto* pixel = picture.row(y) + x * image::bytesPerPixel(picture.format());
  pixel[0] = static_cast<std::uint8_t>(colour.red);
  pixel[1] = static_cast<std::uint8_t>(colour.green);
  pixel[2] = static_cast<std::uint8_t>(colour.blue);
}

/// A picture of one colour.
inline image::Image plain(int width, int height, const Colour& colour) {
  image::Image picture(width, height, image::PixelFormat::Rgb8);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) setColour(picture, x, y, colour);
  }
  return picture;
}

/// All of `corners` drawn by `renderer`.
inline image::Image drawn(Renderer& renderer, const body::Cage& corners) {
  image::Image picture = renderer.makePicture();
  renderer.draw(corners, picture);
  return picture;
}

/// The picture without a book: it is drawn far to the right of the camera's view.
inline image::Image emptyPicture(Renderer& renderer) {
  const body::Cage beside = book().colwise() + Eigen::Vector3d(50, 0, 0);
  return drawn(renderer, beside);
}

}  // namespace rotatebook::render::testing
