// Files of plots: complete, alike, and the same each time.
#include "plot/drawing.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "plot/plot_files.h"

namespace rotatebook::plot {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr Colour kRed{1, 0, 0}, kWhite{1, 1, 1};

/// A sheet of 40 x 20 with a red square at its left, a picture of two pixels, and a word.
Drawing sheet() {
  Drawing drawing(40, 20, kWhite, overlay::Typesetter());
  drawing.canvas().area(std::vector<Point>{{2, 2}, {8, 2}, {8, 8}, {2, 8}}, {kRed});
  image::Image two(2, 1, image::PixelFormat::Rgb8);
  two.row(0)[2] = 255;  // Blue, beside black
  drawing.picture(two, {10, 2, 8, 4});
  drawing.write("Word", {.size = 10, .colour = {0, 0, 0}}, {38, 18}, {1, 1});
  return drawing;
}

Rgb at(const image::Image& picture, int x, int y) {
  const std::uint8_t* byte = picture.row(y) + 3 * static_cast<std::ptrdiff_t>(x);
  return {byte[0], byte[1], byte[2]};
}

TEST(Drawing, HasItsPixelsAtEachScale) {
  for (const int scale : {1, 2, 3}) {
    const image::Image picture = sheet().pixels(scale);
    EXPECT_EQ(picture.width(), 40 * scale);
    EXPECT_EQ(picture.height(), 20 * scale);
    EXPECT_EQ(at(picture, 5 * scale, 5 * scale), (Rgb{255, 0, 0}));
    EXPECT_EQ(at(picture, 14 * scale - 1, 3 * scale), (Rgb{0, 0, 255}));
    EXPECT_EQ(at(picture, 14 * scale, 3 * scale), (Rgb{0, 0, 0}));
    EXPECT_EQ(at(picture, 30 * scale, 3 * scale), (Rgb{255, 255, 255}));
  }
}

TEST(Drawing, AnchorsItsTexts) {
  const Drawing drawing = sheet();
  ASSERT_EQ(drawing.texts().size(), 1U);
  EXPECT_EQ(drawing.texts()[0].text, "Word");
  EXPECT_EQ(drawing.texts()[0].box.right(), 38);
  EXPECT_EQ(drawing.texts()[0].box.bottom(), 18);
}

TEST(Drawing, NamesALetterThatTheFontLacks) {
  Drawing drawing = sheet();
  EXPECT_THROW(drawing.write("\xe4\xb8\xad", {}, {0, 0}), InputError);
}

TEST(PlotFiles, AreOfEachFormat) {
  const std::vector<PlotFile> files =
      filesOf(sheet(), {"plots/it's \"a\".png", "plots/it's \"a\".svg", "plots/it's \"a\".pdf"}, 2);
  ASSERT_EQ(files.size(), 3U);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(files[0].bytes.data());
  EXPECT_EQ(image::decodePng({bytes, files[0].bytes.size()}, "a plot"), sheet().pixels(2));
  EXPECT_EQ(files[1].path, "plots/it's \"a\".svg");
  EXPECT_THAT(files[1].bytes,
              AllOf(HasSubstr("width=\"40px\" height=\"20px\""), HasSubstr("rgb(100%,0%,0%)"),
                    HasSubstr("<image "), EndsWith("</svg>\n")));
  EXPECT_THAT(files[2].bytes, AllOf(StartsWith("%PDF-"), HasSubstr("/MediaBox [ 0 0 30 15 ]"),
                                    HasSubstr("Inter"), EndsWith("%%EOF\n")));
}

TEST(PlotFiles, HaveTheSameBytesEachTime) {
  EXPECT_EQ(sheet().file(".png"), sheet().file(".png"));
  EXPECT_EQ(sheet().file(".svg"), sheet().file(".svg"));
  EXPECT_EQ(sheet().file(".pdf"), sheet().file(".pdf"));
  EXPECT_THAT(sheet().file(".pdf"), ::testing::Not(HasSubstr("CreationDate")));
}

}  // namespace
}  // namespace rotatebook::plot
