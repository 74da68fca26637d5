#include "render/renderer.h"

#include <optional>

#include "base/error.h"
#include "image/png_file.h"
#include "render/blank_area.h"
#include "render/book_geometry.h"
#include "render/egl_context.h"
#include "render/embedded_files.h"
#include "render/frame_target.h"
#include "render/shader_program.h"
#include "render/straight_alpha.h"
#include "render/texture.h"

namespace rotatebook::render {
namespace {

constexpr float kClothGloss = 1;
constexpr float kPaperGloss = 0;

void requireNoGlError(const char* when) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  throw MachineError("can't draw: OpenGL error " + std::to_string(error) + " " + when);
}

}  // namespace

image::Image builtinFront() {
  return image::decodePng(frontPng(), "built-in front cover");
}
image::Image builtinSpine() {
  return image::decodePng(spinePng(), "built-in spine");
}
image::Image builtinBack() {
  return image::decodePng(backPng(), "built-in back cover");
}

struct Renderer::Parts {
  Parts(const RenderSettings& renderSettings, const BookTextures& textures)
      : settings(renderSettings),
        target(settings.width, settings.height, settings.samples, settings.supersample),
        backdropProgram("backdrop", wholePictureVertexShader(), backdropFragmentShader()),
        bookProgram("book", bookVertexShader(), bookFragmentShader()),
        front(textures.front.view(), TextureWrap::Clamp),
        spine(textures.spine.view(), TextureWrap::Clamp),
        back(textures.back.view(), TextureWrap::Clamp),
        paper(image::decodePng(paperPng(), "built-in paper").view(), TextureWrap::Repeat),
        background(settings.width, settings.height, image::PixelFormat::Rgba8) {
    if (settings.background != Background::Transparent) drawBackground();
    backdrop.emplace(background.view());
    requireNoGlError("while setting up");
  }

  void drawBackground() {
    const bool studio = settings.background == Background::Studio;
    const ShaderProgram program(studio ? "studio" : "stars", wholePictureVertexShader(),
                                studio ? studioFragmentShader() : starsFragmentShader());
    const PixelRect everything{0, 0, settings.width, settings.height};
    target.begin();
    glDisable(GL_FRAMEBUFFER_SRGB);  // Its colours are encoded already.
    target.confineTo(everything);
    program.use();
    const Eigen::Vector2i size(settings.width, settings.height);
    program.set("pictureSize", Eigen::Vector2f(size.cast<float>()));
    program.set("supersample", settings.supersample);
    coverPicture();
    target.readBack({&everything, 1}, background);
  }

  /// Draws over the whole picture, infinitely far away, with the program in use. Setting the depth
  /// on the way spares clearing it, which costs as much as drawing (software rasteriser, 4
  /// samples).
  void coverPicture() const {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(noVertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  void drawBackdrop(const std::vector<PixelRect>& bands) const {
    backdropProgram.use();
    backdropProgram.set("supersample", settings.supersample);
    backdrop->bind();
    for (const PixelRect& band : bands) {
      target.confineTo(band);
      coverPicture();
    }
  }

  void drawBook(const physics::Corners& corners, const Projection& projection) const {
    glDepthFunc(GL_LESS);
    const bool hidden = hideInnerSides(corners);
    bookProgram.use();
    bookProgram.set("corners", Eigen::Matrix<float, 3, 8>(corners.cast<float>()));
    bookProgram.set("clipFromWorld", Eigen::Matrix4f(projection.clipFromWorld.cast<float>()));
    bookProgram.set("eye", Eigen::Vector3f(settings.camera.position.cast<float>()));
    geometry.bind();
    drawPart(BookPart::Front, front, kClothGloss);
    drawPart(BookPart::Spine, spine, kClothGloss);
    drawPart(BookPart::Back, back, kClothGloss);
    drawPart(BookPart::Pages, paper, kPaperGloss);
    // Even what is hidden takes as long to draw as what is seen (software rasteriser, 4 samples).
    if (!hidden) drawPart(BookPart::Lining, front, kClothGloss);
  }

  void drawPart(BookPart part, const Texture& texture, float gloss) const {
    bookProgram.set("gloss", gloss);
    texture.bind();
    geometry.draw(part);
  }

  RenderSettings settings;
  EglContext context;  // First made, last destroyed of all that needs it.
  FrameTarget target;
  ShaderProgram backdropProgram, bookProgram;
  BookGeometry geometry;
  GlVertexArray noVertices;
  Texture front, spine, back, paper;
  std::optional<PixelTexture> backdrop;  // The same picture as `background`.
  image::Image background;               // What every pixel shows that the book doesn't touch.
};

Renderer::Renderer(const RenderSettings& settings, const BookTextures& textures)
    : parts_(std::make_unique<Parts>(settings, textures)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

image::Image Renderer::makePicture() const {
  return {parts_->settings.width, parts_->settings.height, image::PixelFormat::Rgba8};
}

void Renderer::draw(const physics::Corners& corners, image::Image& picture) {
  const RenderSettings& settings = parts_->settings;
  const Projection projection =
      project(settings.camera, corners, {settings.width, settings.height, settings.bottomRows});
  picture = parts_->background;
  const PixelRect& area = projection.bounds;
  if (area.width > 0 && area.height > 0) {
    parts_->target.begin();
    parts_->drawBackdrop(projection.bands);
    parts_->target.confineTo(area);
    parts_->drawBook(corners, projection);
    parts_->target.readBack(projection.bands, picture);
    if (settings.background == Background::Transparent) makeAlphaStraight(picture, area);
  }
  requireNoGlError("while drawing a frame");
  if (isBlank(picture, area)) {
    throw MachineError("the renderer " + description() +
                       " gave a blank frame; its driver is broken or too old");
  }
}

const std::string& Renderer::description() const {
  return parts_->context.description();
}

}  // namespace rotatebook::render
