#include "video/input_file.h"

#include <stdexcept>
#include <string>

namespace rotatebook::video::testing {
namespace {

Handle<AVCodecContext> openDecoder(const AVCodecParameters& parameters) {
  // FFmpeg's own decoder of VP9 leaves alpha out.
  const AVCodec* decoder = parameters.codec_id == AV_CODEC_ID_VP9
                               ? avcodec_find_decoder_by_name("libvpx-vp9")
                               : avcodec_find_decoder(parameters.codec_id);
  Handle<AVCodecContext> context = owned(avcodec_alloc_context3(decoder));
  check(avcodec_parameters_to_context(context.get(), &parameters), "can't set up the decoder");
  context->err_recognition = AV_EF_EXPLODE;
  check(avcodec_open2(context.get(), decoder, nullptr), "can't open the decoder");
  return context;
}

/// Takes what the decoder has ready.
void takeFrames(AVCodecContext& decoder, const std::function<void(const AVFrame&)>& ofFrame) {
  const Handle<AVFrame> frame = owned(av_frame_alloc());
  while (true) {
    const int result = avcodec_receive_frame(&decoder, frame.get());
    if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
    check(result, "can't decode");
    ofFrame(*frame);
  }
}

}  // namespace

InputFile openFile(const std::filesystem::path& path) {
  AVFormatContext* context = nullptr;
  const std::string url = "file:" + path.string();
  check(avformat_open_input(&context, url.c_str(), nullptr, nullptr), "can't open " + url);
  InputFile file(context);
  check(avformat_find_stream_info(context, nullptr), "can't probe " + url);
  if (context->nb_streams != 1) throw std::runtime_error("not one stream in " + url);
  return file;
}

void decode(const InputFile& file, const std::function<void(const AVPacket&)>& ofPacket,
            const std::function<void(const AVFrame&)>& ofFrame) {
  const Handle<AVCodecContext> decoder = openDecoder(*file->streams[0]->codecpar);
  const Handle<AVPacket> packet = owned(av_packet_alloc());
  while (av_read_frame(file.get(), packet.get()) >= 0) {
    ofPacket(*packet);
    check(avcodec_send_packet(decoder.get(), packet.get()), "can't decode");
    av_packet_unref(packet.get());
    takeFrames(*decoder, ofFrame);
  }
  check(avcodec_send_packet(decoder.get(), nullptr), "can't end decoding");
  takeFrames(*decoder, ofFrame);
}

}  // namespace rotatebook::video::testing
