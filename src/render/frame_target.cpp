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

void requireComplete(int width, int height, int samples) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw MachineError("can't draw: OpenGL refuses a frame buffer of " + std::to_string(width) + "x" +
                     std::to_string(height) + " pixels and " + std::to_string(samples) +
                     " samples (status " + std::to_string(status) +
                     "); make the picture smaller, or leave out look.supersample");
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

PixelRect scaled(const PixelRect& area, int scale) {
  return {scale * area.x, scale * area.y, scale * area.width, scale * area.height};
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
  // Light in 16 bits is as fine as sRGB's 8 where that is finest, and spares encoding each sample,
  // which took a tenth of drawing (software rasteriser).
  allocate(sampledColour_, GL_RGBA16, samples, drawnWidth, drawnHeight);
  allocate(sampledDepth_, GL_DEPTH_COMPONENT24, samples, drawnWidth, drawnHeight);
  allocate(resolvedColour_, GL_SRGB8_ALPHA8, 0, drawnWidth, drawnHeight);
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  attach(GL_COLOR_ATTACHMENT0, sampledColour_);
  attach(GL_DEPTH_ATTACHMENT, sampledDepth_);
  requireComplete(drawnWidth, drawnHeight, samples);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  attach(GL_COLOR_ATTACHMENT0, resolvedColour_);
  requireComplete(drawnWidth, drawnHeight, 1);
  if (supersample == 1) return;
  allocate(pictureColour_, GL_SRGB8_ALPHA8, 0, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, picture_.name());
  attach(GL_COLOR_ATTACHMENT0, pictureColour_);
  requireComplete(width, height, 1);
}

void FrameTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, sampled_.name());
  glViewport(0, 0, supersample_ * width_, supersample_ * height_);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
}

void FrameTarget::confineTo(const PixelRect& area) const {
  const PixelRect drawn = scaled(area, supersample_);
  glScissor(drawn.x, drawn.y, drawn.width, drawn.height);
}

void FrameTarget::readBack(std::span<const PixelRect> areas, image::Image& picture) {
  glDisable(GL_SCISSOR_TEST);
  for (const PixelRect& area : areas) {
    const PixelRect drawn = scaled(area, supersample_);
    blit(sampled_, drawn, resolved_, drawn, GL_NEAREST);
    // Halved, each pixel lies in the middle of four, which makes linear filtering their mean.
    if (supersample_ > 1) blit(resolved_, drawn, picture_, area, GL_LINEAR);
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, supersample_ > 1 ? picture_.name() : resolved_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, width_);
  for (const PixelRect& area : areas) {
    glReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.row(area.y) + 4 * area.x);
  }
}

}  // namespace rotatebook::render
