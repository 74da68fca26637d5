// Reduces pictures to few colours. Inside the room only.
#pragma once

#include <memory>

#include "video/rgb_converter.h"

namespace rotatebook::video {

struct FilterGraphDeleter {
  void operator()(AVFilterGraph* graph) const noexcept { avfilter_graph_free(&graph); }
};

/// Gives each picture its own palette of 255 colours and dithers it, by FFmpeg's palettegen and
/// paletteuse. Takes only every n-th picture. Memory doesn't grow with the number of pictures.
class PaletteConverter : public Converter {
 public:
  /// Takes one of `every` >= 1 pictures. `width`, `height`: [pixels]
  PaletteConverter(int width, int height, int every);

  void send(image::ImageView picture, std::int64_t number) override;
  void end() override;
  AVFrame* receive() override;

 private:
  int every_;
  RgbConverter rgb_;
  std::unique_ptr<AVFilterGraph, FilterGraphDeleter> graph_;
  AVFilterContext* source_ = nullptr;  // owned by the graph, as is the sink
  AVFilterContext* sink_ = nullptr;
  Handle<AVFrame> frame_;
};

}  // namespace rotatebook::video
