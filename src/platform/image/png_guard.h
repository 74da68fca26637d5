// Error handling for libpng: the one place where its longjmp lands. Inside the room only.
#pragma once

#include <csetjmp>
#include <type_traits>

#include <png.h>

namespace rotatebook::image {

/// libpng's message about a failure; plain memory, so that a longjmp may pass it.
struct PngMessage {
  char text[256] = "";
};

/// Error handler for png_create_*_struct with a PngMessage as its pointer: stores the message and
/// jumps to guarded().
[[noreturn]] void jumpWithMessage(png_structp png, png_const_charp message);

/// Warning handler that reports nothing: pictures that libpng can fix don't concern the user.
void ignoreWarning(png_structp png, png_const_charp message);

/// Runs `body`, which calls libpng; returns false if libpng failed and jumped out of it. `body`
/// must own nothing: a longjmp over a destructor is undefined, so whatever allocates stays outside.
template <typename Body>
bool guarded(png_structp png, Body body) {
  static_assert(std::is_trivially_destructible_v<Body>);
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

}  // namespace rotatebook::image
