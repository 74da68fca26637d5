// The pixels of a PNG as its IDAT chunk has them. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "image/band_coder.h"
#include "image/image.h"

namespace rotatebook::image {

void appendBigEndian(std::string& bytes, std::uint32_t value);

/// Packs pictures into zlib streams. Pictures that follow each other are alike: a band of rows that
/// is the last picture's is taken as it was packed then. The bytes depend on the picture alone.
///
/// Of the filters Up alone is used, which leaves most of the background zero.
class PixelPacker {
 public:
  /// Appends the picture as RGB, or if `alpha` as RGBA, which it is then, each row preceded by its
  /// filter's number and stored as the difference to the row above.
  void append(const ImageView& view, bool alpha, std::string& stream);

 private:
  struct Band {
    std::vector<std::uint8_t> packed;
    std::size_t size = 0;  ///< Before it was packed. [bytes]
    std::uint32_t checksum = 0;
  };

  void packBands(const ImageView& view, bool alpha);
  void prepareFor(const ImageView& view, bool alpha);
  bool keepRow(const ImageView& view, int y);
  /// Filters rows from `top` until before `bottom` into filtered_; returns their size.
  std::size_t filterRows(const ImageView& view, bool alpha, int top, int bottom);
  void appendBands(std::string& stream) const;

  BandCoder coder_;
  std::vector<std::uint8_t> filtered_;
  std::vector<Band> bands_;
  /// The picture that the bands hold, if they hold one, and whether its alpha was kept.
  Image last_;
  bool lastHadAlpha_ = false;
  bool lastIsWhole_ = false;
};

}  // namespace rotatebook::image
