// Writes pictures to a video.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "image/image.h"
#include "video/video_format.h"
#include "video/video_settings.h"

namespace rotatebook::video {

/// Writes one video. The same pictures and settings give the same bytes. Picture n is shown at
/// n/frame rate, rounded to the format's resolution of time.
///
/// MP4: H.264 High, yuv420p, BT.709 (converted and tagged, limited range), `avc1`, index first
/// (faststart). WebM: VP9 at constant quality, yuv420p or yuva420p, BT.709 tagged. GIF: a palette
/// for each picture, dithered. APNG: lossless. ProRes 4444, HEVC
/// and AV1: for editors.
class VideoWriter {
 public:
  /// Opens `path` (the caller's temporary name, with any extension). Throws InputError for settings
  /// out of range, MachineError if there is no such encoder or the file can't be written.
  VideoWriter(VideoFormat format, const std::filesystem::path& path, const VideoSettings& settings);
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  ~VideoWriter();

  /// Encodes the next picture (Rgb8 or Rgba8; alpha is ignored unless the video is transparent).
  /// Throws InputError if its size isn't the settings', MachineError if it can't be encoded or
  /// written.
  void write(image::ImageView picture);

  /// Drains the encoder, writes the index, the program's mark if the format holds no record, and
  /// closes the file. Throws MachineError on any failed
  /// flush, trailer or close, and if there was no picture. Without it the file is unplayable; the
  /// destructor only frees.
  void finish();

  /// Returns the name of the encoder in use, for example "libx264".
  const std::string& encoderName() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Returns the version of the FFmpeg libraries in use, for example "5.1.6".
std::string ffmpegVersion();

}  // namespace rotatebook::video
