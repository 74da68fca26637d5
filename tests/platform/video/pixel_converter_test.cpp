#include "video/pixel_converter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/moving_picture.h"
#include "video/bt709.h"

namespace rotatebook::video {
namespace {

using image::Image;
using image::ImageView;
using image::PixelFormat;
using testing::Colour;
using testing::yuvFromRgb;

// Largest distance of a sample from the exact value; correct rounding alone gives 0.5.
constexpr double kFlatBound = 0.55;   // measured 0.508 over 5832 flat colours
constexpr double kNoiseBound = 0.55;  // measured 0.507 over filtered noise

std::uint8_t sampleAt(const AVFrame& frame, int plane, int x, int y) {
  return frame.data[plane][static_cast<std::ptrdiff_t>(y) * frame.linesize[plane] + x];
}

Image flatPicture(int width, int height, const Colour& rgb, PixelFormat format) {
  Image picture(width, height, format);
  const int step = image::bytesPerPixel(format);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        picture.row(y)[x * step + static_cast<int>(c)] = static_cast<std::uint8_t>(rgb[c]);
      }
    }
  }
  return picture;
}

Image noisePicture(int width, int height, PixelFormat format) {
  std::mt19937 generator(7);
  Image picture(width, height, format);
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < picture.stride(); ++i) {
      picture.row(y)[i] = static_cast<std::uint8_t>(generator());
    }
  }
  return picture;
}

// All samples of the frame, plane after plane.
std::string samplesOf(const AVFrame& frame) {
  std::string samples;
  for (int plane = 0; plane < 3; ++plane) {
    const int shrink = plane == 0 ? 1 : 2;
    for (int y = 0; y < frame.height / shrink; ++y) {
      for (int x = 0; x < frame.width / shrink; ++x) {
        samples += static_cast<char>(sampleAt(frame, plane, x, y));
      }
    }
  }
  return samples;
}

TEST(PixelConverter, IsExactForFlatColours) {
  PixelConverter converter(16, 16);
  double largest = 0;
  for (int red = 0; red < 256; red += 15) {
    for (int green = 0; green < 256; green += 15) {
      for (int blue = 0; blue < 256; blue += 15) {
        const Colour rgb = {double(red), double(green), double(blue)};
        const AVFrame& frame =
            converter.convert(flatPicture(16, 16, rgb, PixelFormat::Rgba8).view());
        const Colour exact = yuvFromRgb(rgb);
        largest = std::max({largest, std::abs(sampleAt(frame, 0, 9, 9) - exact[0]),
                            std::abs(sampleAt(frame, 1, 4, 4) - exact[1]),
                            std::abs(sampleAt(frame, 2, 4, 4) - exact[2])});
      }
    }
  }
  RecordProperty("largest", std::to_string(largest));
  EXPECT_LT(largest, kFlatBound);
}

TEST(PixelConverter, GivesPureRedTheLumaOfBt709) {
  PixelConverter converter(16, 16);
  const Image red = flatPicture(16, 16, {255, 0, 0}, PixelFormat::Rgba8);
  const AVFrame& frame = converter.convert(red.view());
  EXPECT_EQ(sampleAt(frame, 0, 8, 8), 63);  // 81 with the BT.601 matrix
  EXPECT_EQ(sampleAt(frame, 1, 4, 4), 102);
  EXPECT_EQ(sampleAt(frame, 2, 4, 4), 240);
}

// Colour at (x, y) of the half-size plane: sited left, so [1 2 1]/4 about column 2x, and between
// the rows 2y and 2y+1, [1 3 3 1]/8.
Colour filteredColour(const Image& picture, int x, int y) {
  constexpr std::array<double, 3> kAcross = {1 / 4.0, 2 / 4.0, 1 / 4.0};
  constexpr std::array<double, 4> kDown = {1 / 8.0, 3 / 8.0, 3 / 8.0, 1 / 8.0};
  Colour rgb = {0, 0, 0};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) {
      const std::uint8_t* pixel = picture.row(2 * y - 1 + row) + 4 * (2 * x - 1 + column);
      const double weight = kAcross[std::size_t(column)] * kDown[std::size_t(row)];
      for (std::size_t c = 0; c < 3; ++c) rgb[c] += weight * pixel[c];
    }
  }
  return yuvFromRgb(rgb);
}

TEST(PixelConverter, PutsColourWhereH264ExpectsIt) {
  const Image picture = noisePicture(64, 48, PixelFormat::Rgba8);
  PixelConverter converter(64, 48);
  const AVFrame& frame = converter.convert(picture.view());
  double largest = 0;
  for (int y = 1; y < 23; ++y) {
    for (int x = 1; x < 31; ++x) {
      const Colour exact = filteredColour(picture, x, y);
      largest = std::max({largest, std::abs(sampleAt(frame, 1, x, y) - exact[1]),
                          std::abs(sampleAt(frame, 2, x, y) - exact[2])});
    }
  }
  RecordProperty("largest", std::to_string(largest));
  EXPECT_LT(largest, kNoiseBound);
}

TEST(PixelConverter, TakesBottomUpRows) {
  const Image picture = noisePicture(32, 20, PixelFormat::Rgba8);
  Image turnedOver(32, 20, PixelFormat::Rgba8);
  for (int y = 0; y < 20; ++y) {
    std::copy_n(picture.row(y), picture.stride(), turnedOver.row(19 - y));
  }
  PixelConverter converter(32, 20);
  const std::string expected = samplesOf(converter.convert(picture.view()));
  const ImageView bottomUp{turnedOver.row(19), 32, 20, -picture.stride(), PixelFormat::Rgba8};
  EXPECT_EQ(samplesOf(converter.convert(bottomUp)), expected);
  EXPECT_NE(samplesOf(converter.convert(turnedOver.view())), expected);
}

Image withoutAlpha(const Image& rgba) {
  Image rgb(rgba.width(), rgba.height(), PixelFormat::Rgb8);
  for (int y = 0; y < rgba.height(); ++y) {
    for (int x = 0; x < rgba.width(); ++x) std::copy_n(rgba.row(y) + 4 * x, 3, rgb.row(y) + 3 * x);
  }
  return rgb;
}

TEST(PixelConverter, TakesBothFormatsInTurn) {
  const Image rgba = noisePicture(32, 20, PixelFormat::Rgba8);
  const Image rgb = withoutAlpha(rgba);
  PixelConverter converter(32, 20);
  const std::string expected = samplesOf(converter.convert(rgba.view()));
  EXPECT_EQ(samplesOf(converter.convert(rgb.view())), expected);
  EXPECT_EQ(samplesOf(converter.convert(rgba.view())), expected);
}

// Pictures without alpha are always swscale's.
TEST(PixelConverter, GivesSwscalesBytesByVectors) {
  for (int width = 16; width <= 84; width += 2) {
    for (const int height : {16, 18}) {
      const Image rgba = noisePicture(width, height, PixelFormat::Rgba8);
      PixelConverter converter(width, height);
      const std::string expected = samplesOf(converter.convert(withoutAlpha(rgba).view()));
      EXPECT_EQ(samplesOf(converter.convert(rgba.view())), expected) << width << "x" << height;
    }
  }
}

TEST(PixelConverter, MarksChangeNothing) {
  PixelConverter converter(200, 50);
  image::testing::MovingPicture moving(200, 50);
  for (const image::Area& patch : image::testing::kPatches) {
    const Image& picture = moving.with(patch);
    const std::string expected =
        samplesOf(PixelConverter(200, 50).convert(withoutAlpha(picture).view()));
    EXPECT_EQ(samplesOf(converter.convert(picture.view())), expected) << patch.x;
    if (patch.x != 64) continue;
    // One without marks in between
    const Image other = noisePicture(200, 50, PixelFormat::Rgb8);
    EXPECT_NE(samplesOf(converter.convert(other.view())), expected);
  }
}

// Memory between two pages that nobody may touch: whoever reads a byte too far crashes.
class FencedBytes {
 public:
  explicit FencedBytes(std::size_t size)
      : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
        inner_((size + page_ - 1) / page_ * page_),
        memory_(static_cast<std::uint8_t*>(
            mmap(nullptr, inner_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))),
        bytes_(memory_ + page_ + inner_ - size) {
    mprotect(memory_ + page_, inner_, PROT_READ | PROT_WRITE);
  }
  FencedBytes(const FencedBytes&) = delete;
  FencedBytes& operator=(const FencedBytes&) = delete;
  ~FencedBytes() { munmap(memory_, inner_ + 2 * page_); }

  std::uint8_t* bytes() { return bytes_; }

 private:
  std::size_t page_;
  std::size_t inner_;
  std::uint8_t* memory_;
  std::uint8_t* bytes_;
};

void convertFenced(int width, int height, PixelFormat format, bool transparent = false) {
  const std::ptrdiff_t stride = std::ptrdiff_t{width} * image::bytesPerPixel(format);
  FencedBytes memory(static_cast<std::size_t>(stride * height));
  PixelConverter converter(width, height, transparent);
  converter.convert({memory.bytes(), width, height, stride, format});
  converter.convert({memory.bytes() + stride * (height - 1), width, height, -stride, format});
}

TEST(PixelConverter, ReadsNoByteBeyondThePicture) {
  for (int width = 16; width <= 132; width += 2) {
    convertFenced(width, 16, PixelFormat::Rgb8);
    convertFenced(width, 16, PixelFormat::Rgba8);
    convertFenced(width, 16, PixelFormat::Rgba8, true);
  }
}

TEST(PixelConverter, TagsTheFrame) {
  PixelConverter converter(16, 16);
  const AVFrame& frame = converter.convert(Image(16, 16, PixelFormat::Rgb8).view());
  EXPECT_EQ(frame.format, AV_PIX_FMT_YUV420P);
  EXPECT_EQ(frame.color_primaries, AVCOL_PRI_BT709);
  EXPECT_EQ(frame.color_trc, AVCOL_TRC_BT709);
  EXPECT_EQ(frame.colorspace, AVCOL_SPC_BT709);
  EXPECT_EQ(frame.color_range, AVCOL_RANGE_MPEG);
  EXPECT_EQ(frame.chroma_location, AVCHROMA_LOC_LEFT);
}

TEST(PixelConverter, RefusesAnotherSize) {
  PixelConverter converter(32, 20);
  try {
    converter.convert(Image(20, 32, PixelFormat::Rgba8).view());
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "can't encode a picture of 20x32: the video is 32x20");
  }
}

}  // namespace
}  // namespace rotatebook::video
