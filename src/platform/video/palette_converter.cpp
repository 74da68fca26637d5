#include "video/palette_converter.h"

#include <string>

#include <fmt/core.h>

#include "base/text.h"

namespace rotatebook::video {
namespace {

constexpr const char* kFilters =
    "[in]split[a][b];[a]palettegen=stats_mode=single[p];"
    "[b][p]paletteuse=new=1:dither=sierra2_4a[out]";

struct InOutDeleter {
  void operator()(AVFilterInOut* list) const noexcept { avfilter_inout_free(&list); }
};
using InOut = std::unique_ptr<AVFilterInOut, InOutDeleter>;

InOut makeEnd(const char* name, AVFilterContext* filter) {
  InOut end(avfilter_inout_alloc());
  if (!end) throw std::bad_alloc();
  end->name = av_strdup(name);
  end->filter_ctx = filter;
  return end;
}

AVFilterContext* addFilter(AVFilterGraph* graph, const char* filter, const char* name,
                           const std::string& options) {
  AVFilterContext* context = nullptr;
  check(avfilter_graph_create_filter(&context, avfilter_get_by_name(filter), name, options.c_str(),
                                     nullptr, graph),
        std::string("FFmpeg's libavfilter has no ") + filter);
  return context;
}

void parse(AVFilterGraph* graph, AVFilterContext* source, AVFilterContext* sink) {
  // FFmpeg names both ends from outside the filters: the source's output is their input "in".
  AVFilterInOut* outputs = makeEnd("in", source).release();
  AVFilterInOut* inputs = makeEnd("out", sink).release();
  const int result = avfilter_graph_parse_ptr(graph, kFilters, &inputs, &outputs, nullptr);
  const InOut left(inputs);
  const InOut leftToo(outputs);
  check(result, "FFmpeg's libavfilter has no palette filters");
  check(avfilter_graph_config(graph, nullptr), "FFmpeg's libavfilter can't make palettes");
}

}  // namespace

PaletteConverter::PaletteConverter(int width, int height, int every)
    : every_(every),
      rgb_(width, height, false),
      graph_(avfilter_graph_alloc()),
      frame_(owned(av_frame_alloc())) {
  if (!graph_) throw std::bad_alloc();
  graph_->nb_threads = 1;
  source_ = addFilter(graph_.get(), "buffer", "in",
                      fmt::format("video_size={}:pix_fmt=rgb24:time_base=1/1:pixel_aspect=1/1",
                                  sizeText(width, height)));
  sink_ = addFilter(graph_.get(), "buffersink", "out", "");
  parse(graph_.get(), source_, sink_);
}

void PaletteConverter::send(image::ImageView picture, std::int64_t number) {
  if (number % every_ != 0) return;
  rgb_.send(picture, number / every_);
  check(av_buffersrc_add_frame_flags(source_, rgb_.receive(), AV_BUFFERSRC_FLAG_KEEP_REF),
        "can't make a picture's palette");
}

void PaletteConverter::end() {
  check(av_buffersrc_add_frame(source_, nullptr), "can't make the last picture's palette");
}

AVFrame* PaletteConverter::receive() {
  av_frame_unref(frame_.get());
  const int result = av_buffersink_get_frame(sink_, frame_.get());
  if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return nullptr;
  check(result, "can't make a picture's palette");
  frame_->pict_type = AV_PICTURE_TYPE_NONE;
  return frame_.get();
}

}  // namespace rotatebook::video
