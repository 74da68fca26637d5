#include "overlay/text.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"

namespace rotatebook::overlay {
namespace {

constexpr int kWide = 10'000;

std::string refusalOf(const std::string& text) {
  try {
    Typesetter().draw(text, {}, kWide);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

int mostOpaque(const Layer& layer) {
  int most = 0;
  for (std::size_t i = 3; i < layer.pixels.size(); i += 4) {
    most = std::max<int>(most, layer.pixels[i]);
  }
  return most;
}

TEST(Typesetter, DrawsWordsAsLargeAsItMeasures) {
  const Typesetter type;
  const TextStyle style{20, false, {}, 1};
  const TextSize size = type.measure("Classical mechanics", style, kWide);
  const Layer layer = type.draw("Classical mechanics", style, kWide);
  EXPECT_EQ(layer.width, size.width);
  EXPECT_EQ(layer.height, size.height);
  EXPECT_GT(size.width, 7 * 20);
  EXPECT_LT(size.width, 12 * 20);
  EXPECT_GT(mostOpaque(layer), 250);
}

TEST(Typesetter, GivesTheSamePixelsAgain) {
  const TextStyle style{17.3, true, {1, 0.5, 0}, 0.9};
  EXPECT_EQ(Typesetter().draw("ωt = 3.25", style, kWide).pixels,
            Typesetter().draw("ωt = 3.25", style, kWide).pixels);
}

// Cairo remembers faces by the paths of their files, in which a descriptor's number stands.
TEST(Typesetter, GivesTheSamePixelsWhateverFilesAreOpen) {
  const TextStyle light{17, false, {}, 1}, bold{17, true, {}, 1};
  const auto draw = [](const TextStyle& style) {
    return Typesetter().draw("half-turns", style, kWide).pixels;
  };
  const auto before = std::pair{draw(light), draw(bold)};
  const std::ifstream shiftsTheNumbers("/dev/null");
  EXPECT_TRUE(draw(light) == before.first);
  EXPECT_TRUE(draw(bold) == before.second);
}

TEST(Typesetter, BreaksLinesAtWordsAndWithinThemIfItMust) {
  const Typesetter type;
  const TextStyle style{20, false, {}, 1};
  const TextSize one = type.measure("one two three", style, kWide);
  const TextSize three = type.measure("one two three", style, one.width / 2);
  EXPECT_GE(three.height, 2 * one.height);
  EXPECT_LE(three.width, one.width / 2);
  EXPECT_LE(type.measure("Rotationsbewegungsenergie", style, 60).width, 60);
}

TEST(Typesetter, HasABolderFace) {
  const Typesetter type;
  EXPECT_NE(type.draw("book", {20, true, {}, 1}, kWide).pixels,
            type.draw("book", {20, false, {}, 1}, kWide).pixels);
}

TEST(Typesetter, DrawsInItsColourAndOpacity) {
  const Layer layer = Typesetter().draw("|", {60, true, {1, 0.5, 0}, 0.5}, kWide);
  const int most = mostOpaque(layer);
  EXPECT_NEAR(most, 128, 1);
  for (std::size_t i = 0; i < layer.pixels.size(); i += 4) {
    if (layer.pixels[i + 3] != most) continue;
    EXPECT_EQ(layer.pixels[i], 0);
    EXPECT_NEAR(layer.pixels[i + 1], 64, 1);
    EXPECT_NEAR(layer.pixels[i + 2], 128, 1);
  }
}

TEST(Typesetter, RefusesLettersThatTheFontLacks) {
  EXPECT_EQ(refusalOf("Größe, αβγ, жук, 1 − 2 × ½ ≤ √3"), "");
  EXPECT_MESSAGE(refusalOf("漢字"));
  EXPECT_MESSAGE(refusalOf("First\nand é 字漢"));
}

/// Returns the sum of a layer's opacities, those of whole letters 1. [pixels]
double inkOf(const Layer& layer) {
  double sum = 0;
  for (std::size_t i = 3; i < layer.pixels.size(); i += 4) sum += layer.pixels[i] / 255.0;
  return sum;
}

/// Words that are read from the right, and the same followed by others that aren't.
const std::vector<std::string> kFromTheRight{"תנועה של ספר", "حركة كتاب", "ספר abc 123",
                                             "כתב\nשורה שנייה"};

// Pango sets such lines at the right end of the width that they may take.
TEST(Typesetter, DrawsWordsThatAreReadFromTheRight) {
  const Typesetter type("DejaVu Sans");
  for (const std::string& text : kFromTheRight) {
    EXPECT_TRUE(type.isReadFromTheRight(text)) << text;
    for (const double halo : {0.0, 3.0}) {
      const TextStyle style{.size = 20, .colour = {1, 1, 1}, .halo = halo};
      const TextSize size = type.measure(text, style, kWide);
      const Layer wide = type.draw(text, style, kWide);
      const int margin = static_cast<int>(halo);
      EXPECT_EQ(wide.width, size.width + 2 * margin);
      EXPECT_EQ(wide.x, -margin);
      EXPECT_GT(inkOf(wide), 100) << text;  // measured 284 and more
      EXPECT_LT(size.width, 200);           // measured 128
      // The same whatever the width, to a fraction of a pixel's shift.
      const Layer narrow = type.draw(text, style, 2 * size.width);
      EXPECT_NEAR(inkOf(narrow), inkOf(wide), 0.02 * inkOf(wide)) << text;  // measured 0
    }
  }
  EXPECT_FALSE(type.isReadFromTheRight("abc ספר"));
  EXPECT_FALSE(type.isReadFromTheRight(""));
}

TEST(Typesetter, WrapsWordsThatAreReadFromTheRight) {
  const Typesetter type("DejaVu Sans");
  const TextStyle style{.size = 20, .colour = {1, 1, 1}};
  const Layer one = type.draw(kFromTheRight[0], style, kWide);
  const Layer two = type.draw(kFromTheRight[0], style, one.width - 1);
  EXPECT_GT(two.height, 1.5 * one.height);                 // measured 1.96
  EXPECT_NEAR(inkOf(two), inkOf(one), 0.05 * inkOf(one));  // measured 2e-15
}

TEST(Typesetter, RefusesAFontThatIsNotThere) {
  try {
    Typesetter type("No Such Font");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_MESSAGE(error.what());
  }
}

}  // namespace
}  // namespace rotatebook::overlay
