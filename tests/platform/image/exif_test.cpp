#include "image/exif.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "image/picture_bytes.h"

namespace rotatebook::image {
namespace testing {

Bytes exifOf(const std::string& byteOrder, int tag, int type, int value) {
  Bytes tiff;
  const auto add = [&](std::size_t number, int size) {
    for (int i = 0; i < size; ++i) {
      const int shift = 8 * (byteOrder == "MM" ? size - 1 - i : i);
      tiff.push_back(static_cast<std::uint8_t>(number >> shift));
    }
  };
  tiff.assign(byteOrder.begin(), byteOrder.end());
  add(42, 2);
  add(8, 4);  // where the directory begins
  add(1, 2);  // one entry
  add(static_cast<std::size_t>(tag), 2);
  add(static_cast<std::size_t>(type), 2);
  add(1, 4);  // one value
  add(static_cast<std::size_t>(value), 2);
  add(0, 2);
  add(0, 4);
  return tiff;
}

}  // namespace testing

namespace {

using testing::Bytes;
using testing::exifOf;
using testing::pixelsOf;

constexpr int kOrientation = 0x0112, kShort = 3;

TEST(Exif, StatesAnOrientationInBothByteOrders) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (const char* order : {"II", "MM"}) {
      const Bytes tiff = exifOf(order, kOrientation, kShort, orientation);
      EXPECT_EQ(orientationOf(tiff), orientation) << order;
      EXPECT_EQ(orientationOf(testing::joined({{'E', 'x', 'i', 'f', 0, 0}, tiff})), orientation);
    }
  }
}

TEST(Exif, ThatIsDamagedOrSaysNothingLeavesThePictureUpright) {
  for (const int value : {0, 9, 255, 0x0600}) {
    EXPECT_EQ(orientationOf(exifOf("II", kOrientation, kShort, value)), 1) << value;
  }
  EXPECT_EQ(orientationOf(exifOf("II", 0x0110, kShort, 6)), 1);
  EXPECT_EQ(orientationOf(exifOf("II", kOrientation, 4, 6)), 1);
  const Bytes whole = exifOf("MM", kOrientation, kShort, 6);
  for (std::size_t size = 0; size < 20; ++size) {
    EXPECT_EQ(orientationOf(Bytes(whole.begin(), whole.begin() + static_cast<long>(size))), 1);
  }
}

// Every bit of it, and offsets of gigabytes.
TEST(Exif, OfAnyBytesIsAnOrientation) {
  const Bytes whole = exifOf("II", kOrientation, kShort, 6);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    Bytes changed = whole;
    changed[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    const int orientation = orientationOf(changed);
    EXPECT_TRUE(orientation >= 1 && orientation <= 8) << bit;
  }
  EXPECT_EQ(orientationOf(Bytes{'I', 'I', 42, 0, 255, 255, 255, 255}), 1);
  Bytes many = whole;
  many[8] = many[9] = 255;
  many[10] = 0;
  EXPECT_EQ(orientationOf(many), 1);
}

/// A picture of 3x2 whose pixels have the values 1 to 6, each row after the other.
Image numbered() {
  Image picture(3, 2, PixelFormat::Rgb8);
  for (std::uint8_t i = 0; i < 6; ++i) std::fill_n(picture.row(i / 3) + i % 3 * 3, 3, i + 1);
  return picture;
}

// By the format's text: where the stored first row and first column are seen.
TEST(Exif, OrientationsTurnAndMirror) {
  const std::vector<std::vector<int>> expected{
      {1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1}, {4, 5, 6, 1, 2, 3},
      {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3}, {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const Image picture = upright(numbered(), orientation);
    EXPECT_EQ(picture.width(), orientation < 5 ? 3 : 2);
    EXPECT_EQ(picture.height(), orientation < 5 ? 2 : 3);
    const Bytes pixels = pixelsOf(picture);
    std::vector<int> seen;
    for (std::size_t i = 0; i < pixels.size(); i += 3) seen.push_back(pixels[i + 2]);
    EXPECT_EQ(seen, expected[static_cast<std::size_t>(orientation - 1)]) << orientation;
  }
}

}  // namespace
}  // namespace rotatebook::image
