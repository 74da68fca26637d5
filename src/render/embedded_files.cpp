#include "render/embedded_files.h"

// The symbols come from cmake/embed.cmake.
#define ROTATEBOOK_EMBEDDED(symbol) \
  extern "C" const char embedded_##symbol##_begin[], embedded_##symbol##_end[]

ROTATEBOOK_EMBEDDED(whole_picture_vert);
ROTATEBOOK_EMBEDDED(studio_frag);
ROTATEBOOK_EMBEDDED(stars_frag);
ROTATEBOOK_EMBEDDED(book_vert);
ROTATEBOOK_EMBEDDED(cover_frag);
ROTATEBOOK_EMBEDDED(paper_frag);
ROTATEBOOK_EMBEDDED(tone_curve_frag);
ROTATEBOOK_EMBEDDED(front_png);
ROTATEBOOK_EMBEDDED(spine_png);
ROTATEBOOK_EMBEDDED(back_png);
ROTATEBOOK_EMBEDDED(paper_png);
ROTATEBOOK_EMBEDDED(test_frame_png);

namespace rotatebook::render {
namespace {

std::string_view text(const char* begin, const char* end) {
  return {begin, end};
}

std::span<const std::uint8_t> bytes(const char* begin, const char* end) {
  return {reinterpret_cast<const std::uint8_t*>(begin), reinterpret_cast<const std::uint8_t*>(end)};
}

}  // namespace

std::string_view wholePictureVertexShader() {
  return text(embedded_whole_picture_vert_begin, embedded_whole_picture_vert_end);
}
std::string_view studioFragmentShader() {
  return text(embedded_studio_frag_begin, embedded_studio_frag_end);
}
std::string_view starsFragmentShader() {
  return text(embedded_stars_frag_begin, embedded_stars_frag_end);
}
std::string_view bookVertexShader() {
  return text(embedded_book_vert_begin, embedded_book_vert_end);
}
std::string_view coverFragmentShader() {
  return text(embedded_cover_frag_begin, embedded_cover_frag_end);
}
std::string_view paperFragmentShader() {
  return text(embedded_paper_frag_begin, embedded_paper_frag_end);
}
std::string_view toneCurveFragmentShader() {
  return text(embedded_tone_curve_frag_begin, embedded_tone_curve_frag_end);
}

std::span<const std::uint8_t> frontPng() {
  return bytes(embedded_front_png_begin, embedded_front_png_end);
}
std::span<const std::uint8_t> spinePng() {
  return bytes(embedded_spine_png_begin, embedded_spine_png_end);
}
std::span<const std::uint8_t> backPng() {
  return bytes(embedded_back_png_begin, embedded_back_png_end);
}
std::span<const std::uint8_t> paperPng() {
  return bytes(embedded_paper_png_begin, embedded_paper_png_end);
}
std::span<const std::uint8_t> testFramePng() {
  return bytes(embedded_test_frame_png_begin, embedded_test_frame_png_end);
}

}  // namespace rotatebook::render
