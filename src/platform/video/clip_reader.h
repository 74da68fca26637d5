// Videos read back: what they tell of themselves, and their pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "video/mp4_header.h"
#include "video/planes.h"
#include "video/video_format.h"

namespace rotatebook::video {

/// What VideoWriter stores beside the pictures.
struct ClipMetadata {
  VideoFormat format = VideoFormat::Mp4;
  std::string title;    ///< Empty if there is none.
  std::string comment;  ///< As `title`.
};

/// Of the MP4 or WebM `path`; its pictures aren't looked at. Throws InputError if it can't be read,
/// has no pictures, or is of a format without metadata.
ClipMetadata readClipMetadata(const std::filesystem::path& path);
/// The same of a file's bytes, be they what they may; `name` names it in messages.
ClipMetadata readClipMetadata(std::span<const std::uint8_t> bytes, const std::string& name);

/// [pixels]
struct PictureSize {
  int width = 0;
  int height = 0;

  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// Of the pictures of a clip of any format, as its container says. Throws InputError if it can't be
/// read or has no pictures.
PictureSize readPictureSize(const std::filesystem::path& path);

/// What values of pixels mean.
struct ColourTags {
  std::string primaries{};  ///< "bt709"
  std::string transfer{};   ///< "bt709"
  std::string matrix{};     ///< "bt709"
  std::string range{};      ///< "tv" is limited, "pc" full.
};

/// What a player learns from the file. Names are FFmpeg's. The container and the pictures' stream
/// in it tell some things twice, and players differ in which they obey.
struct ClipFacts {
  VideoFormat format = VideoFormat::Mp4;
  int width = 0;                  ///< [pixels]
  int height = 0;                 ///< [pixels]
  std::string codec{};            ///< "h264"
  std::string profile{};          ///< "High"
  std::string pixelFormat{};      ///< "yuv420p", also where there is an alpha.
  ColourTags colours{};           ///< The stream's; the container's where that doesn't tell.
  ColourTags containerColours{};  ///< The container's.
  std::string pixelShape{};      ///< The stream's, width to height: "1:1", also if it doesn't tell.
  std::string containerShape{};  ///< The container's, likewise.
  std::string display{};  ///< How pictures are turned or changed; "as stored" if they aren't.
  double duration = 0;    ///< As the container says; 0 if it doesn't. [s]
  std::optional<Mp4Header> mp4{};  ///< Of an MP4.
};

/// Decodes a clip picture by picture.
class ClipReader {
 public:
  /// Throws InputError if the file can't be read or hasn't one stream, of pictures; MachineError
  /// where there is no decoder.
  explicit ClipReader(const std::filesystem::path& path);
  ClipReader(ClipReader&&) noexcept;
  ClipReader& operator=(ClipReader&&) noexcept;
  ~ClipReader();

  const ClipFacts& facts() const;

  /// Goes to the next picture, the first at the start; false if there is none. Throws InputError
  /// for a damaged one, or one of another size than the clip's.
  bool next();

  /// When the picture is shown, from the file's start; not a number if it doesn't tell. [s]
  double time() const;
  /// The picture as it was stored, with alpha where the clip has it. Throws InputError for one that
  /// isn't yuv420p.
  Planes picture() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::video
