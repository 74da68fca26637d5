// Pictures in, a video out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "base/clip_limits.h"
#include "base/frame_rate.h"
#include "image/image.h"
#include "video/video_format.h"

namespace rotatebook::video {

/// Narrowest and lowest video: one macroblock. [pixels]
inline constexpr int kSmallestSide = 16;

/// Everything that the bytes of a video depend on beside its format and pictures.
struct VideoSettings {
  int width = 1280;  ///< At least kSmallestSide; even for MP4 and WebM. [pixels]
  int height = 720;  ///< As `width`. [pixels]
  FrameRate frameRate;
  bool transparent = false;         ///< Keep the pictures' alpha; WebM and APNG only.
  int crf = 18;                     ///< MP4: x264's constant rate factor, kBestCrf to kWorstCrf.
  std::string preset{kBookPreset};  ///< MP4: One of kVideoPresets.
  int threads = 1;    ///< MP4: encoder threads, >= 1. Another count gives other bytes.
  std::string title;  ///< Stored in the metadata of MP4 and WebM; UTF-8.
  std::string
      comment;  ///< Stored in the metadata of MP4 and WebM; UTF-8. rotatebook: the resolved scene.
};

/// Writes one video. Same pictures, same settings: same bytes. Picture n is shown at n/frame rate,
/// to the format's own resolution of time.
///
/// MP4: H.264 High, yuv420p, BT.709 (converted and tagged, limited range), `avc1`, index first
/// (faststart). WebM: VP9 of constant quality, yuv420p or yuva420p, BT.709 tagged. GIF: a palette
/// for each picture, dithered. APNG: lossless.
class VideoWriter {
 public:
  /// Opens `path` (the caller's temporary name, whatever its extension). Throws InputError for
  /// settings out of range, MachineError where there is no such encoder or the file can't be
  /// written.
  VideoWriter(VideoFormat format, const std::filesystem::path& path, const VideoSettings& settings);
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  ~VideoWriter();

  /// Encodes the next picture (Rgb8 or Rgba8; alpha is ignored unless the video is transparent).
  /// Throws InputError if its size isn't the settings', MachineError if it can't be encoded or
  /// written.
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

/// That of the FFmpeg libraries in use, for example "5.1.6".
std::string ffmpegVersion();

}  // namespace rotatebook::video
