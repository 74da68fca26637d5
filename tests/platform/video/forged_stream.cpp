#include "video/forged_stream.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

extern "C" {
#include <libavcodec/bsf.h>
}

#include "video/muxer.h"
#include "video/pixel_converter.h"
#include "video/test_clip.h"

namespace rotatebook::video::testing {
namespace {

struct FilterCloser {
  void operator()(AVBSFContext* context) const noexcept { av_bsf_free(&context); }
};
using Filter = std::unique_ptr<AVBSFContext, FilterCloser>;

Encoder openEncoder(const VideoSettings& settings, const std::string& x264Params) {
  Handle<AVCodecContext> context = makeContext(encoderNamed({"libx264", ""}), settings);
  context->pix_fmt = AV_PIX_FMT_YUV420P;
  context->profile = kProfileHigh;
  tagBt709(*context);
  Dictionary options;
  options.set("x264-params", x264Params);
  return {"H.264", std::move(context), options};
}

Filter openFilter(const std::string& text, const AVCodecContext& encoder) {
  AVBSFContext* context = nullptr;
  check(av_bsf_list_parse_str(text.c_str(), &context), "no filter " + text);
  Filter filter(context);
  check(avcodec_parameters_from_context(context->par_in, &encoder), "can't describe the stream");
  context->time_base_in = encoder.time_base;
  check(av_bsf_init(context), "can't open " + text);
  return filter;
}

}  // namespace

std::string forgedParameters(const std::string& x264Params, const std::string& filterText) {
  const Encoder encoder = openEncoder(smallSettings(), x264Params);
  const Filter filter = openFilter(filterText, encoder.context());
  const AVCodecParameters& codec = *filter->par_out;
  const std::string bytes(reinterpret_cast<const char*>(codec.extradata),
                          static_cast<std::size_t>(codec.extradata_size));
  const std::string start("\0\0\0\1", 4);
  const std::size_t second = bytes.find(start, start.size());
  const std::string sequence = bytes.substr(start.size(), second - start.size());
  const std::string picture = bytes.substr(second + start.size());
  const auto sized = [](const std::string& unit) {
    return std::string{static_cast<char>(unit.size() >> 8), static_cast<char>(unit.size() & 0xff)} +
           unit;
  };
  return "\1" + sequence.substr(1, 3) + "\xff\xe1" + sized(sequence) + "\1" + sized(picture) +
         std::string("\xfd\xf8\xf8\0", 4);
}

void writeChangedStream(const std::filesystem::path& path, VideoFormat format,
                        const std::function<void(std::string& packet, int index)>& change) {
  constexpr int kPictures = 5;
  VideoSettings settings = smallSettings();
  settings.comment = "# a record";
  Stages stages = makeStages(format, settings);
  Muxer muxer(path, format, stages, settings);
  PixelConverter converter(settings.width, settings.height);
  const Handle<AVPacket> changed = owned(av_packet_alloc());
  int index = 0;
  const auto drain = [&] {
    while (AVPacket* packet = stages.encoder.receive()) {
      std::string bytes(reinterpret_cast<const char*>(packet->data),
                        static_cast<std::size_t>(packet->size));
      change(bytes, index++);
      check(av_new_packet(changed.get(), static_cast<int>(bytes.size())), "no memory");
      std::copy(bytes.begin(), bytes.end(), changed->data);
      check(av_packet_copy_props(changed.get(), packet), "no memory");
      muxer.write(*changed);
    }
  };
  for (int n = 0; n < kPictures; ++n) {
    AVFrame& frame = converter.convert(barPicture(n).view());
    frame.pts = n;
    stages.encoder.send(&frame);
    drain();
  }
  stages.encoder.send(nullptr);
  drain();
  muxer.finish();
}

void writeForgedStream(const std::filesystem::path& path, const std::string& x264Params,
                       const std::string& filterText, const std::string& laterFilter) {
  constexpr int kPictures = 5;
  const VideoSettings settings = smallSettings();
  PixelConverter converter(settings.width, settings.height);
  Stages stages{nullptr, openEncoder(settings, x264Params)};
  Filter filter = openFilter(filterText, stages.encoder.context());
  Muxer muxer(path, VideoFormat::Mp4, stages, settings);
  const auto drain = [&] {
    while (AVPacket* packet = stages.encoder.receive()) {
      const bool isLater = packet->pts > 0 && (packet->flags & AV_PKT_FLAG_KEY) != 0;
      if (isLater && !laterFilter.empty()) {
        filter = openFilter(laterFilter, stages.encoder.context());
      }
      check(av_bsf_send_packet(filter.get(), packet), "can't filter");
      check(av_bsf_receive_packet(filter.get(), packet), "can't filter");
      muxer.write(*packet);
    }
  };
  for (int n = 0; n < kPictures; ++n) {
    AVFrame& frame = converter.convert(barPicture(n).view());
    frame.pts = n;
    stages.encoder.send(&frame);
    drain();
  }
  stages.encoder.send(nullptr);
  drain();
  muxer.finish();
}

}  // namespace rotatebook::video::testing
