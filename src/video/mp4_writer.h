// Pictures in, an H.264 MP4 out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "base/frame_rate.h"
#include "image/image.h"

namespace rotatebook::video {

/// Narrowest and lowest video: one macroblock. [pixels]
inline constexpr int kSmallestSide = 16;

/// Everything that the bytes of an MP4 depend on beside its pictures.
struct VideoSettings {
  int width = 1280;  ///< Even, at least kSmallestSide. [pixels]
  int height = 720;  ///< Even, at least kSmallestSide. [pixels]
  FrameRate frameRate;
  int crf = 18;                     ///< x264's constant rate factor, 1 (largest file) to 51.
  std::string preset = "veryfast";  ///< x264's preset.
  int threads = 1;                  ///< Encoder threads, >= 1. Another count gives other bytes.
  std::string title;                ///< Stored in the metadata; UTF-8.
  std::string comment;  ///< Stored in the metadata; UTF-8. rotatebook: the resolved scene.
};

/// Writes H.264 High, yuv420p, BT.709 (converted and tagged, limited range), `avc1`, index first
/// (faststart). Picture n gets the time stamp n in a 1/frame-rate time base. Same pictures, same
/// settings: same bytes.
class Mp4Writer {
 public:
  /// Opens `path` (the caller's temporary name; the container is MP4 whatever its extension).
  /// Throws InputError for settings out of range, MachineError where there is no H.264 encoder or
  /// the file can't be written.
  Mp4Writer(const std::filesystem::path& path, const VideoSettings& settings);
  Mp4Writer(Mp4Writer&&) noexcept;
  Mp4Writer& operator=(Mp4Writer&&) noexcept;
  ~Mp4Writer();

  /// Encodes the next picture (Rgb8 or Rgba8, alpha ignored). Throws InputError if its size isn't
  /// the settings', MachineError if it can't be encoded or written.
  void write(image::ImageView picture);

  /// Drains the encoder, writes the index and closes the file. Throws MachineError on any failed
  /// flush, trailer or close, and if there was no picture. Without it the file is unplayable; the
  /// destructor only frees.
  void finish();

  /// The encoder that was found, for example "libx264".
  const std::string& encoderName() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::video
