#include "picture/poster.h"

#include <algorithm>

#include "image/png_file.h"

namespace rotatebook::picture {

std::int64_t posterFrame(const scene::ClipSettings& clip, std::int64_t frames) {
  if (!clip.poster) return frames / 2;
  return std::min(clip.frameRate.framesIn(*clip.poster), frames - 1);
}

void writePoster(FrameDrawer& drawer, std::int64_t frame, bool transparent,
                 const std::filesystem::path& path) {
  image::Image picture = drawer.makePicture();
  drawer.draw(frame, picture);
  image::writePng(path, picture.view(), transparent);
}

}  // namespace rotatebook::picture
