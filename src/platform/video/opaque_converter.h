// Converts opaque pictures to YUV faster than swscale. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/area.h"
#include "image/image.h"
#include "video/ffmpeg.h"

namespace rotatebook::video {

/// Converts sRGB pictures of one size to yuv420p, with every bit as PixelConverter's swscale does,
/// in a fifth of its time. Only where image::usesAvx2().
class OpaqueConverter {
 public:
  /// Converts pictures of even `width`, at least kSmallestSide. [pixels]
  explicit OpaqueConverter(int width);

  /// Replaces the samples of `frame`, yuv420p of the size of `picture`, which is Rgba8 of even
  /// height; its alpha is dropped. Leaves those out of tiles with the marks of the last picture:
  /// `frame` must hold that unless forget() was called.
  void convert(const image::ImageView& picture, AVFrame& frame);
  /// Lets convert() replace all samples the next time.
  void forget() { marks_.clear(); }

 private:
  static constexpr std::size_t kRows = 4;  // That are mixed for a row of colour.

  std::int16_t* halved(int row, std::size_t colour);
  void convertArea(const image::ImageView& picture, image::Area area, AVFrame& frame);
  /// Converts those of a row's pixels that a part of `area` needs.
  void convertRow(const image::ImageView& picture, int row, const image::Area& area,
                  AVFrame& frame);
  void mixRows(int row, int height, const image::Area& area, AVFrame& frame);

  std::size_t size_;                   // Of a row of samples, with room after it.
  std::vector<std::int16_t> colours_;  // Of a row of pixels: both, with one sample before each.
  std::vector<std::int16_t> halved_;   // Of the last kRows rows of pixels: both.
  std::vector<std::uint64_t> marks_;   // Of the last picture's tiles; none if it had none.
};

}  // namespace rotatebook::video
