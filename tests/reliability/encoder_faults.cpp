// FFmpeg's calls that encode and write a video.
#include <cerrno>
#include <dlfcn.h>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include "reliability/faults.h"

namespace {

/// FFmpeg's function, of the library that the program has loaded, or is linked to.
template <typename Function>
Function* ffmpegs(const char* name) {
  void* library = dlopen("libavformat.so." AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR), RTLD_LAZY);
  return reinterpret_cast<Function*>(dlsym(library, name));
}

/// Returns the result of the call, or an error of FFmpeg's.
template <typename Function, typename... Arguments>
int unlessFails(const char* name, Arguments... arguments) {
  if (rotatebook::faults::fails("encode")) return AVERROR(errno);
  return ffmpegs<Function>(name)(arguments...);
}

}  // namespace

extern "C" {

int avcodec_open2(AVCodecContext* context, const AVCodec* codec, AVDictionary** options) {
  return unlessFails<decltype(avcodec_open2)>("avcodec_open2", context, codec, options);
}

int avcodec_send_frame(AVCodecContext* context, const AVFrame* frame) {
  return unlessFails<decltype(avcodec_send_frame)>("avcodec_send_frame", context, frame);
}

int avcodec_receive_packet(AVCodecContext* context, AVPacket* packet) {
  return unlessFails<decltype(avcodec_receive_packet)>("avcodec_receive_packet", context, packet);
}

int avformat_write_header(AVFormatContext* context, AVDictionary** options) {
  return unlessFails<decltype(avformat_write_header)>("avformat_write_header", context, options);
}

int av_interleaved_write_frame(AVFormatContext* context, AVPacket* packet) {
  return unlessFails<decltype(av_interleaved_write_frame)>("av_interleaved_write_frame", context,
                                                           packet);
}

int av_write_trailer(AVFormatContext* context) {
  return unlessFails<decltype(av_write_trailer)>("av_write_trailer", context);
}

}  // extern "C"
