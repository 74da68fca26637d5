// Limits of clips: what a scene may ask for, a file may claim, and an encoder takes.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rotatebook {

/// Widest and highest picture. [pixels]
inline constexpr int kMaxPictureSide = 16'384;

/// Largest picture: 139,264 macroblocks of 16x16, as many as the highest level of H.264 has (6.2;
/// ITU-T H.264, table A-1), for example 8192x4352. [pixels]
inline constexpr std::int64_t kMaxPicturePixels = 139'264 * 16 * 16;

/// The range of x264's constant rate factor. 0 is lossless, which H.264 has in High 4:4:4
/// Predictive only: not what browsers play.
inline constexpr int kBestCrf = 1, kWorstCrf = 51;

/// The preset made for clips of the book: pictures at least as like as x264's medium makes them at
/// the same crf, in a fifth of its time, in files twice as large.
inline constexpr std::string_view kBookPreset = "book";

/// That, and x264's, fastest first.
inline constexpr std::array<std::string_view, 11> kVideoPresets{
    kBookPreset, "ultrafast", "superfast", "veryfast", "faster", "fast",
    "medium",    "slow",      "slower",    "veryslow", "placebo"};

}  // namespace rotatebook
