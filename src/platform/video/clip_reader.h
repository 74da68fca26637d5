// Reads clips back: their metadata, properties and pictures.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "video/planes.h"
#include "video/video_format.h"

namespace rotatebook::video {

/// The metadata that VideoWriter stores beside the pictures.
struct ClipMetadata {
  VideoFormat format = VideoFormat::Mp4;
  std::string title;    ///< Empty if there is none.
  std::string comment;  ///< Empty if there is none.
};

/// Reads the metadata of an MP4 or WebM; its pictures aren't decoded. Throws InputError if the file
/// can't be read, has no pictures, or is in a format without metadata.
ClipMetadata readClipMetadata(const std::filesystem::path& path);
/// Like readClipMetadata(path), from a file's bytes, which may be anything; `name` is for messages.
ClipMetadata readClipMetadata(std::span<const std::uint8_t> bytes, const std::string& name);

/// Size of a picture. [pixels]
struct PictureSize {
  int width = 0;
  int height = 0;

  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// Reads the size of a clip's pictures, of any format, as the container states it. Throws
/// InputError if the file can't be read or has no pictures.
PictureSize readPictureSize(const std::filesystem::path& path);

/// Tags that say what pixel values mean, by FFmpeg's names.
struct ColourTags {
  std::string primaries{};  ///< "bt709"
  std::string transfer{};   ///< "bt709"
  std::string matrix{};     ///< "bt709"
  std::string range{};      ///< "tv": limited, "pc": full.
};

/// Properties of a file as players read them, by FFmpeg's names. The container and the video stream
/// in it both state some of them, and players differ in which they obey.
struct ClipFacts {
  VideoFormat format = VideoFormat::Mp4;
  std::string title{};            ///< Of the metadata; empty if there is none.
  int width = 0;                  ///< [pixels]
  int height = 0;                 ///< [pixels]
  std::string codec{};            ///< "h264"
  std::string profile{};          ///< "High"
  std::string pixelFormat{};      ///< "yuv420p", also with alpha.
  ColourTags colours{};           ///< The stream's; the container's where the stream states none.
  ColourTags containerColours{};  ///< The container's.
  /// The stream's pixel aspect ratio, width to height: "1:1", also if it states none.
  std::string pixelShape{};
  std::string containerShape{};  ///< The container's pixel aspect ratio, likewise.
  /// Rotation or other change of pictures for display; "as stored" if none.
  std::string display{};
  /// "progressive", also if nothing is stated, or what the container or the stream states.
  std::string scan{};
  double duration = 0;  ///< As the container states it; 0 if it doesn't. [s]
};

/// Properties of a decoded picture.
struct PictureFacts {
  bool isKey = false;  ///< It needs no other picture.
  bool interlaced = false;
  bool alpha = false;        ///< True if the stream holds alpha, or the container states some.
  ColourTags colours{};      ///< As valid for this picture.
  std::string pixelShape{};  ///< Pixel aspect ratio, likewise: "1:1", also if none is stated.
  /// Pixels that the stream has players cut off at left, top, right and bottom.
  std::array<std::int64_t, 4> crop{};
  /// Messages between the pictures that change how players show this one, by FFmpeg's names; empty
  /// if there are none.
  std::string messages{};
  /// The quantiser whose step is the root mean square of those of the luma's blocks, in H.264's
  /// scale, 0 to 51, where 6 more double the step. Blocks that are copied count as the picture's
  /// own. Of the colours only, where there is alpha. None if the decoder doesn't report it.
  std::optional<double> quantiser{};
  std::optional<double> coarsestQuantiser{};  ///< Likewise, of the block that has the coarsest.
};

/// Decodes a clip picture by picture.
class ClipReader {
 public:
  /// Opens a clip. Throws InputError if the file can't be read or doesn't have exactly one stream,
  /// of video; MachineError if there is no decoder.
  explicit ClipReader(const std::filesystem::path& path);
  ClipReader(ClipReader&&) noexcept;
  ClipReader& operator=(ClipReader&&) noexcept;
  ~ClipReader();

  const ClipFacts& facts() const;

  /// Decodes the next picture, at first the first; returns false if there is none. Throws
  /// InputError for a damaged one, or one that isn't of the clip's size.
  bool next();

  /// Returns what the stream says about the picture.
  const PictureFacts& pictureFacts() const;
  /// Returns when the picture is shown, from the file's start; NaN if the file doesn't say. [s]
  double time() const;
  /// Returns the picture as stored, with alpha if the clip has it. Throws InputError if it isn't
  /// yuv420p of an even size.
  Planes picture() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::video
