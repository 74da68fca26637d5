#include "video/recoder.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/error.h"
#include "video/clip_reader.h"
#include "video/muxer.h"
#include "video/stages.h"

namespace rotatebook::video {
namespace {

Handle<AVFrame> emptyFrame(const VideoSettings& settings) {
  Handle<AVFrame> frame = owned(av_frame_alloc());
  frame->format = AV_PIX_FMT_YUV420P;
  frame->width = settings.width;
  frame->height = settings.height;
  check(av_frame_get_buffer(frame.get(), 0), "can't allocate a picture");
  return frame;
}

/// Planes hold the stream's very bytes, as floats.
void copyPlane(const std::vector<float>& values, int width, AVFrame& frame, int plane) {
  std::uint8_t* row = frame.data[plane];
  for (std::size_t at = 0; at < values.size(); at += static_cast<std::size_t>(width)) {
    for (int x = 0; x < width; ++x) {
      row[x] = static_cast<std::uint8_t>(values[at + static_cast<std::size_t>(x)]);
    }
    row += frame.linesize[plane];
  }
}

void copyPicture(const Planes& picture, AVFrame& frame) {
  check(av_frame_make_writable(&frame), "can't allocate a picture");
  copyPlane(picture.y, picture.width, frame, 0);
  copyPlane(picture.u, picture.width / 2, frame, 1);
  copyPlane(picture.v, picture.width / 2, frame, 2);
}

}  // namespace

void recode(const std::filesystem::path& source, const std::filesystem::path& target,
            const VideoSettings& settings) {
  silenceFfmpeg();
  ClipReader reader(source);
  if (reader.facts().width != settings.width || reader.facts().height != settings.height) {
    throw InputError(source.string() + " has pictures of another size");
  }
  Stages stages = makeStages(VideoFormat::Mp4, settings);
  Muxer muxer(target, VideoFormat::Mp4, stages, settings);
  const auto encode = [&](AVFrame* frame) {
    stages.encoder.send(frame);
    while (AVPacket* packet = stages.encoder.receive()) muxer.write(*packet);
  };
  const Handle<AVFrame> frame = emptyFrame(settings);
  for (std::int64_t count = 0; reader.next(); ++count) {
    copyPicture(reader.picture(), *frame);
    frame->pts = count;
    encode(frame.get());
  }
  encode(nullptr);
  muxer.finish();
}

}  // namespace rotatebook::video
