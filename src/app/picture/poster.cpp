#include "picture/poster.h"

#include <algorithm>
#include <string>

#include "image/png_file.h"
#include "system/atomic_file.h"
#include "system/program_mark.h"

namespace rotatebook::picture {

std::int64_t posterFrame(const scene::ClipSettings& clip, std::int64_t frames) {
  if (!clip.poster) return frames / 2;
  return std::min(clip.frameRate.framesIn(*clip.poster), frames - 1);
}

void writePoster(FrameDrawer& drawer, std::int64_t frame, bool transparent,
                 const std::filesystem::path& path) {
  image::Image picture = drawer.makePicture();
  drawer.draw(frame, picture);
  std::string bytes = image::PngWriter(transparent).encode(picture.view(), path.string());
  system::addProgramMark(bytes);
  system::writeFileAtomically(path, bytes);
}

}  // namespace rotatebook::picture
