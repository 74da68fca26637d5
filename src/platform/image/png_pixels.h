// The content of a PNG's IDAT chunk. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "image/band_coder.h"
#include "image/image.h"

namespace rotatebook::image {

void appendBigEndian(std::string& bytes, std::uint32_t value);

/// Packs pictures into zlib streams. Successive pictures are alike: a band of rows that equals the
/// last picture's isn't packed again. The bytes depend on the picture alone.
///
/// Uses the filter Sub alone, which leaves most of the background zero: it varies slowly, and its
/// dither from row to row alone. The filter Up took half as many bytes more.
class PixelPacker {
 public:
  /// Appends the picture as RGB, or if `alpha` as RGBA (`view` must be Rgba8), each row preceded by
  /// its filter's number and stored as the differences to the left.
  void append(const ImageView& view, bool alpha, std::string& stream);

 private:
  struct Band {
    std::vector<std::uint8_t> filtered;
    std::vector<std::uint8_t> packed;  ///< Empty if it isn't `filtered`'s.
    std::uint32_t checksum = 0;        ///< Of `filtered`.
  };

  void packBands(const ImageView& view, bool alpha);
  /// Filters rows `top` to `bottom` - 1 into filtered_.
  void filterRows(const ImageView& view, bool alpha, int top, int bottom);
  void appendBands(std::string& stream) const;

  BandCoder coder_;
  std::vector<std::uint8_t> filtered_;
  std::vector<Band> bands_;  // The last picture's.
};

}  // namespace rotatebook::image
