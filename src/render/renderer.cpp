#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/LU>

#include "base/error.h"
#include "image/png_file.h"
#include "render/blank_area.h"
#include "render/book_mesh.h"
#include "render/egl_context.h"
#include "render/embedded_files.h"
#include "render/frame_target.h"
#include "render/shader_program.h"
#include "render/texture.h"

namespace rotatebook::render {
namespace {

constexpr float kClothGloss = 1;
constexpr float kPaperGloss = 0;

/// Which vertex attribute is which, as book.vert numbers them.
void describeVertex() {
  const auto attribute = [](GLuint index, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(BookVertex),
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(BookVertex, place));
  attribute(1, 3, offsetof(BookVertex, normal));
  attribute(2, 2, offsetof(BookVertex, texture));
  attribute(3, 1, offsetof(BookVertex, openness));
}

/// The mesh on the graphics side.
class BookGeometry {
 public:
  BookGeometry() {
    const BookMesh mesh = makeBookMesh();
    std::vector<std::uint32_t> indices;
    for (std::size_t part = 0; part < kBookPartCount; ++part) {
      starts_[part] = indices.size();
      indices.insert(indices.end(), mesh.triangles[part].begin(), mesh.triangles[part].end());
    }
    starts_[kBookPartCount] = indices.size();
    glBindVertexArray(array_.name());
    upload(GL_ARRAY_BUFFER, vertices_, mesh.vertices);
    upload(GL_ELEMENT_ARRAY_BUFFER, indices_, indices);
    describeVertex();
  }

  void bind() const { glBindVertexArray(array_.name()); }

  void draw(BookPart part) const {
    const auto index = static_cast<std::size_t>(part);
    const std::size_t start = starts_[index], count = starts_[index + 1] - start;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(start * sizeof(std::uint32_t)));
  }

 private:
  template <typename Element>
  static void upload(GLenum target, const GlBuffer& buffer, const std::vector<Element>& elements) {
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)),
                 elements.data(), GL_STATIC_DRAW);
  }

  GlVertexArray array_;
  GlBuffer vertices_, indices_;
  std::array<std::size_t, kBookPartCount + 1> starts_{};
};

/// Signed volume at each corner of the map from the unit cube, as a share of the largest. Negative:
/// inside out.
Eigen::Array<double, 8, 1> cornerVolumes(const physics::Corners& corners) {
  Eigen::Array<double, 8, 1> volumes;
  for (int i = 0; i < 8; ++i) {
    Eigen::Matrix3d edges;
    for (int axis = 0; axis < 3; ++axis) {
      const int other = i ^ (1 << axis);
      const double sign = (i & (1 << axis)) != 0 ? 1 : -1;
      edges.col(axis) = sign * (corners.col(i) - corners.col(other));
    }
    volumes[i] = edges.determinant();
  }
  return volumes / std::max(volumes.abs().maxCoeff(), std::numeric_limits<double>::min());
}

/// Spares the sides that look away from the eye, unless the book is so deformed that any may be
/// seen.
void hideInnerSides(const physics::Corners& corners) {
  constexpr double kClearlyOneWay = 0.2;
  const Eigen::Array<double, 8, 1> volumes = cornerVolumes(corners);
  const bool rightWayOut = volumes.minCoeff() > kClearlyOneWay;
  const bool insideOut = volumes.maxCoeff() < -kClearlyOneWay;
  if (!rightWayOut && !insideOut) return glDisable(GL_CULL_FACE);
  glEnable(GL_CULL_FACE);
  glFrontFace(rightWayOut ? GL_CW
                          : GL_CCW);  // Clip y points down, which turns every triangle round.
}

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
        target(settings.width, settings.height, settings.samples),
        backgroundProgram("background", wholePictureVertexShader(), backgroundFragmentShader()),
        backdropProgram("backdrop", wholePictureVertexShader(), backdropFragmentShader()),
        bookProgram("book", bookVertexShader(), bookFragmentShader()),
        front(textures.front.view(), TextureWrap::Clamp),
        spine(textures.spine.view(), TextureWrap::Clamp),
        back(textures.back.view(), TextureWrap::Clamp),
        paper(image::decodePng(paperPng(), "built-in paper").view(), TextureWrap::Repeat),
        background(settings.width, settings.height, image::PixelFormat::Rgba8) {
    const PixelRect everything{0, 0, settings.width, settings.height};
    target.begin(everything);
    backgroundProgram.use();
    const Eigen::Vector2i size(settings.width, settings.height);
    backgroundProgram.set("pictureSize", Eigen::Vector2f(size.cast<float>()));
    coverPicture();
    target.readBack(everything, background);
    backdrop.emplace(background.view());
    requireNoGlError("while setting up");
  }

  /// Draws over the whole picture, infinitely far away, with the program in use, whose colours are
  /// encoded already. Setting the depth on the way spares clearing it, which costs as much as
  /// drawing (software rasteriser, 4 samples).
  void coverPicture() const {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDisable(GL_CULL_FACE);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindVertexArray(noVertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_FRAMEBUFFER_SRGB);
  }

  void drawBackdrop() const {
    backdropProgram.use();
    backdrop->bind();
    coverPicture();
  }

  void drawBook(const physics::Corners& corners, const Projection& projection) const {
    glDepthFunc(GL_LESS);
    hideInnerSides(corners);
    bookProgram.use();
    bookProgram.set("corners", Eigen::Matrix<float, 3, 8>(corners.cast<float>()));
    bookProgram.set("clipFromWorld", Eigen::Matrix4f(projection.clipFromWorld.cast<float>()));
    bookProgram.set("eye", Eigen::Vector3f(settings.camera.position.cast<float>()));
    geometry.bind();
    drawPart(BookPart::Front, front, kClothGloss);
    drawPart(BookPart::Spine, spine, kClothGloss);
    drawPart(BookPart::Back, back, kClothGloss);
    drawPart(BookPart::Pages, paper, kPaperGloss);
  }

  void drawPart(BookPart part, const Texture& texture, float gloss) const {
    bookProgram.set("gloss", gloss);
    texture.bind();
    geometry.draw(part);
  }

  RenderSettings settings;
  EglContext context;  // First made, last destroyed of all that needs it.
  FrameTarget target;
  ShaderProgram backgroundProgram, backdropProgram, bookProgram;
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
    parts_->target.begin(area);
    parts_->drawBackdrop();
    parts_->drawBook(corners, projection);
    parts_->target.readBack(area, picture);
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
