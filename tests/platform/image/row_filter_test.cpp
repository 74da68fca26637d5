// A PNG's rows as the format's text has them.
#include "image/row_filter.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::image {
namespace {

/// Four columns and two rows, which differ, as red, green and blue do: the first column is stored
/// as it is, the next two at a time, the last by itself.
Image smallPicture(PixelFormat format) {
  constexpr std::uint8_t kColumns[] = {200, 3, 6, 16};
  Image picture(4, 2, format);
  const int channels = bytesPerPixel(format);
  for (int y = 0; y < 2; ++y) {
    for (int i = 0; i < 4 * channels; ++i) {
      const int channel = i % channels;
      picture.row(y)[i] = static_cast<std::uint8_t>(kColumns[i / channels] + channel + 20 * y);
    }
  }
  return picture;
}

std::vector<std::uint8_t> filtered(const Image& picture, int y, bool alpha, int left = 0) {
  const int count = picture.width() - left;
  const auto size = static_cast<std::size_t>(count * (alpha ? 4 : 3));
  std::vector<std::uint8_t> out(size + kFilterOverrun);
  filterPixels(picture.view(), y, left, count, alpha, out.data());
  out.resize(size);
  return out;
}

using Row = std::vector<std::uint8_t>;

constexpr std::uint8_t kFall = static_cast<std::uint8_t>(3 - 200);

TEST(RowFilter, IsSub) {
  for (const PixelFormat format : {PixelFormat::Rgb8, PixelFormat::Rgba8}) {
    const Image picture = smallPicture(format);
    EXPECT_EQ(filtered(picture, 0, false),
              (Row{200, 201, 202, kFall, kFall, kFall, 3, 3, 3, 10, 10, 10}));
    EXPECT_EQ(filtered(picture, 1, false),
              (Row{220, 221, 222, kFall, kFall, kFall, 3, 3, 3, 10, 10, 10}));
    EXPECT_EQ(filtered(picture, 1, false, 2), (Row{3, 3, 3, 10, 10, 10}));
  }
}

TEST(RowFilter, IsSubOfTheAlphaToo) {
  const Image picture = smallPicture(PixelFormat::Rgba8);
  EXPECT_EQ(filtered(picture, 1, true),
            (Row{220, 221, 222, 223, kFall, kFall, kFall, kFall, 3, 3, 3, 3, 10, 10, 10, 10}));
}

}  // namespace
}  // namespace rotatebook::image
