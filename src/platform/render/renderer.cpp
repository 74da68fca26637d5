#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/checksum.h"
#include "base/error.h"
#include "embedded/render.h"
#include "geometry/book_mesh.h"
#include "image/png_file.h"
#include "render/book/book_geometry.h"
#include "render/book/cells.h"
#include "render/book/frame_target.h"
#include "render/book/shader_program.h"
#include "render/book/texture.h"
#include "render/device/egl_context.h"

namespace rotatebook::render {
namespace {

void requireNoGlError(const char* when) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  throw MachineError("can't draw: OpenGL error " + std::to_string(error) + " " + when,
                     error == GL_OUT_OF_MEMORY ? ErrorKind::Transient : ErrorKind::Machine);
}

/// The size of a frame. [pixels]
struct FrameSize {
  int width, height;
};

constexpr FrameSize kTestSize{96, 54};
const Eigen::Vector3d kTestEye(0, 0, 0.62);  // [m]

/// The textures of the parts of a book.
struct Surfaces {
  const Texture& front;
  const Texture& spine;
  const Texture& back;
  const Texture& paper;
};

/// Returns a book so close that its front cover covers the middle of pictures of every size.
DrawnBody closeBook(int width, int height) {
  const geometry::Camera close{.position = {0, 0, 0.1}};
  DrawnBody body{.pixels = {}, .cage = physics::Cuboid{}.corners()};
  body.clipFromWorld = geometry::project(close, body.cage, {width, height, 0}).clipFromWorld;
  body.winding = frontFaceWinding(body.cage);
  return body;
}

/// Returns the book of the test frame, in an attitude that shows front cover, spine and pages.
DrawnBody testBook(const FrameSize& size) {
  const Eigen::AngleAxisd left(0.6, Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd forward(0.35, Eigen::Vector3d::UnitX());
  const geometry::Camera camera{.position = kTestEye};
  DrawnBody body{.pixels = {},
                 .cage = (forward * left).toRotationMatrix() * physics::Cuboid{}.corners()};
  body.clipFromWorld =
      geometry::project(camera, body.cage, {size.width, size.height, 0}).clipFromWorld;
  body.winding = frontFaceWinding(body.cage);
  return body;
}

/// Returns a texture of the test frame, of which no two neighbours are alike.
image::Image testPattern() {
  constexpr int kSide = 64;
  image::Image picture(kSide, kSide, image::PixelFormat::Rgb8);
  for (int y = 0; y < kSide; ++y) {
    for (int i = 0; i < 3 * kSide; ++i)
      picture.row(y)[i] = static_cast<std::uint8_t>(37 * i + 101 * y + i * y);
  }
  return picture;
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
    drawBody(closeBook(width, height), settings.camera.position, surfaces());
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

  std::string testFrame() const {
    const DrawnBody book = testBook(kTestSize);
    const Texture pattern(testPattern().view(), TextureWrap::Repeat);
    Checksum sum;
    sum.add(compositor.background().bytes());
    for (const auto pixels : {FrameTarget::Pixels::Exact, FrameTarget::Pixels::Picture}) {
      const FrameTarget frame(kTestSize.width, kTestSize.height, pixels);
      frame.begin({0, 0, kTestSize.width, kTestSize.height});
      drawBody(book, kTestEye, {pattern, pattern, pattern, pattern});
      sum.add(frame.bytes());
    }
    requireNoGlError("while drawing a test frame");
    return sum.text();
  }

  Surfaces surfaces() const { return {front, spine, back, paper}; }

  void drawBody(const DrawnBody& drawn, const Eigen::Vector3d& eye,
                const Surfaces& surfaces) const {
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
    drawn.winding == 0 ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
    glFrontFace(drawn.winding < 0 ? GL_CW : GL_CCW);
    geometry.bind();
    use(coverProgram, drawn);
    coverProgram.set("eye", Eigen::Vector3f(eye.cast<float>()));
    drawCover(geometry::BookPart::Front, surfaces.front);
    drawCover(geometry::BookPart::Spine, surfaces.spine);
    drawCover(geometry::BookPart::Back, surfaces.back);
    if (drawn.winding == 0) drawCover(geometry::BookPart::Lining, surfaces.front);
    use(paperProgram, drawn);
    drawPart(geometry::BookPart::Pages, surfaces.paper);
  }

  void drawStrips(DrawnBody& drawn) const {
    image::Image& colours = drawn.strips.colours;
    const geometry::PixelRect all{0, 0, colours.width(), colours.height()};
    stripTarget.begin(all);
    geometry.bindStrips();
    drawAllStrips(drawn, settings.camera.position);
    stripTarget.readBack({&all, 1}, colours);
  }

  /// Projects the body onto a picture. Returns the area that it may touch; it may be empty.
  geometry::PixelRect project(const physics::Cage& cage, const geometry::Camera& camera,
                              DrawnBody& drawn) const {
    geometry::Projection projection = geometry::project(
        camera, cage, {width, height, settings.supersample * settings.bottomRows});
    drawn.cage = cage;
    drawn.clipFromWorld = projection.clipFromWorld;
    drawn.winding = frontFaceWinding(cage);
    drawn.bands = std::move(projection.bands);
    stripFinder.find(cage, drawn.clipFromWorld, drawn.winding, {width, height},
                     drawn.strips.onScreen);
    const bool isOutside = projection.bounds.width <= 0 || projection.bounds.height <= 0;
    if (isOutside) drawn.bands.clear();
    return isOutside ? geometry::PixelRect{} : projection.bounds;
  }

  /// Draws bodies that are projected, each into a cell of its own.
  void drawSideBySide(std::span<const geometry::Camera> cameras, std::span<DrawnBody> bodies) {
    if (!cells || cells->count() < bodies.size()) {
      cells.emplace(bodies.size(), width, height, static_cast<int>(stripFinder.count()));
    }
    cells->pixels.begin(cells->all(cells->pixelCells));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].bands.empty()) continue;
      cells->pixels.restrictTo(cells->pixelCells[i]);
      drawBody(bodies[i], cameras[i].position, surfaces());
    }
    cells->strips.begin(cells->all(cells->stripCells));
    geometry.bindStrips();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].bands.empty()) continue;
      cells->strips.restrictTo(cells->stripCells[i]);
      drawAllStrips(bodies[i], cameras[i].position);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      DrawnBody& drawn = bodies[i];
      if (drawn.bands.empty()) continue;
      image::Image& colours = drawn.strips.colours;
      const geometry::PixelRect whole{0, 0, colours.width(), colours.height()};
      cells->strips.readBack({&whole, 1}, cells->stripCells[i], colours);
      cells->pixels.readBack(drawn.bands, cells->pixelCells[i], drawn.pixels);
    }
  }

  /// Relies on the rest of the OpenGL state that drawBody() leaves.
  void drawAllStrips(const DrawnBody& drawn, const Eigen::Vector3d& eye) const {
    use(paperProgram, drawn);
    drawStripsOf(geometry::BookPart::Pages, paper, drawn);
    use(coverProgram, drawn);
    coverProgram.set("eye", Eigen::Vector3f(eye.cast<float>()));
    drawCoverStrips(geometry::BookPart::Front, front, drawn);
    drawCoverStrips(geometry::BookPart::Spine, spine, drawn);
    drawCoverStrips(geometry::BookPart::Back, back, drawn);
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
  std::optional<Cells> cells;     // For draw() of several bodies.
};

Renderer::Renderer(const RenderSettings& settings, const BookTextures& textures)
    : parts_(std::make_unique<Parts>(settings, textures, geometry::makeBookMesh(settings.detail))) {
}
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
  const geometry::Camera& camera = parts_->settings.camera;
  const geometry::PixelRect area = parts_->project(cage, camera, body);
  if (area.width == 0) return;
  parts_->target.begin(area);
  parts_->drawBody(body, camera.position, parts_->surfaces());
  parts_->drawStrips(body);
  parts_->target.readBack(body.bands, body.pixels);
  requireNoGlError("while drawing a frame");
}

void Renderer::draw(std::span<const physics::Cage> cages, std::span<const geometry::Camera> cameras,
                    std::span<DrawnBody> bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) parts_->project(cages[i], cameras[i], bodies[i]);
  parts_->drawSideBySide(cameras, bodies);
  requireNoGlError("while drawing a frame");
}

std::string Renderer::testFrame() const {
  return parts_->testFrame();
}

const std::string& Renderer::description() const {
  return parts_->context.description();
}

}  // namespace rotatebook::render
