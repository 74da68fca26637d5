#include "image/png_colours.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/png_bytes.h"
#include "image/png_file.h"

namespace rotatebook::image {
namespace {

using testing::Bytes;
using testing::chunk;
using testing::ColourType;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::joined;
using testing::pngFile;

constexpr const char* kTakenAsSrgb = ", in place of which sRGB is assumed; convert to it first";

Bytes words(std::initializer_list<std::uint32_t> numbers) {
  Bytes bytes;
  for (const std::uint32_t number : numbers) {
    for (int shift = 24; shift >= 0; shift -= 8)
      bytes.push_back(static_cast<std::uint8_t>(number >> shift));
  }
  return bytes;
}

/// Returns a profile's chunk with that name, whose content nobody reads.
Bytes profileOf(const std::string& name) {
  Bytes content(name.begin(), name.end());
  content.insert(content.end(), {0, 0, 1, 2, 3});
  return chunk("iCCP", content);
}

std::vector<std::string> lostWith(const Bytes& extra) {
  const Bytes file = pngFile({1, 1}, {0, 1, 2, 3}, extra);
  decodePng(file, "a.png");  // must be a PNG
  return lostColoursOf(file);
}

const Bytes kSrgb = chunk("sRGB", {0}), kLinear = chunk("gAMA", words({100'000})),
            kSrgbGamma = chunk("gAMA", words({45'455})),
            kSrgbPrimaries = chunk(
                "cHRM", words({31'270, 32'900, 64'000, 33'000, 30'000, 60'000, 15'000, 6'000})),
            kP3Primaries = chunk(
                "cHRM", words({31'270, 32'900, 68'000, 32'000, 26'500, 69'000, 15'000, 6'000}));

TEST(LostColours, OfSrgbAreNone) {
  EXPECT_THAT(lostWith({}), IsEmpty());
  EXPECT_THAT(lostWith(joined({kSrgb, kSrgbGamma, kSrgbPrimaries})), IsEmpty());
  EXPECT_THAT(lostWith(joined({kSrgbGamma, kSrgbPrimaries})), IsEmpty());
  EXPECT_THAT(lostWith(profileOf("sRGB IEC61966-2.1")), IsEmpty());
  EXPECT_THAT(lostWith(chunk("cICP", {1, 13, 0, 1})), IsEmpty());
  EXPECT_THAT(lostWith(joined({kSrgb, kLinear})), IsEmpty()) << "sRGB is before gAMA";
}

TEST(LostColours, OfOtherKindsAreNamed) {
  const auto says = [](const std::string& what) { return ElementsAre(what + kTakenAsSrgb); };
  EXPECT_THAT(lostWith(profileOf("Display P3")), says("the colour profile \"Display P3\""));
  EXPECT_THAT(lostWith(profileOf("\xe9\x1b[2J")), says("the colour profile \"??[2J\""));
  EXPECT_THAT(lostWith(kLinear), says("a gamma of 1 (gAMA)"));
  EXPECT_THAT(lostWith(joined({kSrgbGamma, kP3Primaries})), says("other primaries (cHRM)"));
  EXPECT_THAT(lostWith(joined({chunk("cICP", {9, 16, 0, 1}), kSrgb})),
              says("colours of the code 9, 16, 0, 1 (cICP)"));
  EXPECT_THAT(lostWith(chunk("cICP", {1, 13, 0, 0})),
              says("colours of the code 1, 13, 0, 0 (cICP)"));
  EXPECT_THAT(lostWith(profileOf("GIMP built-in Linear sRGB")),
              says("the colour profile \"GIMP built-in Linear sRGB\""));
  EXPECT_THAT(lostWith(profileOf("sRGB-elle-V2-g10.icc")),
              says("the colour profile \"sRGB-elle-V2-g10.icc\""));
}

TEST(LostColours, OfSixteenBitsAreNamed) {
  const Bytes file = pngFile({.bitDepth = 16, .colourType = ColourType::Grey}, {0, 1, 2}, kLinear);
  EXPECT_THAT(lostColoursOf(file), ElementsAre("16 bits a channel, of which 8 are kept",
                                               std::string("a gamma of 1 (gAMA)") + kTakenAsSrgb));
}

TEST(LostColours, OfBrokenChunksAreNone) {
  Bytes file = pngFile({1, 1}, {0, 1, 2, 3}, kLinear);
  for (std::size_t size = 0; size < file.size(); ++size) {
    const Bytes part(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    lostColoursOf(part);  // reads nothing beyond
  }
  file[33] = 0xff;  // the length of gAMA
  EXPECT_THAT(lostColoursOf(file), IsEmpty());
  EXPECT_THAT(lostColoursOf(joined({pngFile({1, 1}, {0, 1, 2, 3}, chunk("cICP", {9}))})),
              IsEmpty());
}

}  // namespace
}  // namespace rotatebook::image
