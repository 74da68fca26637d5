#include "render/body/surface_painter.h"

#include <array>

#include "body/shape.h"
#include "embedded/render.h"
#include "geometry/body_mesh.h"
#include "render/body/test_pattern.h"
#include "render/book_textures.h"

namespace rotatebook::render {
namespace {

/// Returns a cuboid that fills its cage, with texture coordinates that follow from the positions.
geometry::Mesh testMesh() {
  constexpr std::array<double, 3> cube{1, 1, 1};
  body::Surface surface{.mesh = body::findShape("box")->solid(cube).surface};
  for (const auto& triangle : surface.mesh.triangles) {
    auto& corners = surface.texCoords.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3f point = surface.mesh.points[triangle[i]].cast<float>();
      corners[i] = {point.x() + point.z(), point.y() + point.z()};
    }
  }
  return geometry::makeBodyMesh(surface, Eigen::Vector3d::Ones());
}

/// Returns the textures of those images that `use` names in a material.
std::vector<std::unique_ptr<Texture>> texturesOf(const SurfaceLook& look, int body::Material::*use,
                                                 TextureContent content) {
  std::vector<std::unique_ptr<Texture>> textures(look.images.size());
  for (const body::Material& material : look.surface.materials) {
    if (material.*use == body::kNoImage) continue;
    const auto index = static_cast<std::size_t>(material.*use);
    if (textures[index] != nullptr) continue;
    textures[index] = std::make_unique<Texture>(look.images[index].view(),
                                                look.surface.samplings[index], content);
  }
  return textures;
}

}  // namespace

SurfacePainter::SurfacePainter(const SurfaceLook& look)
    : mesh_(geometry::makeBodyMesh(look.surface, look.size)),
      size_(look.size),
      materials_(look.surface.materials),
      program_(
          "surface", {studioScatter(), bodyVertexShader()},
          {{studioScatter(), studioShine(), surfaceFragmentShader()}, toneCurveFragmentShader()}),
      geometry_(mesh_),
      testGeometry_(testMesh()),
      white_(plainCloth({255, 255, 255}).view(), kRepeated),
      colours_(texturesOf(look, &body::Material::baseColourImage, TextureContent::Colour)),
      numbers_(texturesOf(look, &body::Material::metalRoughnessImage, TextureContent::Numbers)) {}

void SurfacePainter::draw(std::span<const PlacedBody> bodies) const {
  begin();
  geometry_.bind();
  for (std::size_t part = 0; part < materials_.size(); ++part) {
    if (mesh_.parts[part].triangles.empty()) continue;
    useMaterial(materials_[part]);
    for (const PlacedBody& body : bodies) {
      prepareToDraw(body, program_);
      geometry_.draw(part);
    }
  }
}

void SurfacePainter::drawTest(const PlacedBody& body) const {
  const Texture pattern(testPattern().view(), kRepeated);
  begin();
  testGeometry_.bind();
  useMaterial(
      {.metalness = 0.5F, .grain = {size_ / 16, 0.5F, static_cast<float>(size_.x() / 100)}});
  pattern.bind();
  prepareToDraw(body, program_);
  testGeometry_.draw(0);
}

void SurfacePainter::begin() const {
  program_.use();
  program_.set("albedo", 0);
  program_.set("metalRoughness", 1);
}

void SurfacePainter::useMaterial(const body::Material& material) const {
  const auto bind = [this](const auto& textures, int image) {
    (image == body::kNoImage ? white_ : *textures[static_cast<std::size_t>(image)]).bind();
  };
  glActiveTexture(GL_TEXTURE1);
  bind(numbers_, material.metalRoughnessImage);
  glActiveTexture(GL_TEXTURE0);
  bind(colours_, material.baseColourImage);
  program_.set("baseColour", material.baseColour);
  program_.set("metalAndRoughness", Eigen::Vector2f(material.metalness, material.roughness));
  const body::Grain& grain = material.grain;
  program_.set("grainsAcross", Eigen::Vector3f(grainsAcross(grain, size_).cast<float>()));
  program_.set("contrastAndRelief", Eigen::Vector2f(grain.contrast, grain.relief));
}

}  // namespace rotatebook::render
