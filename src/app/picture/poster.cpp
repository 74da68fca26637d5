#include "picture/poster.h"

#include "image/png_file.h"

namespace rotatebook::picture {

void writePoster(FrameDrawer& drawer, std::int64_t frame, bool transparent,
                 const std::filesystem::path& path) {
  image::Image picture = drawer.makePicture();
  drawer.draw(frame, picture);
  image::writePng(path, picture.view(), transparent);
}

}  // namespace rotatebook::picture
