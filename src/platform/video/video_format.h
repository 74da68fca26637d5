// The kinds of video files: all that is known of each stands in one row of a table.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace rotatebook::video {

struct VideoSettings;
struct Stages;

enum class VideoFormat { Mp4, WebM, Gif, Apng };

/// Players slow down GIFs of more pictures a second. Of a faster clip every second picture is
/// taken, or every third and so on.
inline constexpr int kMaxGifRate = 50;

/// Makes what converts a format's pictures, and its encoder: see stages.h. Throws InputError for
/// settings out of range, MachineError where there is no encoder or it doesn't start.
using MakeStages = Stages(const VideoSettings& settings);

/// The best H.264 encoder that FFmpeg was built with: libx264, else the next. High profile,
/// yuv420p, a key frame every two seconds at most.
MakeStages makeMp4Stages;
/// libvpx's VP9 at constant quality, on one thread.
MakeStages makeWebmStages;
/// 255 colours a picture, at most kMaxGifRate pictures a second; loops for ever.
MakeStages makeGifStages;
/// The pictures' very pixels; loops for ever.
MakeStages makeApngStages;

/// An encoder by FFmpeg's name, and what to do where FFmpeg was built without.
struct EncoderNeed {
  const char* name;
  const char* remedy;
};

/// A format's row.
struct FormatRow {
  VideoFormat format;
  std::string_view name;     ///< "mp4": for --format, and FFmpeg's name of what writes the file.
  std::string_view ending;   ///< ".mp4"
  std::string_view title;    ///< "MP4"
  std::string_view demuxer;  ///< FFmpeg's name of what reads the file.
  bool keepsTransparency;
  /// Whether the file has metadata, for the scene that it was made from. Browsers' <video> plays
  /// these formats.
  bool holdsRecord;
  /// Bytes of a picture over its number of pixels to the power of 0.85, rather more than less.
  double weight;
  EncoderNeed encoder;  ///< The best one. Of MP4 alone another will do.
  MakeStages* makeStages;
};

/// All formats, in the order of the enumeration. Weights were measured as 0.13 to 0.20 for MP4 and
/// WebM (0.10 to 0.26 on scenes with overlays and quicker turns), 1.4 to 1.8 for GIF and APNG (0.9
/// to 2.6).
inline constexpr std::array kFormatRows{
    FormatRow{VideoFormat::Mp4,
              "mp4",
              ".mp4",
              "MP4",
              "mov",
              false,
              true,
              0.22,
              {"libx264", "install a build with libx264 (Debian, Ubuntu: libavcodec-extra)"},
              makeMp4Stages},
    FormatRow{VideoFormat::WebM,
              "webm",
              ".webm",
              "WebM",
              "matroska",
              true,
              true,
              0.22,
              {"libvpx-vp9", "install a build with libvpx (Debian, Ubuntu: libavcodec-extra)"},
              makeWebmStages},
    FormatRow{VideoFormat::Gif,
              "gif",
              ".gif",
              "GIF",
              "gif",
              false,
              false,
              2.5,
              {"gif", "install a build with GIF (Debian, Ubuntu: libavcodec-extra)"},
              makeGifStages},
    FormatRow{VideoFormat::Apng,
              "apng",
              ".apng",
              "APNG",
              "apng",
              true,
              false,
              2.5,
              {"apng", "install a build with zlib (Debian, Ubuntu: libavcodec-extra)"},
              makeApngStages}};

/// The formats of the rows.
inline constexpr auto kVideoFormats = [] {
  std::array<VideoFormat, kFormatRows.size()> formats{};
  for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = kFormatRows[i].format;
  return formats;
}();

constexpr const FormatRow& rowOf(VideoFormat format) {
  return kFormatRows[static_cast<std::size_t>(format)];
}

static_assert(
    [] {
      for (const VideoFormat format : kVideoFormats) {
        if (rowOf(format).format != format) return false;
      }
      return true;
    }(),
    "the rows have the enumeration's order");

constexpr std::string_view nameOf(VideoFormat format) {
  return rowOf(format).name;
}
constexpr bool keepsTransparency(VideoFormat format) {
  return rowOf(format).keepsTransparency;
}

/// Names formats in a message, those that have the `property` or all: "mp4, webm, gif or apng"
/// where `words` are their names and `lastWord` is "or".
std::string listFormats(std::string_view FormatRow::*words, std::string_view lastWord,
                        bool FormatRow::*property = nullptr);

}  // namespace rotatebook::video
