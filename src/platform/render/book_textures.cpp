#include "render/book_textures.h"

#include "embedded/render.h"
#include "image/png_file.h"

namespace rotatebook::render {

image::Image builtinFront() {
  return image::decodePng(frontPng(), "built-in front cover");
}
image::Image builtinSpine() {
  return image::decodePng(spinePng(), "built-in spine");
}
image::Image builtinBack() {
  return image::decodePng(backPng(), "built-in back cover");
}
image::Image builtinPaper() {
  return image::decodePng(paperPng(), "built-in paper");
}

image::Image plainCloth(const Rgb& colour) {
  image::Image pixel(1, 1, image::PixelFormat::Rgb8);
  const std::uint8_t parts[] = {colour.red, colour.green, colour.blue};
  for (int i = 0; i < 3; ++i) pixel.row(0)[i] = parts[i];
  return pixel;
}

}  // namespace rotatebook::render
