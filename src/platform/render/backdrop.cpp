#include "render/backdrop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/LU>

#include "embedded/render.h"

namespace rotatebook::render {
namespace {

/// Fills an opaque picture.
void paint(const Rgb& colour, image::Image& picture) {
  const std::array<std::uint8_t, 4> pixel{colour.red, colour.green, colour.blue, 255};
  const auto size = static_cast<std::ptrdiff_t>(image::bytesPerPixel(picture.format()));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      std::copy_n(pixel.begin(), size, picture.row(y) + size * x);
    }
  }
}

}  // namespace

Backdrop::Backdrop(const RenderSettings& settings) : settings_(settings) {
  if (settings.background == Background::Studio)
    shaders_.emplace("studio", wholePictureVertexShader(),
                     std::initializer_list<ShaderSource>{studioFragmentShader()});
  if (settings.background == Background::Stars)
    shaders_.emplace("stars", wholePictureVertexShader(),
                     std::initializer_list<ShaderSource>{starsFragmentShader()});
}

void Backdrop::draw(const FrameTarget& target, const Eigen::Matrix4f& skyFromPicture,
                    image::Image& picture) const {
  if (settings_.background == Background::Plain) paint(settings_.plainColour, picture);
  if (!shaders_) return;
  const geometry::PixelRect everything{0, 0, picture.width(), picture.height()};
  target.begin(everything);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  shaders_->use();
  const Eigen::Vector2i size(settings_.width, settings_.height);
  shaders_->set("pictureSize", Eigen::Vector2f(size.cast<float>()));
  shaders_->set("supersample", settings_.supersample);
  shaders_->set("skyFromPicture", skyFromPicture);
  const GlVertexArray noVertices;
  glBindVertexArray(noVertices.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  target.readBack({&everything, 1}, picture);
}

Eigen::Matrix4f skyFromPicture(const geometry::Camera& camera, const geometry::Screen& screen,
                               const Eigen::Matrix3d& worldFromFrame) {
  // The depth range, which follows the points, isn't in the rows that are used
  const Eigen::Matrix4d clip =
      geometry::project(camera, physics::Cage::Zero(), screen).clipFromWorld;
  Eigen::Matrix3d clipFromDirection;
  clipFromDirection << clip.block<2, 3>(0, 0), clip.block<1, 3>(3, 0);
  const double shorter = std::min(screen.width, screen.height);
  const Eigen::Vector3d clipFromPicture(shorter / screen.width, shorter / screen.height, 1);
  Eigen::Matrix4d sky = Eigen::Matrix4d::Identity();
  sky.topLeftCorner<3, 3>() =
      worldFromFrame * clipFromDirection.inverse() * clipFromPicture.asDiagonal();
  return sky.cast<float>();
}

}  // namespace rotatebook::render
