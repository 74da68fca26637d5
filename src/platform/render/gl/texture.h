// Uploads pictures as OpenGL textures. Inside the room only.
#pragma once

#include "body/surface.h"
#include "image/image.h"
#include "render/gl/gl_handles.h"

namespace rotatebook::render {

inline constexpr body::Sampling kRepeated{};
inline constexpr body::Sampling kClamped{body::Wrap::Clamp, body::Wrap::Clamp};

/// The meaning of a texture's values.
enum class TextureContent {
  Colour,           ///< sRGB.
  ColourAndNumber,  ///< Likewise, and a share of 255 as alpha, which others have as 1. Rgba8 alone.
  Numbers,          ///< Shares of 255.
};

/// A mipmapped texture, trilinearly filtered unless it has squares; its first row is at v = 1.
class Texture {
 public:
  /// Throws InputError if the picture is larger than the driver's limit.
  Texture(image::ImageView picture, const body::Sampling& sampling,
          TextureContent content = TextureContent::Colour);

  void bind() const { glBindTexture(GL_TEXTURE_2D, texture_.name()); }

 private:
  GlTexture texture_;
};

}  // namespace rotatebook::render
