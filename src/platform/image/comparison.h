// Comparison of two pictures.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace rotatebook::image {

/// Two thresholds, because single edge pixels jump between rasterisers: a few large differences may
/// pass.
struct Tolerance {
  int largest = 0;         ///< A pixel differs if a channel differs by more than this. [0 to 255]
  double failPercent = 0;  ///< Pictures differ if more than this share of the pixels does. [%]
};

/// The differences between two pictures of equal size; alpha is not compared.
struct Comparison {
  int largest = 0;                   ///< Largest difference in any channel. [0 to 255]
  double mean = 0;                   ///< Mean absolute difference over all channels. [0 to 255]
  std::int64_t differingPixels = 0;  ///< Pixels with a channel off by more than Tolerance::largest.
  double differingPercent = 0;       ///< differingPixels as a share of all pixels. [%]
  bool same = true;                  ///< differingPercent <= Tolerance::failPercent
};

/// Compares red, green and blue. Throws InputError if the sizes differ.
Comparison compare(ImageView a, ImageView b, Tolerance tolerance);

/// Returns |a - b| * gain, clamped, as an Rgb8 picture. Throws InputError if the sizes differ.
Image differenceImage(ImageView a, ImageView b, int gain = 16);

}  // namespace rotatebook::image
