#include "render/frame_target.h"

#include <string>

#include "base/error.h"

namespace rotatebook::render {
namespace {

void allocate(const GlRenderbuffer& buffer, GLenum format, int samples, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
}

void attach(GLenum attachment, const GlRenderbuffer& buffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
}

void requireComplete() {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw MachineError("can't draw: OpenGL refuses the frame buffer (status " +
                       std::to_string(status) + ")");
  }
}

void requireLimits(int width, int height, int samples) {
  GLint largestSide = 0, mostSamples = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largestSide);
  glGetIntegerv(GL_MAX_SAMPLES, &mostSamples);
  if (width > largestSide || height > largestSide) {
    throw InputError("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                     " is too large: this renderer draws up to " + std::to_string(largestSide) +
                     " pixels a side");
  }
  if (samples > mostSamples) {
    throw MachineError("this renderer has no " + std::to_string(samples) +
                       "x multisampling, only " + std::to_string(mostSamples) + "x");
  }
}

}  // namespace

FrameTarget::FrameTarget(int width, int height, int samples) : width_(width), height_(height) {
  requireLimits(width, height, samples);
  allocate(sampledColour_, GL_SRGB8_ALPHA8, samples, width, height);
  allocate(sampledDepth_, GL_DEPTH_COMPONENT24, samples, width, height);
  allocate(resolvedColour_, GL_SRGB8_ALPHA8, 0, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  attach(GL_COLOR_ATTACHMENT0, sampledColour_);
  attach(GL_DEPTH_ATTACHMENT, sampledDepth_);
  requireComplete();
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  attach(GL_COLOR_ATTACHMENT0, resolvedColour_);
  requireComplete();
}

void FrameTarget::begin(const PixelRect& area) {
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  glViewport(0, 0, width_, height_);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.x, area.y, area.width, area.height);
  glEnable(GL_FRAMEBUFFER_SRGB);
}

void FrameTarget::readBack(const PixelRect& area, image::Image& picture) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
  const int right = area.x + area.width, bottom = area.y + area.height;
  glBlitFramebuffer(area.x, area.y, right, bottom, area.x, area.y, right, bottom,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, width_);
  glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE,
               picture.row(area.y) + 4 * area.x);
}

}  // namespace rotatebook::render
