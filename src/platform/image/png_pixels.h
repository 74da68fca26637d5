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

/// Packs pictures into zlib streams. Successive pictures are alike: tiles with the marks of the
/// last picture's aren't filtered again, a band of rows that equals its isn't packed again. The
/// bytes depend on the picture alone.
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
  /// Filters the tiles of a band, which takes `area`, whose marks aren't the `known` ones; returns
  /// whether its bytes have changed.
  bool filterBand(const ImageView& view, bool alpha, const Area& area,
                  const std::vector<std::uint64_t>& known, Band& band);
  /// Likewise all pixels of `area` in the band from row `top` on.
  bool filterArea(const ImageView& view, bool alpha, const Area& area, int top, Band& band);
  void appendBands(std::string& stream) const;

  BandCoder coder_;
  std::vector<std::uint8_t> row_;     // Of an area, filtered.
  std::vector<Band> bands_;           // The last picture's.
  std::vector<std::uint64_t> marks_;  // Of the last picture; none if it had none.
};

}  // namespace rotatebook::image
