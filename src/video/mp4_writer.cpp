#include "video/mp4_writer.h"

#include "base/error.h"
#include "video/h264_encoder.h"
#include "video/mp4_muxer.h"
#include "video/pixel_converter.h"

namespace rotatebook::video {

struct Mp4Writer::Parts {
  Parts(const std::filesystem::path& file, const VideoSettings& settings)
      : path(file),
        encoder(settings),
        converter(settings.width, settings.height),
        muxer(path, encoder.context(), settings) {}

  void encode(AVFrame* frame) {
    encoder.send(frame);
    while (AVPacket* packet = encoder.receive()) muxer.write(*packet);
  }

  std::filesystem::path path;
  H264Encoder encoder;
  PixelConverter converter;
  Mp4Muxer muxer;
  std::int64_t pictures = 0;
};

Mp4Writer::Mp4Writer(const std::filesystem::path& path, const VideoSettings& settings) {
  silenceFfmpeg();
  parts_ = std::make_unique<Parts>(path, settings);
}

Mp4Writer::Mp4Writer(Mp4Writer&&) noexcept = default;
Mp4Writer& Mp4Writer::operator=(Mp4Writer&&) noexcept = default;
Mp4Writer::~Mp4Writer() = default;

void Mp4Writer::write(image::ImageView picture) {
  AVFrame& frame = parts_->converter.convert(picture);
  frame.pts = parts_->pictures;
  parts_->encode(&frame);
  ++parts_->pictures;
}

void Mp4Writer::finish() {
  if (parts_->pictures == 0) {
    throw MachineError("can't write " + parts_->path.string() + ": a video needs a picture");
  }
  parts_->encode(nullptr);
  parts_->muxer.finish();
}

const std::string& Mp4Writer::encoderName() const {
  return parts_->encoder.name();
}

}  // namespace rotatebook::video
