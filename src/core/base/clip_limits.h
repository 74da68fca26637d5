// Limits of clips: what a scene may request, a file may declare and an encoder accepts.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rotatebook {

/// Largest width and height of a picture. [pixels]
inline constexpr int kMaxPictureSide = 16'384;

/// Largest area of a picture: 139,264 macroblocks of 16x16, the most that H.264 allows at its
/// highest level (6.2; ITU-T H.264, table A-1), for example 8192x4352. [pixels]
inline constexpr std::int64_t kMaxPicturePixels = 139'264 * 16 * 16;

/// Longest file of a picture that is read: the largest picture, uncompressed. [bytes]
inline constexpr std::uintmax_t kMaxPictureBytes = 5 * kMaxPicturePixels;

/// Range of x264's constant rate factor. It excludes 0, which is lossless: H.264 has that only in
/// its profile High 4:4:4 Predictive, which browsers don't play.
inline constexpr int kBestCrf = 1, kWorstCrf = 51;

/// The preset tuned for clips of the book: its pictures are at least as close to the source as
/// those of x264's medium at the same crf, in a fifth of the time, in files twice as large.
inline constexpr std::string_view kBookPreset = "book";

/// The book preset and x264's own, fastest first.
inline constexpr std::array<std::string_view, 11> kVideoPresets{
    kBookPreset, "ultrafast", "superfast", "veryfast", "faster", "fast",
    "medium",    "slow",      "slower",    "veryslow", "placebo"};

}  // namespace rotatebook
