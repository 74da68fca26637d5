// BT.709 as its text has it, in doubles: what the converter and the decoded videos are measured
// against.
#pragma once

#include <array>

namespace rotatebook::video::testing {

/// A colour: red, green, blue, 0 to 255; or Y, U, V, limited range of 8 bits. Not rounded.
using Colour = std::array<double, 3>;

/// Weights of red and blue in luma.
struct Matrix {
  double red;
  double blue;
};

inline constexpr Matrix kBt709 = {0.2126, 0.0722};
inline constexpr Matrix kBt601 = {0.299, 0.114};

/// Limited range: luma 16 to 235, colour 16 to 240 about 128.
inline Colour yuvFromRgb(const Colour& rgb, Matrix matrix = kBt709) {
  const double luma =
      matrix.red * rgb[0] + (1 - matrix.red - matrix.blue) * rgb[1] + matrix.blue * rgb[2];
  return {16 + luma * 219 / 255, 128 + (rgb[2] - luma) / (2 - 2 * matrix.blue) * 224 / 255,
          128 + (rgb[0] - luma) / (2 - 2 * matrix.red) * 224 / 255};
}

inline Colour rgbFromYuv(const Colour& yuv, Matrix matrix = kBt709) {
  const double luma = (yuv[0] - 16) * 255 / 219;
  const double red = luma + (yuv[2] - 128) * 255 / 224 * (2 - 2 * matrix.red);
  const double blue = luma + (yuv[1] - 128) * 255 / 224 * (2 - 2 * matrix.blue);
  const double green =
      (luma - matrix.red * red - matrix.blue * blue) / (1 - matrix.red - matrix.blue);
  return {red, green, blue};
}

}  // namespace rotatebook::video::testing
