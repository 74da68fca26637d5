// What tests of plots share.
#pragma once

#include <gtest/gtest.h>

#include "image/comparison.h"
#include "plot/drawing.h"

namespace rotatebook::plot {

// Letters of other versions of the libraries differ in their edges.
inline constexpr image::Tolerance kOtherFonts{.largest = 24, .failPercent = 0.025};

/// Expects that all texts are on the sheet, and that none meets another.
inline void expectTextsApart(const Drawing& drawing) {
  const std::vector<Written>& texts = drawing.texts();
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_TRUE(drawing.sheet().holds(texts[i].box)) << texts[i].text;
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(texts[i].box.meets(texts[j].box)) << texts[i].text << " | " << texts[j].text;
    }
  }
}

}  // namespace rotatebook::plot
