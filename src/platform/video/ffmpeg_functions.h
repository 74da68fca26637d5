// FFmpeg's functions, under their names. Its libraries are loaded when the first is called: with
// all that they need they are 119, which took 31 of the 38 ms of a command that touches no video.
// Inside the room only.
#pragma once

#include <atomic>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavformat/avformat.h>
#include <libavutil/log.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace rotatebook::video {

/// The remedy where FFmpeg can't be loaded.
inline constexpr const char* kInstallFfmpeg =
    "install the version that the program was built with (Debian, Ubuntu: libavformat" AV_STRINGIFY(
        LIBAVFORMAT_VERSION_MAJOR) ", libswscale" AV_STRINGIFY(LIBSWSCALE_VERSION_MAJOR) ", "
    "libavfilter" AV_STRINGIFY(LIBAVFILTER_VERSION_MAJOR) ")";

/// Returns the address of a function of FFmpeg's. Throws MachineError, with the remedy, if its
/// library can't be loaded.
void* ffmpegAddress(const char* name);
/// Loads FFmpeg. Returns "can't load FFmpeg: " and the cause if that fails, else empty.
std::string ffmpegFailure();

template <typename Function>
class FfmpegFunction;

/// A function of FFmpeg's, found when it is first called.
template <typename Result, typename... Parameters>
class FfmpegFunction<Result (*)(Parameters...)> {
 public:
  constexpr explicit FfmpegFunction(const char* name) : name_(name) {}

  Result operator()(Parameters... parameters) {
    void* found = address_.load(std::memory_order_relaxed);
    if (found == nullptr) {
      found = ffmpegAddress(name_);
      address_.store(found, std::memory_order_relaxed);
    }
    return reinterpret_cast<Result (*)(Parameters...)>(found)(parameters...);
  }

 private:
  const char* name_;
  std::atomic<void*> address_{nullptr};
};

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"  // FFmpeg's "must check" and such.
#define ROTATEBOOK_FFMPEG(name) inline constinit FfmpegFunction<decltype(&::name)> name(#name)
ROTATEBOOK_FFMPEG(av_buffersink_get_frame);
ROTATEBOOK_FFMPEG(av_buffersrc_add_frame);
ROTATEBOOK_FFMPEG(av_buffersrc_add_frame_flags);
ROTATEBOOK_FFMPEG(av_color_primaries_name);
ROTATEBOOK_FFMPEG(av_color_range_name);
ROTATEBOOK_FFMPEG(av_color_space_name);
ROTATEBOOK_FFMPEG(av_color_transfer_name);
ROTATEBOOK_FFMPEG(av_dict_free);
ROTATEBOOK_FFMPEG(av_dict_get);
ROTATEBOOK_FFMPEG(av_dict_set);
ROTATEBOOK_FFMPEG(av_frame_alloc);
ROTATEBOOK_FFMPEG(av_frame_apply_cropping);
ROTATEBOOK_FFMPEG(av_frame_free);
ROTATEBOOK_FFMPEG(av_frame_get_buffer);
ROTATEBOOK_FFMPEG(av_frame_get_side_data);
ROTATEBOOK_FFMPEG(av_frame_make_writable);
ROTATEBOOK_FFMPEG(av_frame_side_data_name);
ROTATEBOOK_FFMPEG(av_frame_unref);
ROTATEBOOK_FFMPEG(av_free);
ROTATEBOOK_FFMPEG(av_freep);
ROTATEBOOK_FFMPEG(av_get_pix_fmt_name);
ROTATEBOOK_FFMPEG(av_interleaved_write_frame);
ROTATEBOOK_FFMPEG(av_log_set_callback);
ROTATEBOOK_FFMPEG(av_malloc);
ROTATEBOOK_FFMPEG(av_max_alloc);
ROTATEBOOK_FFMPEG(av_opt_set_int);
ROTATEBOOK_FFMPEG(av_packet_alloc);
ROTATEBOOK_FFMPEG(av_packet_free);
ROTATEBOOK_FFMPEG(av_packet_get_side_data);
ROTATEBOOK_FFMPEG(av_packet_rescale_ts);
ROTATEBOOK_FFMPEG(av_packet_side_data_name);
ROTATEBOOK_FFMPEG(av_packet_unref);
ROTATEBOOK_FFMPEG(av_read_frame);
ROTATEBOOK_FFMPEG(av_rescale_q);
ROTATEBOOK_FFMPEG(av_strdup);
ROTATEBOOK_FFMPEG(av_strerror);
ROTATEBOOK_FFMPEG(av_version_info);
ROTATEBOOK_FFMPEG(av_write_trailer);
ROTATEBOOK_FFMPEG(avcodec_alloc_context3);
ROTATEBOOK_FFMPEG(avcodec_find_decoder);
ROTATEBOOK_FFMPEG(avcodec_find_decoder_by_name);
ROTATEBOOK_FFMPEG(avcodec_find_encoder);
ROTATEBOOK_FFMPEG(avcodec_find_encoder_by_name);
ROTATEBOOK_FFMPEG(avcodec_free_context);
ROTATEBOOK_FFMPEG(avcodec_get_name);
ROTATEBOOK_FFMPEG(avcodec_open2);
ROTATEBOOK_FFMPEG(avcodec_parameters_from_context);
ROTATEBOOK_FFMPEG(avcodec_parameters_to_context);
ROTATEBOOK_FFMPEG(avcodec_profile_name);
ROTATEBOOK_FFMPEG(avcodec_receive_frame);
ROTATEBOOK_FFMPEG(avcodec_receive_packet);
ROTATEBOOK_FFMPEG(avcodec_send_frame);
ROTATEBOOK_FFMPEG(avcodec_send_packet);
ROTATEBOOK_FFMPEG(avfilter_get_by_name);
ROTATEBOOK_FFMPEG(avfilter_graph_alloc);
ROTATEBOOK_FFMPEG(avfilter_graph_config);
ROTATEBOOK_FFMPEG(avfilter_graph_create_filter);
ROTATEBOOK_FFMPEG(avfilter_graph_free);
ROTATEBOOK_FFMPEG(avfilter_graph_parse_ptr);
ROTATEBOOK_FFMPEG(avfilter_inout_alloc);
ROTATEBOOK_FFMPEG(avfilter_inout_free);
ROTATEBOOK_FFMPEG(avformat_alloc_context);
ROTATEBOOK_FFMPEG(avformat_alloc_output_context2);
ROTATEBOOK_FFMPEG(avformat_close_input);
ROTATEBOOK_FFMPEG(avformat_find_stream_info);
ROTATEBOOK_FFMPEG(avformat_free_context);
ROTATEBOOK_FFMPEG(avformat_new_stream);
ROTATEBOOK_FFMPEG(avformat_open_input);
ROTATEBOOK_FFMPEG(avformat_write_header);
ROTATEBOOK_FFMPEG(avio_alloc_context);
ROTATEBOOK_FFMPEG(avio_closep);
ROTATEBOOK_FFMPEG(avio_context_free);
ROTATEBOOK_FFMPEG(avio_open);
ROTATEBOOK_FFMPEG(sws_alloc_context);
ROTATEBOOK_FFMPEG(sws_freeContext);
ROTATEBOOK_FFMPEG(sws_getCoefficients);
ROTATEBOOK_FFMPEG(sws_init_context);
ROTATEBOOK_FFMPEG(sws_scale);
ROTATEBOOK_FFMPEG(sws_setColorspaceDetails);
#undef ROTATEBOOK_FFMPEG
#pragma GCC diagnostic pop

}  // namespace rotatebook::video
