#include "render/gl/frame_target.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::render {
namespace {

void allocate(const GlRenderbuffer& buffer, GLenum format, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
}

void attach(GLenum attachment, const GlRenderbuffer& buffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
}

void requireComplete(int width, int height) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw MachineError(
      fmt::format("can't draw: OpenGL refuses a frame buffer of {} pixels (status {}); make the "
                  "picture smaller, or leave out look.supersample",
                  sizeText(width, height), status));
}

void requireLimit(int width, int height) {
  GLint largestSide = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largestSide);
  if (width <= largestSide && height <= largestSide) return;
  throw InputError(
      fmt::format("a picture of {} is too large: this renderer draws up to {} pixels a side",
                  sizeText(width, height), largestSide));
}

}  // namespace

FrameTarget::FrameTarget(int width, int height, Pixels pixels)
    : width_(width), height_(height), pixels_(pixels) {
  requireLimit(width, height);
  allocate(colour_, pixels == Pixels::Exact ? GL_RGBA32F : GL_RGBA8, width, height);
  allocate(depth_, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, buffer_.name());
  attach(GL_COLOR_ATTACHMENT0, colour_);
  attach(GL_DEPTH_ATTACHMENT, depth_);
  requireComplete(width, height);
}

void FrameTarget::begin(const geometry::PixelRect& area) const {
  glBindFramebuffer(GL_FRAMEBUFFER, buffer_.name());
  glViewport(0, 0, width_, height_);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.x, area.y, area.width, area.height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FrameTarget::readBack(std::span<const geometry::PixelRect> areas,
                           image::Image& picture) const {
  readBack(areas, {0, 0, width_, height_}, picture);
}

void FrameTarget::readBack(std::span<const geometry::PixelRect> areas,
                           const geometry::PixelRect& cell, image::Image& picture) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, buffer_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, cell.width);
  for (const geometry::PixelRect& area : areas) {
    glReadPixels(cell.x + area.x, cell.y + area.y, area.width, area.height, GL_RGBA,
                 GL_UNSIGNED_BYTE, picture.row(area.y) + 4 * area.x);
  }
}

int FrameTarget::alphaAt(int x, int y) const {
  std::array<std::uint8_t, 4> pixel{};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, buffer_.name());
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return pixel[3];
}

std::string FrameTarget::bytes() const {
  const bool exact = pixels_ == Pixels::Exact;
  const std::size_t bytesPerPixel = exact ? 16 : 4;
  std::string bytes(bytesPerPixel * static_cast<std::size_t>(width_ * height_), '\0');
  glBindFramebuffer(GL_READ_FRAMEBUFFER, buffer_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, width_);
  glReadPixels(0, 0, width_, height_, GL_RGBA, exact ? GL_FLOAT : GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

}  // namespace rotatebook::render
