#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/error.h"
#include "embedded/render.h"
#include "geometry/book_mesh.h"
#include "image/png_file.h"
#include "render/book/book_geometry.h"
#include "render/book/frame_target.h"
#include "render/book/shader_program.h"
#include "render/book/texture.h"
#include "render/device/egl_context.h"

namespace rotatebook::render {
namespace {

void requireNoGlError(const char* when) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  throw MachineError("can't draw: OpenGL error " + std::to_string(error) + " " + when);
}

/// Returns a book so close that its front cover covers the middle of pictures of every size.
DrawnBody closeBook(int width, int height) {
  const geometry::Camera close{.position = {0, 0, 0.1}};
  DrawnBody body{.pixels = {}, .cage = physics::Cuboid{}.corners()};
  body.clipFromWorld = geometry::project(close, body.cage, {width, height, 0}).clipFromWorld;
  body.winding = frontFaceWinding(body.cage);
  return body;
}

/// Fills an opaque picture.
void paint(const Rgb& colour, image::Image& picture) {
  const std::array<std::uint8_t, 4> pixel{colour.red, colour.green, colour.blue, 255};
  const auto size = static_cast<std::ptrdiff_t>(image::bytesPerPixel(picture.format()));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      std::copy_n(pixel.begin(), size, picture.row(y) + size * x);
    }
  }
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

image::Image plainCloth(const Rgb& colour) {
  image::Image pixel(1, 1, image::PixelFormat::Rgb8);
  paint(colour, pixel);
  return pixel;
}

struct Renderer::Parts {
  Parts(const RenderSettings& renderSettings, const BookTextures& textures,
        const geometry::Mesh& mesh)
      : settings(renderSettings),
        width(settings.supersample * settings.width),
        height(settings.supersample * settings.height),
        context(settings.device),
        target(width, height),
        coverProgram("cover", {studioLights(), bookVertexShader()},
                     {{studioLights(), coverFragmentShader()}, toneCurveFragmentShader()}),
        paperProgram("paper", {studioLights(), bookVertexShader()},
                     {paperFragmentShader(), toneCurveFragmentShader()}),
        geometry(mesh),
        stripFinder(mesh),
        stripTarget(DrawnStrips::kColumns, static_cast<int>(stripFinder.count())),
        front(textures.front.view(), TextureWrap::Clamp),
        spine(textures.spine.view(), TextureWrap::Clamp),
        back(textures.back.view(), TextureWrap::Clamp),
        paper(image::decodePng(paperPng(), "built-in paper").view(), TextureWrap::Repeat),
        compositor(background(), settings.supersample, mesh) {
    requireDrawing();
    requireNoGlError("while setting up");
  }

  /// Throws MachineError if the driver draws nothing, as some do without an error. Uses the frames'
  /// own shaders, state and buffer, so that the first frame reuses all that is compiled for it.
  void requireDrawing() const {
    const geometry::PixelRect middle{width / 2, height / 2, 1, 1};
    target.begin(middle);
    drawBody(closeBook(width, height));
    const int drawn = target.alphaAt(middle.x, middle.y);
    target.begin(middle);
    const int cleared = target.alphaAt(middle.x, middle.y);
    if (drawn != 0 && cleared == 0) return;
    throw MachineError("can't draw: " + context.description() +
                       " reports no error and draws nothing: a pixel within the book has alpha " +
                       std::to_string(drawn) + " when drawn and " + std::to_string(cleared) +
                       " when cleared; choose another device with --device" + kDoctorHint);
  }

  image::Image background() const {
    image::Image picture(width, height, image::PixelFormat::Rgba8);
    if (settings.background == Background::Plain) {
      paint(settings.plainColour, picture);
    } else if (settings.background != Background::Transparent) {
      drawBackground(picture);
    }
    return picture;
  }

  void drawBackground(image::Image& picture) const {
    const bool studio = settings.background == Background::Studio;
    const ShaderProgram backdrop(studio ? "studio" : "stars", wholePictureVertexShader(),
                                 {studio ? studioFragmentShader() : starsFragmentShader()});
    const geometry::PixelRect everything{0, 0, width, height};
    target.begin(everything);
    glDisable(GL_FRAMEBUFFER_SRGB);  // The shaders' colours are encoded already.
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    backdrop.use();
    const Eigen::Vector2i size(settings.width, settings.height);
    backdrop.set("pictureSize", Eigen::Vector2f(size.cast<float>()));
    backdrop.set("supersample", settings.supersample);
    const GlVertexArray noVertices;
    glBindVertexArray(noVertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    target.readBack({&everything, 1}, picture);
  }

  void drawBody(const DrawnBody& drawn) const {
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
    drawn.winding == 0 ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
    glFrontFace(drawn.winding < 0 ? GL_CW : GL_CCW);
    geometry.bind();
    use(coverProgram, drawn);
    coverProgram.set("eye", Eigen::Vector3f(settings.camera.position.cast<float>()));
    drawCover(geometry::BookPart::Front, front);
    drawCover(geometry::BookPart::Spine, spine);
    drawCover(geometry::BookPart::Back, back);
    if (drawn.winding == 0) drawCover(geometry::BookPart::Lining, front);
    use(paperProgram, drawn);
    drawPart(geometry::BookPart::Pages, paper);
  }

  /// Relies on the OpenGL state that drawBody() leaves.
  void drawStrips(DrawnBody& drawn) const {
    image::Image& colours = drawn.strips.colours;
    const geometry::PixelRect all{0, 0, colours.width(), colours.height()};
    stripTarget.begin(all);
    geometry.bindStrips();
    drawStripsOf(geometry::BookPart::Pages, paper, drawn);
    coverProgram.use();
    drawCoverStrips(geometry::BookPart::Front, front, drawn);
    drawCoverStrips(geometry::BookPart::Spine, spine, drawn);
    drawCoverStrips(geometry::BookPart::Back, back, drawn);
    stripTarget.readBack({&all, 1}, colours);
  }

  void drawStripsOf(geometry::BookPart part, const Texture& texture, const DrawnBody& drawn) const {
    texture.bind();
    geometry.drawStrips(part, drawn.strips.onScreen);
  }

  void drawCoverStrips(geometry::BookPart part, const Texture& texture,
                       const DrawnBody& drawn) const {
    coverProgram.set("plainCloth", texture.isPlain() ? 1 : 0);
    drawStripsOf(part, texture, drawn);
  }

  void use(const ShaderProgram& program, const DrawnBody& drawn) const {
    program.use();
    program.set("cage", Eigen::Matrix<float, 3, 8>(drawn.cage.cast<float>()));
    program.set("clipFromWorld", Eigen::Matrix4f(drawn.clipFromWorld.cast<float>()));
  }

  void drawCover(geometry::BookPart part, const Texture& texture) const {
    coverProgram.set("plainCloth", texture.isPlain() ? 1 : 0);
    drawPart(part, texture);
  }

  void drawPart(geometry::BookPart part, const Texture& texture) const {
    texture.bind();
    geometry.draw(part);
  }

  RenderSettings settings;
  int width, height;   // Of the drawing. [pixels]
  EglContext context;  // Before all that needs it, so that it is destroyed last.
  FrameTarget target;
  ShaderProgram coverProgram, paperProgram;
  BookGeometry geometry;
  StripFinder stripFinder;
  FrameTarget stripTarget;
  Texture front, spine, back, paper;
  Compositor compositor;
  std::optional<DrawnBody> body;  // For draw() to a picture.
};

Renderer::Renderer(const RenderSettings& settings, const BookTextures& textures)
    : parts_(std::make_unique<Parts>(settings, textures, geometry::makeBookMesh())) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::setCamera(const geometry::Camera& camera) {
  parts_->settings.camera = camera;
}

DrawnBody Renderer::makeBody() const {
  DrawnBody body{.pixels = {parts_->width, parts_->height, image::PixelFormat::Rgba8}};
  body.strips.colours = {DrawnStrips::kColumns, static_cast<int>(parts_->stripFinder.count()),
                         image::PixelFormat::Rgba8};
  return body;
}

Compositor& Renderer::compositor() {
  return parts_->compositor;
}

image::Image Renderer::makePicture() const {
  return parts_->compositor.makePicture();
}

void Renderer::draw(const physics::Cage& cage, image::Image& picture) {
  if (!parts_->body) parts_->body = makeBody();
  draw(cage, *parts_->body);
  parts_->compositor.compose(*parts_->body, picture);
}

void Renderer::draw(const physics::Cage& cage, DrawnBody& body) {
  const RenderSettings& settings = parts_->settings;
  geometry::Projection projection = geometry::project(
      settings.camera, cage,
      {parts_->width, parts_->height, settings.supersample * settings.bottomRows});
  const geometry::PixelRect& area = projection.bounds;
  body.cage = cage;
  body.clipFromWorld = projection.clipFromWorld;
  body.winding = frontFaceWinding(cage);
  body.bands = std::move(projection.bands);
  parts_->stripFinder.find(cage, body.clipFromWorld, body.winding, {parts_->width, parts_->height},
                           body.strips.onScreen);
  if (area.width <= 0 || area.height <= 0) return body.bands.clear();
  parts_->target.begin(area);
  parts_->drawBody(body);
  parts_->drawStrips(body);
  parts_->target.readBack(body.bands, body.pixels);
  requireNoGlError("while drawing a frame");
}

const std::string& Renderer::description() const {
  return parts_->context.description();
}

}  // namespace rotatebook::render
