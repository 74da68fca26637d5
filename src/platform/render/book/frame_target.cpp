#include "render/book/frame_target.h"

#include <array>
#include <cstdint>
#include <string>

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
  throw MachineError("can't draw: OpenGL refuses a frame buffer of " + sizeText(width, height) +
                     " pixels (status " + std::to_string(status) +
                     "); make the picture smaller, or leave out look.supersample");
}

void requireLimit(int width, int height) {
  GLint largestSide = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largestSide);
  if (width <= largestSide && height <= largestSide) return;
  throw InputError("a picture of " + sizeText(width, height) +
                   " is too large: this renderer draws up to " + std::to_string(largestSide) +
                   " pixels a side");
}

}  // namespace

FrameTarget::FrameTarget(int width, int height) : width_(width), height_(height) {
  requireLimit(width, height);
  allocate(colour_, GL_SRGB8_ALPHA8, width, height);
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
  glBindFramebuffer(GL_READ_FRAMEBUFFER, buffer_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, width_);
  for (const geometry::PixelRect& area : areas) {
    glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.row(area.y) + 4 * area.x);
  }
}

int FrameTarget::alphaAt(int x, int y) const {
  std::array<std::uint8_t, 4> pixel{};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, buffer_.name());
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return pixel[3];
}

}  // namespace rotatebook::render
