// Writes packets to a video file. Inside the room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "video/ffmpeg.h"
#include "video/stages.h"

namespace rotatebook::video {

/// Writes one track to a container. The file has no clock time, version or random number in it; an
/// MP4's index is moved to the front at the end.
class Muxer {
 public:
  /// Creates the file and writes its header, for the packets of `stages`. Throws MachineError.
  Muxer(const std::filesystem::path& path, VideoFormat format, const Stages& stages,
        const VideoSettings& settings);

  /// Writes a packet, with times in the encoder's time base, and takes over its content. Throws
  /// MachineError.
  void write(AVPacket& packet);

  /// Writes the chapters of an MP4 or a WebM and the index, which it moves to an MP4's front, and
  /// closes the file. Throws MachineError.
  void finish();

 private:
  int checkFile(int result) const;

  std::string path_;
  AVRational encoderTimeBase_;
  VideoFormat format_;
  Handle<AVFormatContext> context_;
  std::vector<Chapter> chapters_;
  FrameRate frameRate_;
  std::int64_t frames_ = 0;
};

}  // namespace rotatebook::video
