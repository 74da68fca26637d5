// Pictures as YUV4MPEG2 (Y4M), which programs that take video read from a pipe.
#pragma once

#include <memory>
#include <string>

#include "image/image.h"
#include "video/video_settings.h"

namespace rotatebook::video {

class PixelConverter;

/// Makes one stream, picture by picture. Its samples are those that an MP4 of the same pictures is
/// encoded from: yuv420p, BT.709, limited range, chroma sited left. The format has no word for the
/// matrix.
class Y4mStream {
 public:
  /// Takes size and frame rate alone. Throws InputError for an odd size, or one out of range.
  explicit Y4mStream(const VideoSettings& settings);
  ~Y4mStream();

  /// Returns the frame of the next picture, the first after the stream's header; valid until the
  /// next call. Ignores alpha. Throws InputError if the picture's size isn't the settings'.
  const std::string& next(image::ImageView picture);

 private:
  std::unique_ptr<PixelConverter> converter_;
  std::string bytes_;  ///< At first the header.
  bool isFirst_ = true;
};

}  // namespace rotatebook::video
