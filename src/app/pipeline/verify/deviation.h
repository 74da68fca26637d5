// Measures of how far a decoded picture is from the drawn one. Inside the room only.
#pragma once

#include <array>
#include <optional>

#include "video/planes.h"

namespace rotatebook::pipeline {

/// Errors of a picture. Those but the first three are means over many pixels, of which the noise of
/// encoding leaves little: they show changes that are far smaller than that noise.
struct Deviation {
  double rms = 0;         ///< Root mean square over all samples. [of 255]
  double worstBlock = 0;  ///< Largest such error in 16x16 pixels. [of 255]
  double detail = 0;      ///< Largest such error of luma in 8x8 pixels: digits. [of 255]
  double brightness = 0;  ///< Rms of the change of luma by gain and offset that fits. [of 255]
  double colour =
      0;  ///< Rms of the change of chroma by hue, saturation and tint that fits. [of 255]
  double shift = 0;        ///< Length of the translation that fits. [pixels]
  double lumaPatch = 0;    ///< Largest mean change of luma in 32x32 pixels, either way. [of 255]
  double chromaPatch = 0;  ///< Likewise of chroma. [of 255]
};

/// A row of the table of measures.
struct MeasureRow {
  const char* name;  ///< "luma_patch": in JSON.
  const char* text;  ///< "luma changed in 32x32 pixels": for people.
  double Deviation::*value;
};

inline constexpr std::array<MeasureRow, 8> kMeasures{{
    {"rms", "off", &Deviation::rms},
    {"worst_block", "off in the worst block", &Deviation::worstBlock},
    {"detail", "off in 8x8 pixels", &Deviation::detail},
    {"brightness", "brightness or contrast changed", &Deviation::brightness},
    {"colour", "hue, saturation or tint changed", &Deviation::colour},
    {"shift", "shifted", &Deviation::shift},
    {"luma_patch", "luma changed in 32x32 pixels", &Deviation::lumaPatch},
    {"chroma_patch", "chroma changed in 32x32 pixels", &Deviation::chromaPatch},
}};

/// Measures the noise of encoding in `picture`: the upper quartile of the root mean square of
/// luma's error in the blocks of 16x16 pixels that show texture in `drawn`. [of 255] A change of
/// fewer than a quarter of these leaves it. None if too few blocks show texture.
std::optional<double> codingNoise(const video::Planes& picture, const video::Planes& drawn);

/// Returns how many times as far a picture like `drawn` may seem shifted as one that a book fills:
/// fewer edges tell it less surely. >= 1
double roomOfShift(const video::Planes& drawn);

/// Returns whether no measure of `measured` is above that of `bound`.
bool isWithin(const Deviation& measured, const Deviation& bound);

/// Measures how far `picture` is from `drawn`. Throws InputError if the sizes differ.
Deviation deviation(const video::Planes& picture, const video::Planes& drawn);

}  // namespace rotatebook::pipeline
