// MP4s whose header lies.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace rotatebook::video::testing {

/// Bytes to put into a box.
struct BoxPatch {
  std::string box;     ///< "tkhd"; the first one of that type.
  std::size_t at = 0;  ///< From where the box's content begins. [bytes]
  std::string bytes;
};

/// `content`, an MP4's, with the patches. Throws std::runtime_error if it lacks a box.
inline std::string forgedMp4(std::string content, const std::vector<BoxPatch>& patches) {
  for (const BoxPatch& patch : patches) {
    const std::size_t box = content.find(patch.box);
    if (box == std::string::npos) throw std::runtime_error("no box " + patch.box);
    content.replace(box + 4 + patch.at, patch.bytes.size(), patch.bytes);
  }
  return content;
}

// Numbers with 16 bits behind the point, in the order of MP4's bytes.
inline const std::string kOne{"\x00\x01\x00\x00", 4};
inline const std::string kMinusOne{"\xff\xff\x00\x00", 4};
inline const std::string kTwo{"\x00\x02\x00\x00", 4};
inline const std::string kHundred{"\x00\x64\x00\x00", 4};
inline const std::string kThree{"\x00\x00\x00\x03", 4};  // a whole number

inline const std::vector<BoxPatch> kTurned{{"tkhd", 40, kMinusOne}, {"tkhd", 56, kMinusOne}};
inline const std::vector<BoxPatch> kMirrored{{"tkhd", 40, kMinusOne}};
inline const std::vector<BoxPatch> kWholeTurned{{"mvhd", 36, kMinusOne}, {"mvhd", 52, kMinusOne}};
inline const std::vector<BoxPatch> kStretched{{"tkhd", 76, kHundred}};
inline const std::vector<BoxPatch> kWidePixels{{"pasp", 0, kThree}};
/// BT.2020, PQ.
inline const std::vector<BoxPatch> kOtherColours{
    {"colr", 4, std::string("\x00\x09\x00\x10\x00\x09", 6)}};
inline const std::vector<BoxPatch> kFullRange{{"colr", 10, "\x80"}};
inline const std::vector<BoxPatch> kFastEdit{{"elst", 16, kTwo}};
inline const std::vector<BoxPatch> kFastMovie{{"mvhd", 20, kTwo}};
/// A clean aperture, or two fields a picture, in place of the pixels' shape.
inline const std::vector<BoxPatch> kCleanAperture{{"pasp", std::size_t{0} - 4, "clap"}};
inline const std::vector<BoxPatch> kFields{{"pasp", 0, "\x02\x01"},
                                           {"pasp", std::size_t{0} - 4, "fiel"}};

}  // namespace rotatebook::video::testing
