// The one place where libpng's longjmp lands. Inside the room only.
#pragma once

#include <csetjmp>
#include <type_traits>

#include <png.h>

namespace rotatebook::image {

/// libpng's words about the failure; plain memory, so that a longjmp may pass it.
struct PngWords {
  char text[256] = "";
};

/// Error handler for png_create_*_struct with a PngWords as its pointer: keeps the words, jumps to
/// guarded().
[[noreturn]] void jumpWithWords(png_structp png, png_const_charp words);

/// Warning handler that says nothing: a picture that libpng can mend is no news for anybody.
void ignoreWarning(png_structp png, png_const_charp words);

/// Runs `body`, which calls libpng; false if libpng failed and jumped out of it. `body` must own
/// nothing: a longjmp over a destructor is undefined, which is why all that allocates stays
/// outside.
template <typename Body>
bool guarded(png_structp png, Body body) {
  static_assert(std::is_trivially_destructible_v<Body>);
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

}  // namespace rotatebook::image
