// Pictures as values: 8-bit sRGB, top-left origin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "image/area.h"
#include "image/tiles.h"
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
  /// Marks of the picture's tiles, row by row; null if it has none. Pictures of one size and format
  /// show the same in a tile where they have the same mark, unless it is 0.
  const std::uint64_t* marks = nullptr;

  const std::uint8_t* row(int y) const { return topRow + y * stride; }
};

/// Pixels that somebody else owns, from one of them on to the right and downward.
struct Pixels {
  std::uint8_t* topRow = nullptr;
  std::ptrdiff_t stride = 0;  ///< Distance from a row to the one below. [bytes]

  std::uint8_t* row(int y) const { return topRow + y * stride; }
};

/// A picture that owns its memory: rows from the top, without padding.
///
/// Pictures of a clip are alike for the most part. One that is drawn between beginOn() and settle()
/// gets marks for its tiles (see ImageView), so that whoever takes one picture after the other can
/// leave out what stays the same. While it is drawn, whoever writes to it calls touch() first.
class Image {
 public:
  Image() = default;
  /// Makes a black picture, transparent if it has alpha. `width`, `height` > 0. [pixels]
  Image(int width, int height, PixelFormat format);

  int width() const { return width_; }
  int height() const { return height_; }
  PixelFormat format() const { return format_; }
  /// Of a picture that is there, settle()d or not, this takes the marks: anything may be written.
  std::uint8_t* row(int y) {
    if (!marks_.empty() && ground_ == nullptr) marks_.clear();
    return bytes_.data() + y * stride();
  }
  const std::uint8_t* row(int y) const { return bytes_.data() + y * stride(); }
  std::ptrdiff_t stride() const {
    return static_cast<std::ptrdiff_t>(width_) * bytesPerPixel(format_);
  }
  /// Returns all pixels, row by row.
  std::string_view bytes() const {
    return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()};
  }
  ImageView view() const {
    return {bytes_.data(), width_,  height_,
            stride(),      format_, marks_.empty() ? nullptr : marks_.data()};
  }
  Area area() const { return {0, 0, width_, height_}; }
  /// Returns the pixels from (x, y) on. touch() them before they are written.
  Pixels from(int x, int y) {
    return {bytes_.data() + y * stride() + static_cast<std::ptrdiff_t>(x) * bytesPerPixel(format_),
            stride()};
  }

  /// Begins to draw the picture anew over `ground`, to be there until settle(): from now on touch()
  /// copies it to the tiles that it touches. The picture becomes of its size and format.
  void beginOn(const Image& ground);
  /// Replaces the ground by one that shows the same where nothing was touched, and more above it.
  void goOnOver(const Image& ground) { ground_ = &ground; }
  /// Says that an area, which may be partly outside, is about to be drawn over.
  void touch(const Area& area);
  /// Lets all tiles that weren't touched since beginOn() show what `rest` does, which has marks.
  void settle(const Image& rest);
  /// Gives each tile a mark that no other has.
  void mark();
  /// Calls each(Area) for tiles that were touched since beginOn() and meet `area`; those beside
  /// each other are one. In a picture without marks all were.
  template <typename Each>
  void forEachTouched(const Area& area, const Each& each) const {
    Tiles(width_, height_)
        .forEachRun(
            area, [this](std::size_t tile) { return marks_.empty() || marks_[tile] == own_; },
            each);
  }

  /// Returns whether both show the same.
  friend bool operator==(const Image& one, const Image& other) {
    return one.width_ == other.width_ && one.height_ == other.height_ &&
           one.format_ == other.format_ && one.bytes_ == other.bytes_;
  }

 private:
  void copyTile(const Image& from, const Area& tile);

  int width_ = 0;
  int height_ = 0;
  PixelFormat format_ = PixelFormat::Rgba8;
  ZeroedBytes bytes_;
  std::vector<std::uint64_t> marks_;  // Of each tile, or of none.
  std::uint64_t own_ = 0;             // The mark of tiles that were touched since beginOn().
  const Image* ground_ = nullptr;     // From beginOn() to settle().
};

/// Copies `piece` into `picture`, which has the same format, with its top left pixel at (x, y). It
/// must lie inside. [pixels]
void paste(const ImageView& piece, int x, int y, Image& picture);

}  // namespace rotatebook::image
