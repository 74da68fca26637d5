// The kinds of files that pictures can be made into.
#pragma once

#include <array>
#include <string_view>

namespace rotatebook::video {

enum class VideoFormat {
  Mp4,   ///< H.264; opaque.
  WebM,  ///< VP9; keeps transparency.
  Gif,   ///< 255 colours a picture, at most kMostGifRate pictures a second; opaque; loops for ever.
  Apng,  ///< The pictures' very pixels; keeps transparency; loops for ever.
};

/// All formats, in the order of the enumeration.
inline constexpr std::array<VideoFormat, 4> kVideoFormats{VideoFormat::Mp4, VideoFormat::WebM,
                                                          VideoFormat::Gif, VideoFormat::Apng};

/// "mp4", "webm", "gif" or "apng": its name, and the ending of its files.
constexpr std::string_view nameOf(VideoFormat format) {
  constexpr std::array<std::string_view, kVideoFormats.size()> kNames{"mp4", "webm", "gif", "apng"};
  return kNames[static_cast<std::size_t>(format)];
}

constexpr bool keepsTransparency(VideoFormat format) {
  return format == VideoFormat::WebM || format == VideoFormat::Apng;
}

/// Players slow down GIFs of more pictures a second. Of a faster clip every second picture is
/// taken, or every third and so on.
inline constexpr int kMostGifRate = 50;

}  // namespace rotatebook::video
