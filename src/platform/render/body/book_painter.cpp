#include "render/body/book_painter.h"

#include "embedded/render.h"
#include "render/body/test_pattern.h"

namespace rotatebook::render {
namespace {

std::size_t indexOf(geometry::BookPart part) {
  return static_cast<std::size_t>(part);
}

}  // namespace

Eigen::Vector3f scatteredByCover(const image::Image& front) {
  constexpr float kRim = 0.004F;  // Of its height, as the mesh has it.
  const int row = static_cast<int>((1 - kRim) * static_cast<float>(front.height()));
  const std::uint8_t* pixel =
      front.row(row) + front.width() / 2 * image::bytesPerPixel(front.format());
  return (Eigen::Vector3f(pixel[0], pixel[1], pixel[2]) / 255).cwiseAbs2();
}

Texture coverTexture(const image::Image& side) {
  return {withGold(side).view(), kClamped, TextureContent::ColourAndNumber};
}

BookPainter::BookPainter(const BookTextures& textures, geometry::MeshDetail detail)
    : mesh_(geometry::makeBookMesh(detail)),
      coverProgram_(
          "cover", {studioScatter(), bodyVertexShader()},
          {{studioScatter(), studioShine(), coverFragmentShader()}, toneCurveFragmentShader()}),
      paperProgram_("paper", {studioScatter(), bodyVertexShader()},
                    {paperFragmentShader(), toneCurveFragmentShader()}),
      geometry_(mesh_),
      scatteredByCover_(scatteredByCover(textures.front)),
      front_(coverTexture(textures.front)),
      spine_(coverTexture(textures.spine)),
      back_(coverTexture(textures.back)),
      paper_(builtinPaper().view(), kRepeated) {}

void BookPainter::draw(const DrawnBody& drawn, const Eigen::Vector3d& eye) const {
  drawParts(drawn, eye, {front_, spine_, back_, paper_, scatteredByCover_});
}

void BookPainter::drawTest(const DrawnBody& drawn, const Eigen::Vector3d& eye) const {
  const Texture pattern(testPattern().view(), kRepeated);
  drawParts(drawn, eye, {pattern, pattern, pattern, pattern, Eigen::Vector3f::Zero()});
}

void BookPainter::drawParts(const DrawnBody& drawn, const Eigen::Vector3d& eye,
                            const Surfaces& surfaces) const {
  prepareToDraw(drawn);
  geometry_.bind();
  useFor(coverProgram_, drawn);
  coverProgram_.set("eye", Eigen::Vector3f(eye.cast<float>()));
  coverProgram_.set("beside", kScatteredByLeaves);
  drawPart(geometry::BookPart::Front, surfaces.front);
  drawPart(geometry::BookPart::Spine, surfaces.spine);
  drawPart(geometry::BookPart::Back, surfaces.back);
  if (drawn.winding == 0) drawPart(geometry::BookPart::Lining, surfaces.front);
  useFor(paperProgram_, drawn);
  paperProgram_.set("beside", surfaces.scatteredByCover);
  drawPart(geometry::BookPart::Pages, surfaces.paper);
}

void BookPainter::drawStrips(const DrawnBody& drawn, const Eigen::Vector3d& eye) const {
  geometry_.bindStrips();
  useFor(paperProgram_, drawn);
  paperProgram_.set("beside", scatteredByCover_);
  drawStripsOf(geometry::BookPart::Pages, paper_, drawn);
  useFor(coverProgram_, drawn);
  coverProgram_.set("eye", Eigen::Vector3f(eye.cast<float>()));
  coverProgram_.set("beside", kScatteredByLeaves);
  drawStripsOf(geometry::BookPart::Front, front_, drawn);
  drawStripsOf(geometry::BookPart::Spine, spine_, drawn);
  drawStripsOf(geometry::BookPart::Back, back_, drawn);
}

void BookPainter::drawPart(geometry::BookPart part, const Texture& texture) const {
  texture.bind();
  geometry_.draw(indexOf(part));
}

void BookPainter::drawStripsOf(geometry::BookPart part, const Texture& texture,
                               const DrawnBody& drawn) const {
  texture.bind();
  geometry_.drawStrips(indexOf(part), drawn.strips.onScreen);
}

}  // namespace rotatebook::render
