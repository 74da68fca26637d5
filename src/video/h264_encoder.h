// YUV frames in, H.264 packets out. Inside the room only.
#pragma once

#include <string>

#include "video/ffmpeg.h"
#include "video/mp4_writer.h"

namespace rotatebook::video {

/// The best H.264 encoder that FFmpeg was built with: libx264, else the next. High profile,
/// yuv420p, a key frame every two seconds at most.
class H264Encoder {
 public:
  /// Throws InputError for a size, crf, preset or thread count out of range, MachineError where
  /// there is no H.264 encoder or it doesn't start.
  explicit H264Encoder(const VideoSettings& settings);

  /// Encodes `frame`, whose pts counts frames; nullptr says that there are no more. Follow with
  /// receive() until it is empty. Throws MachineError.
  void send(AVFrame* frame);

  /// The next finished packet, valid until the next call; nullptr if the encoder wants more frames
  /// or has ended. Throws MachineError.
  AVPacket* receive();

  /// What the muxer needs to know about the stream: codec parameters and time base.
  const AVCodecContext& context() const { return *context_; }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  Handle<AVCodecContext> context_;
  Handle<AVPacket> packet_;
};

}  // namespace rotatebook::video
