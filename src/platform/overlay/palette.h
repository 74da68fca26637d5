// Colours of the overlays, and sizes of their letters and lines. Inside the room only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "overlay/colour.h"

namespace rotatebook::overlay {

inline constexpr Colour kWhite{0.97, 0.96, 0.93};
inline constexpr Colour kGrey{0.72, 0.72, 0.74};
inline constexpr Colour kDark{0.04, 0.045, 0.06};

// After Okabe and Ito's palette, which colour-blind people can tell apart, lighter for a dark
// background.
inline constexpr std::array<Colour, 3> kAxisColours{
    {{0.96, 0.46, 0.33}, {0.28, 0.80, 0.62}, {0.42, 0.69, 0.98}}};
inline constexpr Colour kVelocityColour{0.98, 0.82, 0.30};
inline constexpr Colour kMomentumColour{0.91, 0.60, 0.85};
inline constexpr Colour kKineticColour{0.42, 0.75, 0.95};
inline constexpr Colour kSpringColour{0.95, 0.62, 0.25};
inline constexpr Colour kTotalColour = kWhite;
inline constexpr Colour kCentrifugalColour{0.95, 0.55, 0.25};
inline constexpr Colour kCoriolisColour{0.36, 0.66, 0.98};
inline constexpr Colour kEulerColour{0.30, 0.80, 0.62};
inline constexpr Colour kErrorColour{0.96, 0.55, 0.45};
inline constexpr Colour kGhostColour{0.72, 0.92, 1.0};
inline constexpr Colour kWarningColour{0.98, 0.70, 0.30};

/// Opacity of the dark boxes of charts: over a white page, letters have 4.5 times their light.
inline constexpr double kBacking = 0.82;

/// Mixes two colours: `a` at t = 0, `b` at t = 1.
constexpr Colour mixed(const Colour& a, const Colour& b, double t) {
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue)};
}

/// Returns the colour of an axis' letter on such a box, which is light enough for that.
constexpr Colour axisLetterColour(std::size_t axis) {
  return mixed(kAxisColours[axis], kWhite, 0.25);
}

/// A picture of fewer rows is for a quick look: text that has no room beside the book is left out.
inline constexpr int kSmallPicture = 360;

/// Lengths that grow with the picture, but are never too small to read.
struct Scale {
  /// Takes the picture's size [pixels] and scene::OverlaySettings::scale.
  Scale(int pictureWidth, int pictureHeight, double overlayScale = 1)
      : width(pictureWidth),
        height(pictureHeight),
        factor(overlayScale),
        unit(factor * std::min(height, width)),
        margin(std::max(0.045 * unit / factor, 8.0)),
        letters(std::max(0.035 * unit, 10.0)),
        smallLetters(std::max(0.0255 * unit, 9.0)),
        arrowLetters(std::max(0.0255 * unit, 10.0)),
        line(std::max(0.0036 * unit, 1.3)),
        halo(std::max(0.0024 * unit, 1.0)) {}

  /// Makes all letters at least as large as those of a larger picture, of which this is a part.
  void enlargeLetters(double least) {
    constexpr double kSmall = 0.72;  // size of small letters, relative to the others
    letters = std::max(letters, least);
    smallLetters = std::max(smallLetters, kSmall * least);
    arrowLetters = std::max(arrowLetters, kSmall * least);
  }

  int width, height;    ///< Of the picture. [pixels]
  double factor;        ///< scene::OverlaySettings::scale
  double unit;          ///< The picture's shorter side, times `factor`. [pixels]
  double margin;        ///< [pixels]
  double letters;       ///< Letter size of captions and labels. [pixels]
  double smallLetters;  ///< Letter size within insets. [pixels]
  double arrowLetters;  ///< Likewise at arrows, where letters are in the way. [pixels]
  double line;          ///< Width of lines. [pixels]
  double halo;          ///< Width of the dark edge of lines and letters. [pixels]
};

}  // namespace rotatebook::overlay
