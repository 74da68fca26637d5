// Encodes frames to packets. Inside the room only.
#pragma once

#include <string>

#include "video/ffmpeg.h"
#include "video/video_format.h"
#include "video/video_settings.h"

namespace rotatebook::video {

class Encoder {
 public:
  /// Opens `context`, whose fields are set. `kind` names its output in messages: "H.264". Throws
  /// MachineError if the encoder doesn't start.
  Encoder(const std::string& kind, Handle<AVCodecContext> context, Dictionary& options);

  /// Encodes `frame`, whose pts counts frames; nullptr reports that there are no more. Follow with
  /// receive() until it returns nullptr. Throws MachineError.
  void send(AVFrame* frame);

  /// Returns the next packet, valid until the next call; nullptr if the encoder needs more frames
  /// or has ended. Throws MachineError.
  AVPacket* receive();

  /// Returns the stream's codec parameters and time base, for the muxer.
  const AVCodecContext& context() const { return *context_; }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::string label_;
  Handle<AVCodecContext> context_;
  Handle<AVPacket> packet_;
};

/// Returns FFmpeg's encoder of that name. Throws MachineError, with the remedy, if there is none.
const AVCodec& encoderNamed(const EncoderNeed& need);

/// Makes a context for `encoder` with size, frame rate, threads and the flags that make its bytes
/// reproducible.
Handle<AVCodecContext> makeContext(const AVCodec& encoder, const VideoSettings& settings);

/// Tags `context` as BT.709, limited range, chroma sited left.
void tagBt709(AVCodecContext& context);

/// Throws InputError for a size, rate or thread count that no format supports.
void requireSizeAndRate(const VideoSettings& settings);
/// Throws InputError, naming the nearest even sizes, for an odd size, which 4:2:0 colour can't
/// have; `codec` is for the message.
void requireEvenSize(const VideoSettings& settings, const std::string& codec);

}  // namespace rotatebook::video
