#include "render/renderer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "base/checksum.h"
#include "base/error.h"
#include "image/downsample.h"
#include "render/backdrop.h"
#include "render/body/body_painter.h"
#include "render/body/book_painter.h"
#include "render/body/mesh_geometry.h"
#include "render/body/surface_painter.h"
#include "render/compositor.h"
#include "render/device/egl_context.h"
#include "render/gl/cells.h"
#include "render/gl/frame_target.h"

namespace rotatebook::render {
namespace {

void requireNoGlError(const char* when) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  throw MachineError(fmt::format("can't draw: OpenGL error {} {}", error, when),
                     error == GL_OUT_OF_MEMORY ? ErrorKind::Transient : ErrorKind::Machine);
}

/// The size of a frame. [pixels]
struct FrameSize {
  int width, height;
};

constexpr FrameSize kTestSize{96, 54};
const Eigen::Vector3d kTestEye(0, 0, 0.62);  // [m]

/// Returns a body so close that its front covers the middle of pictures of every size.
DrawnBody closeBody(int width, int height) {
  const geometry::Camera close{.position = {0, 0, 0.1}};
  DrawnBody body{.pixels = {}, .cage = body::Cuboid{}.corners()};
  body.clipFromWorld = geometry::project(close, body.cage, {width, height, 0}).clipFromWorld;
  body.winding = frontFaceWinding(body.cage);
  return body;
}

/// Returns the body of the test frame, in an attitude that shows three of its sides.
DrawnBody testBody(const FrameSize& size) {
  const Eigen::AngleAxisd left(0.6, Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd forward(0.35, Eigen::Vector3d::UnitX());
  const geometry::Camera camera{.position = kTestEye};
  DrawnBody body{.pixels = {},
                 .cage = (forward * left).toRotationMatrix() * body::Cuboid{}.corners()};
  body.clipFromWorld =
      geometry::project(camera, body.cage, {size.width, size.height, 0}).clipFromWorld;
  body.winding = frontFaceWinding(body.cage);
  return body;
}

/// One look, and all that is needed to draw its body.
struct Body {
  Body(std::unique_ptr<BodyPainter> bodyPainter, const image::Image& background, bool isTwice)
      : painter(std::move(bodyPainter)),
        stripFinder(painter->mesh()),
        compositor(background, isTwice, painter->mesh()) {}

  std::unique_ptr<BodyPainter> painter;
  StripFinder stripFinder;
  Compositor compositor;
};

std::unique_ptr<BodyPainter> makePainter(const BodyLook& look, geometry::MeshDetail detail) {
  if (const auto* book = std::get_if<BookTextures>(&look))
    return std::make_unique<BookPainter>(*book, detail);
  return std::make_unique<SurfacePainter>(*std::get<std::shared_ptr<const SurfaceLook>>(look));
}

}  // namespace

struct Renderer::Parts {
  Parts(const RenderSettings& renderSettings, const std::vector<BodyLook>& looks)
      : settings(renderSettings),
        width(settings.supersample * settings.width),
        height(settings.supersample * settings.height),
        context(settings.device),
        target(width, height),
        backdrop(settings),
        background(makeBackground()),
        halved(halvedBackground()) {
    for (const BodyLook& look : looks)
      bodies.emplace_back(makePainter(look, settings.detail), background, halved.has_value());
    for (const Body& body : bodies) requireDrawing(*body.painter);
    if (stripCount() > 0) stripTarget.emplace(DrawnStrips::kColumns, stripCount());
    requireNoGlError("while setting up");
  }

  /// Returns the number of strips of the body that has the most.
  int stripCount() const {
    std::size_t count = 0;
    for (const Body& body : bodies) count = std::max(count, body.stripFinder.count());
    return static_cast<int>(count);
  }

  /// Throws MachineError if the driver draws nothing, as some do without an error. Uses the frames'
  /// own shaders, state and buffer, so that the first frame reuses all that is compiled for it.
  void requireDrawing(const BodyPainter& painter) const {
    const geometry::PixelRect middle{width / 2, height / 2, 1, 1};
    target.begin(middle);
    const DrawnBody close = closeBody(width, height);
    painter.drawTest({&close, settings.camera.position, whole()});
    const int drawn = target.alphaAt(middle.x, middle.y);
    target.begin(middle);
    const int cleared = target.alphaAt(middle.x, middle.y);
    if (drawn != 0 && cleared == 0) return;
    throw MachineError(fmt::format(
        "can't draw: {} reports no error and draws nothing: a pixel within a body has alpha {} "
        "when drawn and {} when cleared; choose another device with --device{}",
        context.description(), drawn, cleared, kDoctorHint));
  }

  image::Image makeBackground() const {
    image::Image picture(width, height, image::PixelFormat::Rgba8);
    backdrop.draw(target, Eigen::Matrix4f::Zero(), picture);
    return picture;
  }

  /// Returns the background of pictures, if it isn't that of the drawing.
  std::optional<image::Image> halvedBackground() const {
    if (settings.supersample == 1) return {};
    image::Image picture(settings.width, settings.height, image::PixelFormat::Rgba8);
    image::downsample(background, picture.area(), picture.from(0, 0));
    return picture;
  }

  const image::Image& shownBackground() const { return halved ? *halved : background; }

  /// Draws a background of its own for a body that a turning camera sees.
  void drawBackground(DrawnBody& drawn) const {
    if (!worldFromFrame || !backdrop.hasDirections()) return;
    if (drawn.background.width() == 0) drawn.background = background;
    const geometry::Screen screen{width, height, settings.supersample * settings.bottomRows};
    const Eigen::Matrix4d sky = geometry::skyFromPicture(settings.camera, screen, *worldFromFrame);
    backdrop.draw(target, sky.cast<float>(), drawn.background);
  }

  std::string testFrame() const {
    const DrawnBody body = testBody(kTestSize);
    Checksum sum;
    sum.add(background.bytes());
    for (const Body& each : bodies) {
      for (const auto pixels : {FrameTarget::Pixels::Exact, FrameTarget::Pixels::Picture}) {
        const FrameTarget frame(kTestSize.width, kTestSize.height, pixels);
        const geometry::PixelRect all{0, 0, kTestSize.width, kTestSize.height};
        frame.begin(all);
        each.painter->drawTest({&body, kTestEye, all});
        sum.add(frame.bytes());
      }
    }
    requireNoGlError("while drawing a test frame");
    return sum.text();
  }

  geometry::PixelRect whole() const { return {0, 0, width, height}; }

  const BodyPainter& painterOf(const DrawnBody& drawn) const { return *bodies[drawn.look].painter; }

  /// Draws a body that is projected, and touches `area` alone.
  void draw(DrawnBody& drawn, const geometry::PixelRect& area) const {
    const Eigen::Vector3d& eye = settings.camera.position;
    const PlacedBody placed{&drawn, eye, whole()};
    target.begin(area);
    painterOf(drawn).draw({&placed, 1});
    drawStrips(drawn, eye);
    target.readBack(drawn.bands, drawn.pixels);
  }

  void drawStrips(DrawnBody& drawn, const Eigen::Vector3d& eye) const {
    image::Image& colours = drawn.strips.colours;
    if (colours.height() == 0) return;
    const geometry::PixelRect all{0, 0, colours.width(), colours.height()};
    const PlacedBody placed{&drawn, eye, all};
    stripTarget->begin(all);
    painterOf(drawn).drawStrips({&placed, 1});
    stripTarget->readBack({&all, 1}, all, colours);
  }

  /// Projects the body onto a picture. Returns the area that it may touch; it may be empty.
  geometry::PixelRect project(const body::Cage& cage, const geometry::Camera& camera,
                              DrawnBody& drawn) const {
    geometry::Projection projection = geometry::project(
        camera, cage, {width, height, settings.supersample * settings.bottomRows});
    drawn.cage = cage;
    drawn.clipFromWorld = projection.clipFromWorld;
    drawn.winding = frontFaceWinding(cage);
    drawn.bands = std::move(projection.bands);
    bodies[drawn.look].stripFinder.find(cage, drawn.clipFromWorld, drawn.winding, {width, height},
                                        drawn.strips.onScreen);
    const bool isOutside = projection.bounds.width <= 0 || projection.bounds.height <= 0;
    const bool isUnseen = isOutside || !settings.drawsBodies;
    if (isUnseen) drawn.bands.clear();
    return isUnseen ? geometry::PixelRect{} : projection.bounds;
  }

  /// Draws bodies that are projected, each into a cell of its own.
  void drawSideBySide(std::span<const geometry::Camera> cameras, std::span<DrawnBody> drawn) {
    if (!cells || cells->count() < drawn.size())
      cells.emplace(drawn.size(), width, height, std::max(stripCount(), 1));
    cells->pixels.begin(cells->all(cells->pixelCells));
    for (std::size_t look = 0; look < bodies.size(); ++look)
      bodies[look].painter->draw(placedIn(cells->pixelCells, look, cameras, drawn));
    cells->strips.begin(cells->all(cells->stripCells));
    for (std::size_t look = 0; look < bodies.size(); ++look)
      bodies[look].painter->drawStrips(placedIn(cells->stripCells, look, cameras, drawn));
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (!drawn[i].bands.empty()) readBackCell(i, drawn[i]);
    }
  }

  /// Returns the bodies of a look that are to be drawn.
  static std::vector<PlacedBody> placedIn(const std::vector<geometry::PixelRect>& places,
                                          std::size_t look,
                                          std::span<const geometry::Camera> cameras,
                                          std::span<const DrawnBody> drawn) {
    std::vector<PlacedBody> placed;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (drawn[i].look == look && !drawn[i].bands.empty())
        placed.push_back({&drawn[i], cameras[i].position, places[i]});
    }
    return placed;
  }

  void readBackCell(std::size_t cell, DrawnBody& drawn) const {
    image::Image& colours = drawn.strips.colours;
    const geometry::PixelRect whole{0, 0, colours.width(), colours.height()};
    if (whole.height > 0) cells->strips.readBack({&whole, 1}, cells->stripCells[cell], colours);
    cells->pixels.readBack(drawn.bands, cells->pixelCells[cell], drawn.pixels);
  }

  RenderSettings settings;
  int width, height;   // Of the drawing. [pixels]
  EglContext context;  // Before all that needs it, so that it is destroyed last.
  FrameTarget target;
  Backdrop backdrop;
  std::optional<Eigen::Matrix3d> worldFromFrame;  // Of a camera that turns.
  image::Image background;                        // Of the drawing.
  std::optional<image::Image> halved;
  std::vector<Body> bodies;                           // By look.
  std::optional<FrameTarget> stripTarget;             // If a body has strips.
  std::vector<std::optional<DrawnBody>> forPictures;  // By look, for draw() to a picture.
  std::optional<Cells> cells;                         // For draw() of several bodies.
};

Renderer::Renderer(const RenderSettings& settings, const std::vector<BodyLook>& looks)
    : parts_(std::make_unique<Parts>(settings, looks)) {}
Renderer::Renderer(const RenderSettings& settings, const BookTextures& textures)
    : Renderer(settings, std::vector<BodyLook>{textures}) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::setCamera(const geometry::Camera& camera) {
  parts_->settings.camera = camera;
}

void Renderer::setTurning(const Eigen::Matrix3d& worldFromFrame) {
  parts_->worldFromFrame = worldFromFrame;
}

DrawnBody Renderer::makeBody(std::size_t look) const {
  DrawnBody body{.look = look,
                 .pixels = {parts_->width, parts_->height, image::PixelFormat::Rgba8}};
  const std::size_t strips = parts_->bodies[look].stripFinder.count();
  if (strips == 0) return body;
  body.strips.colours = {DrawnStrips::kColumns, static_cast<int>(strips),
                         image::PixelFormat::Rgba8};
  return body;
}

void Renderer::compose(const DrawnBody& body, int x, int y, image::Image& picture) {
  parts_->bodies[body.look].compositor.compose(body, x, y, picture);
}

const image::Image& Renderer::background() const {
  return parts_->shownBackground();
}

image::Image Renderer::makePicture() const {
  const RenderSettings& settings = parts_->settings;
  return {settings.width, settings.height, image::PixelFormat::Rgba8};
}

void Renderer::draw(const body::Cage& cage, image::Image& picture) {
  draw(0, cage, picture);
}

void Renderer::draw(std::size_t look, const body::Cage& cage, image::Image& picture) {
  parts_->forPictures.resize(parts_->bodies.size());
  std::optional<DrawnBody>& drawn = parts_->forPictures[look];
  if (!drawn) drawn = makeBody(look);
  draw(cage, *drawn);
  picture = background();
  compose(*drawn, 0, 0, picture);
}

void Renderer::draw(const body::Cage& cage, DrawnBody& body) {
  parts_->drawBackground(body);
  const geometry::PixelRect area = parts_->project(cage, parts_->settings.camera, body);
  if (area.width == 0) return;
  parts_->draw(body, area);
  requireNoGlError("while drawing a frame");
}

void Renderer::draw(std::span<const body::Cage> cages, std::span<const geometry::Camera> cameras,
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
