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

void BookPainter::draw(std::span<const PlacedBody> bodies) const {
  drawParts(bodies, {front_, spine_, back_, paper_, scatteredByCover_});
}

void BookPainter::drawTest(const PlacedBody& body) const {
  // With gold, too
  const Texture pattern(withGold(testPattern()).view(), kRepeated, TextureContent::ColourAndNumber);
  drawParts({&body, 1}, {pattern, pattern, pattern, pattern, Eigen::Vector3f::Zero()});
}

void BookPainter::drawParts(std::span<const PlacedBody> bodies, const Surfaces& surfaces) const {
  geometry_.bind();
  eachPart(surfaces, [&](geometry::BookPart part, const ShaderProgram& program) {
    for (const PlacedBody& body : bodies) {
      if (part == geometry::BookPart::Lining && body.drawn->winding != 0) continue;
      prepareToDraw(body, program);
      geometry_.draw(indexOf(part));
    }
  });
}

void BookPainter::drawStrips(std::span<const PlacedBody> bodies) const {
  geometry_.bindStrips();
  const Surfaces surfaces{front_, spine_, back_, paper_, scatteredByCover_};
  eachPart(surfaces, [&](geometry::BookPart part, const ShaderProgram& program) {
    for (const PlacedBody& body : bodies) {
      const std::vector<ScreenStrip>& strips = body.drawn->strips.onScreen;
      if (!geometry_.hasNarrowStrips(indexOf(part), strips)) continue;
      prepareToDraw(body, program);
      geometry_.drawStrips(indexOf(part), strips);
    }
  });
}

template <typename Draw>
void BookPainter::eachPart(const Surfaces& surfaces, const Draw& draw) const {
  const auto drawPart = [&](geometry::BookPart part, const ShaderProgram& program,
                            const Texture& texture) {
    texture.bind();
    draw(part, program);
  };
  coverProgram_.use();
  coverProgram_.set("beside", kScatteredByLeaves);
  drawPart(geometry::BookPart::Front, coverProgram_, surfaces.front);
  drawPart(geometry::BookPart::Spine, coverProgram_, surfaces.spine);
  drawPart(geometry::BookPart::Back, coverProgram_, surfaces.back);
  drawPart(geometry::BookPart::Lining, coverProgram_, surfaces.front);
  paperProgram_.use();
  paperProgram_.set("beside", surfaces.scatteredByCover);
  drawPart(geometry::BookPart::Pages, paperProgram_, surfaces.paper);
}

}  // namespace rotatebook::render
