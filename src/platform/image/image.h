// Pictures as values: 8-bit sRGB, top-left origin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "image/zeroed_memory.h"

namespace rotatebook::image {

/// Order of the bytes of a pixel; sRGB-encoded, straight alpha.
enum class PixelFormat { Rgb8, Rgba8 };

/// Returns the number of bytes a pixel: 3 or 4.
constexpr int bytesPerPixel(PixelFormat format) {
  return format == PixelFormat::Rgb8 ? 3 : 4;
}

/// A picture that somebody else owns. A negative stride means rows stored bottom-up, as GL reads
/// them back.
struct ImageView {
  const std::uint8_t* topRow = nullptr;  ///< First byte of the top left pixel.
  int width = 0;                         ///< [pixels]
  int height = 0;                        ///< [pixels]
  std::ptrdiff_t stride = 0;             ///< Distance from a row to the one below. [bytes]
  PixelFormat format = PixelFormat::Rgba8;

  const std::uint8_t* row(int y) const { return topRow + y * stride; }
};

/// A picture that owns its memory: rows from the top, without padding.
class Image {
 public:
  Image() = default;
  /// Makes a black picture, transparent if it has alpha. `width`, `height` > 0. [pixels]
  Image(int width, int height, PixelFormat format);

  int width() const { return width_; }
  int height() const { return height_; }
  PixelFormat format() const { return format_; }
  std::uint8_t* row(int y) { return bytes_.data() + y * stride(); }
  const std::uint8_t* row(int y) const { return bytes_.data() + y * stride(); }
  std::ptrdiff_t stride() const {
    return static_cast<std::ptrdiff_t>(width_) * bytesPerPixel(format_);
  }
  /// Returns all pixels, row by row.
  std::string_view bytes() const {
    return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()};
  }
  ImageView view() const { return {bytes_.data(), width_, height_, stride(), format_}; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  int width_ = 0;
  int height_ = 0;
  PixelFormat format_ = PixelFormat::Rgba8;
  ZeroedBytes bytes_;
};

/// Copies `piece` into `picture`, which has the same format, with its top left pixel at (x, y). It
/// must lie inside. [pixels]
void paste(const ImageView& piece, int x, int y, Image& picture);

}  // namespace rotatebook::image
