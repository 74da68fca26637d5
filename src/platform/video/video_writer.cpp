#include "video/video_writer.h"

#include "base/error.h"
#include "system/program_mark.h"
#include "video/muxer.h"
#include "video/stages.h"

namespace rotatebook::video {

struct VideoWriter::Parts {
  Parts(VideoFormat format, const std::filesystem::path& file, const VideoSettings& settings)
      : path(file),
        row(rowOf(format)),
        stages(makeStages(format, settings)),
        muxer(path, format, stages, settings) {}

  /// Encodes and writes all frames that are ready.
  void encodeReady() {
    while (AVFrame* frame = stages.converter->receive()) encode(frame);
  }
  void encode(AVFrame* frame) {
    stages.encoder.send(frame);
    while (AVPacket* packet = stages.encoder.receive()) muxer.write(*packet);
  }

  std::filesystem::path path;
  const FormatRow& row;
  Stages stages;
  Muxer muxer;
  std::int64_t pictures = 0;
};

VideoWriter::VideoWriter(VideoFormat format, const std::filesystem::path& path,
                         const VideoSettings& settings) {
  silenceFfmpeg();
  parts_ = std::make_unique<Parts>(format, path, settings);
}

VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

void VideoWriter::write(image::ImageView picture) {
  parts_->stages.converter->send(picture, parts_->pictures);
  parts_->encodeReady();
  ++parts_->pictures;
}

void VideoWriter::finish() {
  if (parts_->pictures == 0) {
    throw MachineError("can't write " + parts_->path.string() + ": a video needs a picture");
  }
  parts_->stages.converter->end();
  parts_->encodeReady();
  parts_->encode(nullptr);
  parts_->muxer.finish();
  if (parts_->row.holdsRecord) return;
  parts_->row.isForEditors ? system::addProgramBox(parts_->path)
                           : system::addProgramMark(parts_->path);
}

const std::string& VideoWriter::encoderName() const {
  return parts_->stages.encoder.name();
}

std::string ffmpegVersion() {
  return av_version_info();
}

}  // namespace rotatebook::video
