// The table of video formats, with a row for each.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook::video {

struct VideoSettings;
struct Stages;

enum class VideoFormat { Mp4, WebM, Gif, Apng, ProRes, Hevc, Av1 };

/// Largest rate of GIFs, as players slow down faster ones. Of a faster clip every second picture is
/// taken, or every third and so on. [1/s]
inline constexpr int kMaxGifRate = 50;

/// Makes a format's converter and encoder: see stages.h. Throws InputError for settings out of
/// range, MachineError if there is no encoder or it doesn't start.
using MakeStages = Stages(const VideoSettings& settings);

/// Uses the best H.264 encoder that FFmpeg was built with: libx264, else the next. High profile,
/// yuv420p, a key frame every two seconds at most.
MakeStages makeMp4Stages;
/// Uses libvpx's VP9 at constant quality, on one thread.
MakeStages makeWebmStages;
/// Takes 255 colours a picture and at most kMaxGifRate pictures a second; loops for ever.
MakeStages makeGifStages;
/// Keeps the pictures' exact pixels; loops for ever.
MakeStages makeApngStages;

/// Uses ProRes 4444 in QuickTime's container, 10 bits a sample, 4:4:4, with straight alpha.
MakeStages makeProResStages;
/// Uses libx265 at constant quality, Main profile, yuv420p, in MP4, tagged hvc1.
MakeStages makeHevcStages;
/// Uses libaom's AV1 at constant quality, Main profile, yuv420p, in MP4.
MakeStages makeAv1Stages;

/// An encoder by FFmpeg's name, and the remedy if FFmpeg was built without it.
struct EncoderNeed {
  const char* name;
  const char* remedy;
};

/// The stream of a clip in a format that holds a record, as its encoder leaves it.
struct RecordedStream {
  std::string_view profile{};   ///< FFmpeg's names of it and the pixels: "High, yuv420p"
  std::string_view decoders{};  ///< FFmpeg's names, separated by commas.
  double stampBound = 0;        ///< Largest error of a time stamp. [s]
  double lengthBound = 0;       ///< Largest error of the duration, which is in microseconds. [s]
};

/// A row of the table of formats.
struct FormatRow {
  VideoFormat format;
  std::string_view name;     ///< "mp4", for --format.
  std::string_view ending;   ///< ".mp4"; may end in another's.
  std::string_view muxer;    ///< FFmpeg's name of the muxer.
  std::string_view title;    ///< "MP4"
  std::string_view demuxer;  ///< FFmpeg's name of the demuxer.
  std::string_view codec;    ///< FFmpeg's name of the codec.
  bool keepsTransparency;
  /// True if the file has metadata, which record the scene that it was made from. Browsers' <video>
  /// plays these formats.
  bool holdsRecord;
  bool usesThreads;  ///< True if VideoSettings::threads encode it, else one does.
  /// Bytes of a picture over its number of pixels to the power of 0.85, rather too large.
  double weight;
  EncoderNeed encoder;  ///< The best one. For MP4 alone another will do.
  MakeStages* makeStages;
  RecordedStream recorded{};  ///< If it holdsRecord.
  bool isForEditors = false;  ///< For programs that cut films; pages show no such file.
};

/// All formats, in the order of the enumeration. Weights were measured as 0.13 to 0.20 for MP4 and
/// WebM (0.10 to 0.26 on scenes with overlays and quicker turns), 1.4 to 1.8 for GIF and APNG (0.9
/// to 2.6), 3.6 for ProRes, 0.05 to 0.1 for HEVC and AV1. WebM rounds times to milliseconds; in
/// MP4, a frame is a whole number of clock ticks.
inline constexpr std::array kFormatRows{
    FormatRow{
        .format = VideoFormat::Mp4,
        .name = "mp4",
        .ending = ".mp4",
        .muxer = "mp4",
        .title = "MP4",
        .demuxer = "mov",
        .codec = "h264",
        .keepsTransparency = false,
        .holdsRecord = true,
        .usesThreads = true,
        .weight = 0.18,
        .encoder = {"libx264", "install a build with libx264 (Debian, Ubuntu: libavcodec-extra)"},
        .makeStages = makeMp4Stages,
        .recorded = {.profile = "High, yuv420p",
                     .decoders = "h264",
                     .stampBound = 1e-6,
                     .lengthBound = 2e-6}},
    FormatRow{
        .format = VideoFormat::WebM,
        .name = "webm",
        .ending = ".webm",
        .muxer = "webm",
        .title = "WebM",
        .demuxer = "matroska",
        .codec = "vp9",
        .keepsTransparency = true,
        .holdsRecord = true,
        .usesThreads = false,
        .weight = 0.22,
        .encoder = {"libvpx-vp9", "install a build with libvpx (Debian, Ubuntu: libavcodec-extra)"},
        .makeStages = makeWebmStages,
        .recorded = {.profile = "Profile 0, yuv420p",
                     .decoders = "vp9,libvpx-vp9",
                     .stampBound = 0.501e-3,
                     .lengthBound = 1.001e-3}},
    FormatRow{.format = VideoFormat::Gif,
              .name = "gif",
              .ending = ".gif",
              .muxer = "gif",
              .title = "GIF",
              .demuxer = "gif",
              .codec = "gif",
              .keepsTransparency = false,
              .holdsRecord = false,
              .usesThreads = false,
              .weight = 2.5,
              .encoder = {"gif", "install a build with GIF (Debian, Ubuntu: libavcodec-extra)"},
              .makeStages = makeGifStages},
    FormatRow{.format = VideoFormat::Apng,
              .name = "apng",
              .ending = ".apng",
              .muxer = "apng",
              .title = "APNG",
              .demuxer = "apng",
              .codec = "apng",
              .keepsTransparency = true,
              .holdsRecord = false,
              .usesThreads = false,
              .weight = 2.5,
              .encoder = {"apng", "install a build with zlib (Debian, Ubuntu: libavcodec-extra)"},
              .makeStages = makeApngStages},
    FormatRow{
        .format = VideoFormat::ProRes,
        .name = "prores",
        .ending = ".mov",
        .muxer = "mov",
        .title = "ProRes",
        .demuxer = "mov",
        .codec = "prores",
        .keepsTransparency = true,
        .holdsRecord = false,
        .usesThreads = false,
        .weight = 4.5,
        .encoder = {"prores_ks", "install a build with ProRes (Debian, Ubuntu: libavcodec-extra)"},
        .makeStages = makeProResStages,
        .isForEditors = true},
    FormatRow{
        .format = VideoFormat::Hevc,
        .name = "hevc",
        .ending = ".hevc.mp4",
        .muxer = "mp4",
        .title = "HEVC",
        .demuxer = "mov",
        .codec = "hevc",
        .keepsTransparency = false,
        .holdsRecord = false,
        .usesThreads = false,
        .weight = 0.22,
        .encoder = {"libx265", "install a build with libx265 (Debian, Ubuntu: libavcodec-extra)"},
        .makeStages = makeHevcStages,
        .isForEditors = true},
    FormatRow{
        .format = VideoFormat::Av1,
        .name = "av1",
        .ending = ".av1.mp4",
        .muxer = "mp4",
        .title = "AV1",
        .demuxer = "mov",
        .codec = "av1",
        .keepsTransparency = false,
        .holdsRecord = false,
        .usesThreads = false,
        .weight = 0.22,
        .encoder = {"libaom-av1", "install a build with libaom (Debian, Ubuntu: libavcodec-extra)"},
        .makeStages = makeAv1Stages,
        .isForEditors = true}};

/// All formats, in the order of the rows.
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
    "the rows are in the enumeration's order");

constexpr std::string_view nameOf(VideoFormat format) {
  return rowOf(format).name;
}
constexpr bool keepsTransparency(VideoFormat format) {
  return rowOf(format).keepsTransparency;
}

/// Returns the format whose ending is the longest that `fileName` ends in; nothing if none is.
std::optional<VideoFormat> formatOfName(std::string_view fileName);
/// Returns the format of that file, by its name. Throws InputError, which says what names can end
/// in, and what may be meant; `otherwise` is further advice, for example "; or name a folder".
VideoFormat formatOfFile(const std::filesystem::path& file, std::string_view otherwise = "");

/// Returns FFmpeg's names of the demuxers of all formats, each once, separated by commas.
std::string demuxers();
/// Returns FFmpeg's names of the decoders of the formats that hold a record, likewise.
std::string decoders();

/// Lists formats for a message, those that have the `property` or all: "mp4, webm, gif or apng" if
/// `column` is FormatRow::name and `conjunction` is "or".
std::string listFormats(std::string_view FormatRow::*column, std::string_view conjunction,
                        bool FormatRow::*property = nullptr);

}  // namespace rotatebook::video
