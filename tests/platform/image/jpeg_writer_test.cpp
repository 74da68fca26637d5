#include "image/jpeg_writer.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/picture_file.h"

namespace rotatebook::image {
namespace {

Image gradient(PixelFormat format) {
  Image picture(37, 21, format);
  const int channels = bytesPerPixel(format);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      std::uint8_t* pixel = picture.row(y) + x * channels;
      pixel[0] = static_cast<std::uint8_t>(6 * x);
      pixel[1] = static_cast<std::uint8_t>(100 + 3 * y);
      pixel[2] = static_cast<std::uint8_t>(200 - 2 * x);
      if (channels == 4) pixel[3] = static_cast<std::uint8_t>(x);
    }
  }
  return picture;
}

TEST(JpegWriter, KeepsPicturesButForItsLosses) {
  for (const PixelFormat format : {PixelFormat::Rgb8, PixelFormat::Rgba8}) {
    const Image picture = gradient(format);
    const std::string file = jpegText(picture.view(), 95);
    EXPECT_EQ(file, jpegText(picture.view(), 95));
    const Image read =
        decodePicture({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, "a.jpg");
    ASSERT_EQ(read.width(), picture.width());
    ASSERT_EQ(read.height(), picture.height());
    ASSERT_EQ(read.format(), PixelFormat::Rgb8);
    int largest = 0;
    for (int y = 0; y < read.height(); ++y) {
      for (int i = 0; i < 3 * read.width(); ++i) {
        const int original = picture.row(y)[i / 3 * bytesPerPixel(format) + i % 3];
        largest = std::max(largest, std::abs(read.row(y)[i] - original));
      }
    }
    EXPECT_LE(largest, 6);  // measured 5
    EXPECT_LT(jpegText(picture.view(), 50).size(), file.size());
  }
}

}  // namespace
}  // namespace rotatebook::image
