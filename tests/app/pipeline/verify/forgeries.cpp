#include "pipeline/verify/forgeries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace rotatebook::pipeline::testing {
namespace {

using Rgb = std::array<double, 3>;

/// Replaces each pixel's colour by what `change` makes of it at (x, y).
template <typename Change>
void changePixels(image::Image& picture, const Change& change) {
  const auto step = bytesPerPixel(picture.view().format);
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* pixel = picture.row(y);
    for (int x = 0; x < picture.width(); ++x, pixel += step) {
      const Rgb changed = change(Rgb{1.0 * pixel[0], 1.0 * pixel[1], 1.0 * pixel[2]}, x, y);
      for (std::size_t i = 0; i < 3; ++i) {
        pixel[i] = static_cast<std::uint8_t>(std::clamp(std::lround(changed[i]), 0L, 255L));
      }
    }
  }
}

PictureForgery brighter(int percent) {
  return {"brightness + " + std::to_string(percent) + " %", [percent](image::Image& picture) {
            changePixels(picture, [&](Rgb rgb, int, int) {
              for (double& value : rgb) value *= 1 + 0.01 * percent;
              return rgb;
            });
          }};
}

/// Turns the chroma of BT.709 by `degrees` and scales it.
void changeChroma(image::Image& picture, double degrees, double saturation) {
  constexpr double kRed = 0.2126, kBlue = 0.0722;
  const double angle = degrees * std::numbers::pi / 180;
  const double c = saturation * std::cos(angle), s = saturation * std::sin(angle);
  changePixels(picture, [&](const Rgb& rgb, int, int) {
    const double luma = kRed * rgb[0] + (1 - kRed - kBlue) * rgb[1] + kBlue * rgb[2];
    const double u = (rgb[2] - luma) / (2 - 2 * kBlue), v = (rgb[0] - luma) / (2 - 2 * kRed);
    const double red = luma + (2 - 2 * kRed) * (s * u + c * v);
    const double blue = luma + (2 - 2 * kBlue) * (c * u - s * v);
    return Rgb{red, (luma - kRed * red - kBlue * blue) / (1 - kRed - kBlue), blue};
  });
}

PictureForgery turnedHue(int degrees) {
  return {"hue turned by " + std::to_string(degrees) + "°",
          [degrees](image::Image& picture) { changeChroma(picture, degrees, 1); }};
}

PictureForgery saturated(int percent) {
  return {"saturation " + std::to_string(percent) + " %",
          [percent](image::Image& picture) { changeChroma(picture, 0, 0.01 * percent); }};
}

void moveAside(image::Image& picture) {
  const auto step = bytesPerPixel(picture.view().format);
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* row = picture.row(y);
    const auto bytes = static_cast<std::ptrdiff_t>(step) * picture.width();
    std::copy_backward(row, row + bytes - step, row + bytes);
  }
}

/// Writes "FORGED" across the middle third, in letters of 5x7 cells.
void writeForged(image::Image& picture, double white) {
  constexpr std::array<std::array<std::string_view, 7>, 6> kLetters{{
      {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#    "},
      {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "},
      {"#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"},
      {" ### ", "#   #", "#    ", "# ###", "#   #", "#   #", " ### "},
      {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"},
      {"#### ", "#   #", "#   #", "#   #", "#   #", "#   #", "#### "},
  }};
  constexpr int kCells = 36;  // With a free column after each letter.
  const double cell = picture.width() / (3.0 * kCells);
  changePixels(picture, [&](Rgb rgb, int x, int y) {
    const auto column = static_cast<int>(std::floor((x - picture.width() / 3.0) / cell));
    const auto row = static_cast<int>(std::floor((y - picture.height() / 2.0) / cell + 3.5));
    if (column < 0 || column >= kCells || column % 6 == 5 || row < 0 || row >= 7) return rgb;
    const auto& letter = kLetters[static_cast<std::size_t>(column / 6)];
    if (letter[static_cast<std::size_t>(row)][static_cast<std::size_t>(column % 6)] != '#') {
      return rgb;
    }
    for (double& value : rgb) value += white * (255 - value);
    return rgb;
  });
}

PictureForgery lettered(int percent) {
  return {"\"FORGED\", " + std::to_string(percent) + " % white",
          [percent](image::Image& picture) { writeForged(picture, 0.01 * percent); }};
}

PictureForgery dotted(int side) {
  return {"a red square of " + std::to_string(side) + "x" + std::to_string(side) + " pixels",
          [side](image::Image& picture) {
            const int left = picture.width() / 3, top = picture.height() / 3;
            changePixels(picture, [&](const Rgb& rgb, int x, int y) {
              const bool inside = x >= left && x < left + side && y >= top && y < top + side;
              return inside ? Rgb{255, 0, 0} : rgb;
            });
          }};
}

void shadeCorners(image::Image& picture) {
  changePixels(picture, [&](Rgb rgb, int x, int y) {
    const double across = 2.0 * x / picture.width() - 1, down = 2.0 * y / picture.height() - 1;
    for (double& value : rgb) value *= 1 - 0.05 * (across * across + down * down) / 2;
    return rgb;
  });
}

}  // namespace

std::vector<PictureForgery> forgeries() {
  return {brighter(1),
          brighter(2),
          brighter(4),
          turnedHue(1),
          turnedHue(2),
          turnedHue(5),
          saturated(98),
          saturated(95),
          saturated(80),
          {"one pixel aside", moveAside},
          lettered(2),
          lettered(3),
          lettered(6),
          dotted(1),
          dotted(2),
          dotted(4),
          {"corners 5 % darker", shadeCorners}};
}

}  // namespace rotatebook::pipeline::testing
