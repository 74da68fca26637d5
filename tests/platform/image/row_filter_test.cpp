// A PNG's rows as the format's text has them.
#include "image/row_filter.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::image {
namespace {

/// Three columns and rows: of each pixel red, green and blue differ, and so do rows.
Image smallPicture(PixelFormat format) {
  Image picture(3, 3, format);
  const int channels = bytesPerPixel(format);
  for (int y = 0; y < 3; ++y) {
    for (int i = 0; i < 3 * channels; ++i) {
      const int x = i / channels, channel = i % channels;
      picture.row(y)[i] = static_cast<std::uint8_t>(10 * x + channel + (y == 0 ? 200 : 3 * y));
    }
  }
  return picture;
}

std::vector<std::uint8_t> filtered(const Image& picture, int y, bool alpha) {
  std::vector<std::uint8_t> out(filteredRowSize(picture.view(), alpha) + kFilterOverrun);
  const std::uint8_t* end = filterRow(picture.view(), y, alpha, out.data());
  out.resize(static_cast<std::size_t>(end - out.data()));
  return out;
}

using Row = std::vector<std::uint8_t>;

TEST(RowFilter, IsUp) {
  constexpr std::uint8_t kUp = 2;  // PNG specification, section 9.2.
  constexpr std::uint8_t kFall = static_cast<std::uint8_t>(3 - 200), kRise = 3;
  const Row first{kUp, 200, 201, 202, 210, 211, 212, 220, 221, 222};
  for (const PixelFormat format : {PixelFormat::Rgb8, PixelFormat::Rgba8}) {
    const Image picture = smallPicture(format);
    EXPECT_EQ(filtered(picture, 0, false), first);
    EXPECT_EQ(filtered(picture, 1, false),
              (Row{kUp, kFall, kFall, kFall, kFall, kFall, kFall, kFall, kFall, kFall}));
    EXPECT_EQ(filtered(picture, 2, false),
              (Row{kUp, kRise, kRise, kRise, kRise, kRise, kRise, kRise, kRise, kRise}));
  }
}

TEST(RowFilter, IsUpOfTheAlphaToo) {
  const Image picture = smallPicture(PixelFormat::Rgba8);
  EXPECT_EQ(filtered(picture, 0, true),
            (Row{2, 200, 201, 202, 203, 210, 211, 212, 213, 220, 221, 222, 223}));
  EXPECT_EQ(filtered(picture, 2, true), (Row{2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3}));
}

}  // namespace
}  // namespace rotatebook::image
