#include "image/png_guard.h"

#include <cstdio>

namespace rotatebook::image {

void jumpWithWords(png_structp png, png_const_charp words) {
  auto* kept = static_cast<PngWords*>(png_get_error_ptr(png));
  std::snprintf(kept->text, sizeof kept->text, "%s", words);
  png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

}  // namespace rotatebook::image
