#include "render/backdrop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

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

}  // namespace rotatebook::render
