// H.264 packets in, an MP4 file out. Inside the room only.
#pragma once

#include <filesystem>
#include <string>

#include "video/ffmpeg.h"
#include "video/mp4_writer.h"

namespace rotatebook::video {

/// One `avc1` track in an MP4 whose index is moved to the front at the end. No clock time, no
/// version in the file.
class Mp4Muxer {
 public:
  /// Creates the file and writes its head. `encoder` is open. Throws MachineError.
  Mp4Muxer(const std::filesystem::path& path, const AVCodecContext& encoder,
           const VideoSettings& settings);

  /// Writes a packet with times in the encoder's time base, which it takes the content of. Throws
  /// MachineError.
  void write(AVPacket& packet);

  /// Writes the index, moves it to the front and closes the file. Throws MachineError.
  void finish();

 private:
  int checkFile(int result) const;

  std::string path_;
  AVRational encoderTimeBase_;
  Handle<AVFormatContext> context_;
};

}  // namespace rotatebook::video
