#include "picture/interchange/exported_body.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

#include "geometry/body_mesh.h"
#include "geometry/book_mesh.h"
#include "image/downsample.h"
#include "image/jpeg_writer.h"
#include "image/png_file.h"
#include "picture/interchange/gold_picture.h"
#include "picture/interchange/grain.h"
#include "picture/looks.h"
#include "render/book_textures.h"
#include "render/surface_look.h"

namespace rotatebook::interchange {
namespace {

/// A part's material, by its index, and its grains along the edges of the unit cube, 0 of none.
struct PartMaterial {
  std::size_t index = 0;
  Eigen::Vector3f grains{0, 0, 0};
};
using Materials = std::vector<PartMaterial>;  // By part of the mesh.

constexpr int kLongestSide = 1024;  // Of the book's pictures. [pixels]
constexpr int kQuality = 78;        // Of them as JPEG.
constexpr int kGoldQuality = 32, kGrainQuality = 60;
constexpr float kPaperRoughness = 1;

/// Returns a picture's PNG or JPEG, whichever is smaller.
std::string smallFileOf(const image::Image& picture, int quality) {
  std::string jpeg = image::jpegText(picture.view(), quality);
  image::PngWriter writer;
  const std::string& png = writer.encode(picture.view(), "a picture");
  return png.size() < jpeg.size() ? png : jpeg;
}

image::Image madeSmall(image::Image picture) {
  while (std::max(picture.width(), picture.height()) > kLongestSide)
    picture = image::downsampledOpaque(picture.view());
  return picture;
}

/// Adds cloth or paper with a picture.
std::size_t addPrinted(const char* name, image::Image picture, float roughness, body::Wrap wrap,
                       ExportedBody& body) {
  body.pictures.push_back({smallFileOf(madeSmall(std::move(picture)), kQuality), {wrap, wrap}});
  body.materials.push_back(
      {.name = name, .roughness = roughness, .colourPicture = body.pictures.size() - 1});
  return body.materials.size() - 1;
}

Materials addMaterials(const render::BookTextures& cover, ExportedBody& body) {
  const auto cloth = [&](const char* name, const image::Image& picture) {
    const std::size_t added = addPrinted(name, picture, kClothRoughness, body::Wrap::Clamp, body);
    if (const auto gold = goldPicture(picture, kLongestSide / 2)) {
      body.pictures.push_back(
          {smallFileOf(*gold, kGoldQuality), {body::Wrap::Clamp, body::Wrap::Clamp}});
      body.materials[added].metalness = 1;
      body.materials[added].metalPicture = body.pictures.size() - 1;
    }
    return added;
  };
  const std::size_t front = cloth("front", cover.front), spine = cloth("spine", cover.spine),
                    back = cloth("back", cover.back);
  const std::size_t pages =
      addPrinted("pages", render::builtinPaper(), kPaperRoughness, body::Wrap::Repeat, body);
  return {{front}, {spine}, {back}, {pages}};
}

/// Adds the picture of a grain that fills no picture's place; returns the part's material.
PartMaterial withGrain(const body::Grain& grain, const Eigen::Vector3d& size, ExportedBody& body) {
  ExportedMaterial& material = body.materials.back();
  const PartMaterial plain{body.materials.size() - 1};
  if (grain.contrast <= 0 || material.colourPicture || material.metalPicture) return plain;
  body.pictures.push_back({smallFileOf(grainTile(grain.contrast), kGrainQuality)});
  material.colourPicture = body.pictures.size() - 1;
  material.colour = (material.colour * (1 + grain.contrast)).cwiseMin(1);
  return {plain.index, grainsAcross(grain, size).cast<float>()};
}

/// Adds those that a part of the mesh has.
Materials addMaterials(const render::SurfaceLook& look, const geometry::Mesh& mesh,
                       ExportedBody& body) {
  std::vector<std::optional<std::size_t>> added(look.images.size());
  const auto pictureOf = [&](int image) -> std::optional<std::size_t> {
    if (image == body::kNoImage) return std::nullopt;
    const auto i = static_cast<std::size_t>(image);
    if (!added[i]) {
      const std::string& file = look.surface.images[i];
      const bool isWebp = file.starts_with("RIFF");  // which the others' formats don't have
      body.pictures.push_back(
          {isWebp ? image::PngWriter().encode(look.images[i].view(), "a picture") : file,
           look.surface.samplings[i]});
      added[i] = body.pictures.size() - 1;
    }
    return added[i];
  };
  Materials numbers(look.surface.materials.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (mesh.parts[i].triangles.empty()) continue;
    const body::Material& material = look.surface.materials[i];
    body.materials.push_back({.colour = material.baseColour,
                              .metalness = material.metalness,
                              .roughness = material.roughness,
                              .colourPicture = pictureOf(material.baseColourImage),
                              .metalPicture = pictureOf(material.metalRoughnessImage)});
    numbers[i] = withGrain(material.grain, look.size, body);
  }
  return numbers;
}

/// Returns a part in metres: `size` is that of the mesh's unit cube.
ExportedPart partOf(const geometry::Mesh& mesh, const geometry::MeshPart& part,
                    const Eigen::Vector3f& size, const PartMaterial& material) {
  const bool hasGrain = material.grains.x() > 0;
  ExportedPart made{.material = material.index};
  // One more than a vertex's, 0 if new: sides that face other axes have other tiles of grain
  std::vector<std::array<std::uint32_t, 3>> numbers(mesh.vertices.size());
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const std::uint32_t corner = part.triangles[i];
    const int axis = hasGrain ? facedAxis(mesh, &part.triangles[i - i % 3], size) : 0;
    std::uint32_t& number = numbers[corner][static_cast<std::size_t>(axis)];
    if (number == 0) {
      const geometry::MeshVertex& vertex = mesh.vertices[corner];
      made.positions.emplace_back(
          (vertex.position - Eigen::Vector3f::Constant(0.5F)).cwiseProduct(size));
      made.normals.emplace_back(vertex.normal.cwiseQuotient(size).normalized());
      made.texCoords.push_back(hasGrain ? placeOnTiles(vertex.position, axis, material.grains)
                                        : vertex.texCoord);
      number = static_cast<std::uint32_t>(made.positions.size());
    }
    made.corners.push_back(number - 1);
  }
  return made;
}

}  // namespace

ExportedBody exportedBody(const scene::Scene& scene) {
  const render::BodyLook look = picture::loadLooks(scene).looks.front();
  const auto* cover = std::get_if<render::BookTextures>(&look);
  const render::SurfaceLook* other =
      cover != nullptr ? nullptr : std::get<std::shared_ptr<const render::SurfaceLook>>(look).get();
  ExportedBody body{.name = cover != nullptr ? "book" : "body",
                    .size = scene.motions.front().body.size};
  const geometry::Mesh mesh = cover != nullptr
                                  ? geometry::makeBookMesh()
                                  : geometry::makeBodyMesh(other->surface, other->size);
  const Materials materials =
      cover != nullptr ? addMaterials(*cover, body) : addMaterials(*other, mesh, body);
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const geometry::MeshPart& part = mesh.parts[i];
    if (part.hidden || part.triangles.empty()) continue;
    body.parts.push_back(partOf(mesh, part, body.size.cast<float>(), materials.at(i)));
  }
  return body;
}

}  // namespace rotatebook::interchange
