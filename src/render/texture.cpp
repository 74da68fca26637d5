#include "render/texture.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "image/smaller.h"

namespace rotatebook::render {
namespace {

constexpr float kSharpness =
    -0.5F;  // Mipmap bias: a tilted title stays readable, a turning one doesn't shimmer.

void refuseOversize(image::ImageView picture) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (picture.width <= largest && picture.height <= largest) return;
  throw InputError("a texture of " + std::to_string(picture.width) + "x" +
                   std::to_string(picture.height) + " pixels is too large: this renderer takes " +
                   std::to_string(largest) + " a side");
}

// GL's first row is the lowest; ours is the highest.
std::vector<std::uint8_t> bottomUpBytes(image::ImageView picture) {
  const auto rowBytes = static_cast<std::size_t>(picture.width * bytesPerPixel(picture.format));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(rowBytes * static_cast<std::size_t>(picture.height));
  for (int y = picture.height - 1; y >= 0; --y) {
    bytes.insert(bytes.end(), picture.row(y), picture.row(y) + rowBytes);
  }
  return bytes;
}

void upload(int level, image::ImageView picture) {
  const GLenum format = picture.format == image::PixelFormat::Rgb8 ? GL_RGB : GL_RGBA;
  glTexImage2D(GL_TEXTURE_2D, level, GL_SRGB8_ALPHA8, picture.width, picture.height, 0, format,
               GL_UNSIGNED_BYTE, bottomUpBytes(picture).data());
}

void setFilters(TextureWrap wrap) {
  const GLint mode = wrap == TextureWrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, kSharpness);
}

}  // namespace

Texture::Texture(image::ImageView picture, TextureWrap wrap) {
  refuseOversize(picture);
  bind();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  upload(0, picture);
  // Made here: by the driver it takes a third of a render's start, and comes out as it pleases.
  image::Image level;
  for (int i = 1; picture.width > 1 || picture.height > 1; ++i) {
    level = image::halvedOpaque(picture);
    picture = level.view();
    upload(i, picture);
  }
  setFilters(wrap);
}

}  // namespace rotatebook::render
