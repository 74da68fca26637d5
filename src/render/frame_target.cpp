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

void blit(const GlFramebuffer& from, const PixelRect& source, const GlFramebuffer& to,
          const PixelRect& place, GLenum filter) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.name());
  glBlitFramebuffer(source.x, source.y, source.x + source.width, source.y + source.height, place.x,
                    place.y, place.x + place.width, place.y + place.height, GL_COLOR_BUFFER_BIT,
                    filter);
}

}  // namespace

FrameTarget::FrameTarget(int width, int height, int samples, int supersample)
    : width_(width), height_(height), supersample_(supersample) {
  const int drawnWidth = supersample * width, drawnHeight = supersample * height;
  requireLimits(drawnWidth, drawnHeight, samples);
  allocate(sampledColour_, GL_SRGB8_ALPHA8, samples, drawnWidth, drawnHeight);
  allocate(sampledDepth_, GL_DEPTH_COMPONENT24, samples, drawnWidth, drawnHeight);
  allocate(resolvedColour_, GL_SRGB8_ALPHA8, 0, drawnWidth, drawnHeight);
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  attach(GL_COLOR_ATTACHMENT0, sampledColour_);
  attach(GL_DEPTH_ATTACHMENT, sampledDepth_);
  requireComplete();
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  attach(GL_COLOR_ATTACHMENT0, resolvedColour_);
  requireComplete();
  if (supersample == 1) return;
  allocate(pictureColour_, GL_SRGB8_ALPHA8, 0, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, picture_.name());
  attach(GL_COLOR_ATTACHMENT0, pictureColour_);
  requireComplete();
}

void FrameTarget::begin(const PixelRect& area) {
  const int scale = supersample_;
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  glViewport(0, 0, scale * width_, scale * height_);
  glEnable(GL_SCISSOR_TEST);
  glScissor(scale * area.x, scale * area.y, scale * area.width, scale * area.height);
  glEnable(GL_FRAMEBUFFER_SRGB);
}

void FrameTarget::readBack(const PixelRect& area, image::Image& picture) {
  const PixelRect drawn{supersample_ * area.x, supersample_ * area.y, supersample_ * area.width,
                        supersample_ * area.height};
  glDisable(GL_SCISSOR_TEST);
  blit(sampled_, drawn, resolved_, drawn, GL_NEAREST);
  // Halved, each pixel lies in the middle of four, which makes linear filtering their mean.
  if (supersample_ > 1) blit(resolved_, drawn, picture_, area, GL_LINEAR);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, supersample_ > 1 ? picture_.name() : resolved_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, width_);
  glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE,
               picture.row(area.y) + 4 * area.x);
}

}  // namespace rotatebook::render
