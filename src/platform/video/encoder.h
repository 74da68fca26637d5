// Frames in, packets out. Inside the room only.
#pragma once

#include <string>

#include "video/ffmpeg.h"
#include "video/video_format.h"
#include "video/video_settings.h"

namespace rotatebook::video {

class Encoder {
 public:
  /// Opens `context`, all set. `kind` says what it encodes to, for messages: "H.264". Throws
  /// MachineError if it doesn't start.
  Encoder(const std::string& kind, Handle<AVCodecContext> context, Dictionary& options);

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
  std::string words_;
  Handle<AVCodecContext> context_;
  Handle<AVPacket> packet_;
};

/// FFmpeg's encoder of that name. Throws MachineError, with the remedy, if it was built without.
const AVCodec& encoderNamed(const EncoderNeed& need);

/// A context for `encoder` with size, frame rate, threads and what makes its bytes the same each
/// time.
Handle<AVCodecContext> makeContext(const AVCodec& encoder, const VideoSettings& settings);

/// BT.709, limited range, chroma sited left.
void tagBt709(AVCodecContext& context);

/// Throws InputError for a size, rate or thread count that no format has.
void requireSizeAndRate(const VideoSettings& settings);
/// Throws InputError, naming the even sizes next to it, for a size that 4:2:0 colour can't have;
/// `codec` is its name.
void requireEvenSize(const VideoSettings& settings, const std::string& codec);

}  // namespace rotatebook::video
