#include "image/comparison.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::image {
namespace {

constexpr int kColours = 3;

void requireEqualSizes(ImageView a, ImageView b) {
  if (a.width == b.width && a.height == b.height) return;
  throw InputError(fmt::format("can't compare pictures of different sizes: {} and {}",
                               sizeText(a.width, a.height), sizeText(b.width, b.height)));
}

// Calls visit(x, y, differences of red, green and blue) for each pixel.
template <typename Visit>
void forEachPixel(ImageView a, ImageView b, Visit visit) {
  const int stepA = bytesPerPixel(a.format);
  const int stepB = bytesPerPixel(b.format);
  for (int y = 0; y < a.height; ++y) {
    const std::uint8_t* pixelA = a.row(y);
    const std::uint8_t* pixelB = b.row(y);
    for (int x = 0; x < a.width; ++x, pixelA += stepA, pixelB += stepB) {
      visit(x, y, std::abs(pixelA[0] - pixelB[0]), std::abs(pixelA[1] - pixelB[1]),
            std::abs(pixelA[2] - pixelB[2]));
    }
  }
}

}  // namespace

Comparison compare(ImageView a, ImageView b, Tolerance tolerance) {
  requireEqualSizes(a, b);
  Comparison result;
  std::int64_t sum = 0;
  forEachPixel(a, b, [&](int, int, int red, int green, int blue) {
    const int largest = std::max({red, green, blue});
    result.largest = std::max(result.largest, largest);
    result.differingPixels += largest > tolerance.largest ? 1 : 0;
    sum += red + green + blue;
  });
  const double pixels = static_cast<double>(a.width) * a.height;
  if (pixels == 0) return result;
  result.mean = static_cast<double>(sum) / (kColours * pixels);
  result.differingPercent = 100 * static_cast<double>(result.differingPixels) / pixels;
  result.same = result.differingPercent <= tolerance.failPercent;
  return result;
}

Image differenceImage(ImageView a, ImageView b, int gain) {
  requireEqualSizes(a, b);
  Image picture(a.width, a.height, PixelFormat::Rgb8);
  const auto amplified = [gain](int difference) {
    return static_cast<std::uint8_t>(std::clamp(difference * gain, 0, 255));
  };
  forEachPixel(a, b, [&](int x, int y, int red, int green, int blue) {
    std::uint8_t* pixel = picture.row(y) + static_cast<std::ptrdiff_t>(kColours) * x;
    pixel[0] = amplified(red);
    pixel[1] = amplified(green);
    pixel[2] = amplified(blue);
  });
  return picture;
}

}  // namespace rotatebook::image
