#include "render/gl/texture.h"

#include <cstddef>
#include <cstring>
#include <string>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "image/downsample.h"

namespace rotatebook::render {
namespace {

// Mipmap level bias: a tilted title stays readable, and a turning one doesn't shimmer.
constexpr float kSharpness = -0.5F;

void refuseOversize(image::ImageView picture) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (picture.width <= largest && picture.height <= largest) return;
  throw InputError(
      fmt::format("a texture of {} pixels is too large: this renderer takes up to {} a side",
                  sizeText(picture.width, picture.height), largest));
}

// OpenGL's first row is the lowest; ours is the highest.
image::Image flippedVertically(image::ImageView picture) {
  image::Image flipped(picture.width, picture.height, picture.format);
  for (int y = 0; y < picture.height; ++y) {
    std::memcpy(flipped.row(picture.height - 1 - y), picture.row(y),
                static_cast<std::size_t>(flipped.stride()));
  }
  return flipped;
}

GLint insideOf(TextureContent content) {
  if (content == TextureContent::ColourAndNumber) return GL_SRGB8_ALPHA8;
  return content == TextureContent::Colour ? GL_SRGB8 : GL_RGB8;
}

void upload(int level, const image::Image& picture, TextureContent content) {
  const GLint inside = insideOf(content);
  const GLenum format = picture.format() == image::PixelFormat::Rgb8 ? GL_RGB : GL_RGBA;
  glTexImage2D(GL_TEXTURE_2D, level, inside, picture.width(), picture.height(), 0, format,
               GL_UNSIGNED_BYTE, picture.row(0));
}

GLint modeOf(body::Wrap wrap) {
  switch (wrap) {
    case body::Wrap::Mirror:
      return GL_MIRRORED_REPEAT;
    case body::Wrap::Clamp:
      return GL_CLAMP_TO_EDGE;
    case body::Wrap::Repeat:
      break;
  }
  return GL_REPEAT;
}

void setFilters(const body::Sampling& sampling) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, modeOf(sampling.across));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, modeOf(sampling.down));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                  sampling.hasSquares ? GL_NEAREST : GL_LINEAR);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, kSharpness);
}

}  // namespace

Texture::Texture(image::ImageView picture, const body::Sampling& sampling, TextureContent content) {
  refuseOversize(picture);
  bind();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  image::Image level = flippedVertically(picture);
  upload(0, level, content);
  // Compute the mipmaps here: by the driver they take a third of a render's start, and differ
  // between drivers
  for (int i = 1; level.width() > 1 || level.height() > 1; ++i) {
    level = content == TextureContent::ColourAndNumber ? image::downsampledApart(level.view())
                                                       : image::downsampledOpaque(level.view());
    upload(i, level, content);
  }
  setFilters(sampling);
}

}  // namespace rotatebook::render
