#include "render/sampled_book.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "embedded/render.h"
#include "geometry/book_mesh.h"
#include "image/linear_accumulator.h"
#include "image/png_file.h"
#include "render/body/book_painter.h"
#include "render/body/mesh_geometry.h"
#include "render/device/egl_context.h"
#include "render/gl/frame_target.h"
#include "render/gl/shader_program.h"
#include "render/gl/texture.h"

namespace rotatebook::render::testing {
namespace {

constexpr int kSamples = 4;

constexpr std::string_view kOneSample = R"(#version 330 core
uniform sampler2DMS samples;
uniform int number;
out vec4 colour;
void main() { colour = texelFetch(samples, ivec2(gl_FragCoord.xy), number); }
)";

/// A frame buffer of several samples a pixel.
struct SampledTarget {
  SampledTarget(int width, int height) {
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, colour.name());
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, GL_RGBA8, width, height, GL_TRUE);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, depth.name());
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, GL_DEPTH_COMPONENT24, width,
                            height, GL_TRUE);
    glBindFramebuffer(GL_FRAMEBUFFER, buffer.name());
    attach(GL_COLOR_ATTACHMENT0, colour);
    attach(GL_DEPTH_ATTACHMENT, depth);
  }

  static void attach(GLenum attachment, const GlTexture& texture) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D_MULTISAMPLE, texture.name(),
                           0);
  }

  GlTexture colour, depth;
  GlFramebuffer buffer;
};

}  // namespace

struct SampledBook::Parts {
  Parts(const RenderSettings& renderSettings, const BookTextures& textures)
      : settings(renderSettings),
        everything{0, 0, settings.width, settings.height},
        context(settings.device),
        target(settings.width, settings.height),
        cover("cover", {studioScatter(), bodyVertexShader()},
              {{studioScatter(), studioShine(), coverFragmentShader()}, toneCurveFragmentShader()}),
        paper("paper", {studioScatter(), bodyVertexShader()},
              {paperFragmentShader(), toneCurveFragmentShader()}),
        oneSample("sample", wholePictureVertexShader(), {kOneSample}),
        geometry(geometry::makeBookMesh()),
        front(coverTexture(textures.front)),
        spine(coverTexture(textures.spine)),
        back(coverTexture(textures.back)),
        leaves(image::decodePng(paperPng(), "built-in paper").view(), kRepeated),
        scatteredBy(scatteredByCover(textures.front)) {}

  void draw(const body::Cage& corners) const {
    const geometry::Projection projection = geometry::project(
        settings.camera, corners, {settings.width, settings.height, settings.bottomRows});
    const Eigen::Matrix4d& clipFromWorld = projection.clipFromWorld;
    const int winding = frontFaceWinding(corners);
    glEnable(GL_DEPTH_TEST);
    winding == 0 ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
    glFrontFace(winding < 0 ? GL_CW : GL_CCW);
    geometry.bind();
    use(cover, corners, clipFromWorld);
    cover.set("eye", Eigen::Vector3f(settings.camera.position.cast<float>()));
    cover.set("beside", kScatteredByLeaves);
    drawPart(geometry::BookPart::Front, front);
    drawPart(geometry::BookPart::Spine, spine);
    drawPart(geometry::BookPart::Back, back);
    if (winding == 0) drawPart(geometry::BookPart::Lining, front);
    use(paper, corners, clipFromWorld);
    paper.set("beside", scatteredBy);
    drawPart(geometry::BookPart::Pages, leaves);
  }

  static void use(const ShaderProgram& program, const body::Cage& corners,
                  const Eigen::Matrix4d& clipFromWorld) {
    program.use();
    program.set("cage", Eigen::Matrix<float, 3, 8>(corners.cast<float>()));
    program.set("clipFromWorld", Eigen::Matrix4f(clipFromWorld.cast<float>()));
  }

  void drawPart(geometry::BookPart part, const Texture& texture) const {
    texture.bind();
    geometry.draw(static_cast<std::size_t>(part));
  }

  image::Image readBack() const {
    image::Image picture(settings.width, settings.height, image::PixelFormat::Rgba8);
    target.readBack({&everything, 1}, picture);
    return picture;
  }

  RenderSettings settings;
  geometry::PixelRect everything;
  EglContext context;
  FrameTarget target;
  std::optional<SampledTarget> sampled;  // Large; only if it is asked for.
  ShaderProgram cover, paper, oneSample;
  MeshGeometry geometry;
  Texture front, spine, back, leaves;
  Eigen::Vector3f scatteredBy;
};

SampledBook::SampledBook(const RenderSettings& settings, const BookTextures& textures)
    : parts_(std::make_unique<Parts>(settings, textures)) {}
SampledBook::~SampledBook() = default;

std::vector<image::Image> SampledBook::multisampled(const body::Cage& corners) {
  parts_->target.begin(parts_->everything);
  if (!parts_->sampled) parts_->sampled.emplace(parts_->settings.width, parts_->settings.height);
  glBindFramebuffer(GL_FRAMEBUFFER, parts_->sampled->buffer.name());
  glEnable(GL_MULTISAMPLE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  parts_->draw(corners);
  std::vector<image::Image> samples;
  for (int i = 0; i < kSamples; ++i) {
    parts_->target.begin(parts_->everything);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    parts_->oneSample.use();
    parts_->oneSample.set("number", i);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, parts_->sampled->colour.name());
    const GlVertexArray noVertices;
    glBindVertexArray(noVertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    samples.push_back(parts_->readBack());
  }
  return samples;
}

image::Image SampledBook::drawn(const body::Cage& corners) {
  parts_->target.begin(parts_->everything);
  parts_->draw(corners);
  return parts_->readBack();
}

image::Image meanLight(const std::vector<image::Image>& samples, const image::Image& background) {
  image::Image mean = background;
  for (int y = 0; y < mean.height(); ++y) {
    for (int x = 0; x < mean.width(); ++x) {
      image::LinearAccumulator sum;
      for (const image::Image& sample : samples) {
        const std::uint8_t* pixel = sample.row(y) + 4 * static_cast<std::ptrdiff_t>(x);
        if (pixel[3] == 0) pixel = background.row(y) + 4 * static_cast<std::ptrdiff_t>(x);
        const std::array<std::uint8_t, 4> opaque{pixel[0], pixel[1], pixel[2], 255};
        sum.add(opaque.data(), 1);
      }
      sum.mean(static_cast<std::uint32_t>(samples.size()),
               mean.row(y) + 4 * static_cast<std::ptrdiff_t>(x));
    }
  }
  return mean;
}

}  // namespace rotatebook::render::testing
