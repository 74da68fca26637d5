#include "interchange/glb_body.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "body/surface.h"
#include "geometry/body_mesh.h"
#include "geometry/book_mesh.h"
#include "image/downsample.h"
#include "image/jpeg_writer.h"
#include "image/png_file.h"
#include "picture/looks.h"
#include "render/book_textures.h"
#include "render/surface_look.h"

namespace rotatebook::interchange {
namespace {

using Materials = std::vector<std::size_t>;  // Their numbers in the file, by part of the mesh.

constexpr int kLongestSide = 1024;  // Of the book's pictures. [pixels]
constexpr int kQuality = 80;        // Of them as JPEG.
constexpr float kClothRoughness = 0.45F, kPaperRoughness = 1;

/// Returns a picture's PNG or JPEG, whichever is smaller.
std::string smallFileOf(const image::Image& picture) {
  std::string jpeg = image::jpegText(picture.view(), kQuality);
  image::PngWriter writer;
  const std::string& png = writer.encode(picture.view(), "a picture");
  return png.size() < jpeg.size() ? png : jpeg;
}

image::Image madeSmall(image::Image picture) {
  while (std::max(picture.width(), picture.height()) > kLongestSide)
    picture = image::downsampledOpaque(picture.view());
  return picture;
}

int wrapOf(body::Wrap wrap) {
  constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648;
  if (wrap == body::Wrap::Repeat) return kRepeat;
  return wrap == body::Wrap::Clamp ? kClamp : kMirror;
}

std::size_t addTexture(std::string_view picture, const body::Sampling& sampling, GlbFile& glb) {
  constexpr int kNearest = 9728, kLinear = 9729, kMipMaps = 9987;
  const std::size_t sampler =
      glb.add("samplers", {{"magFilter", sampling.hasSquares ? kNearest : kLinear},
                           {"minFilter", kMipMaps},
                           {"wrapS", wrapOf(sampling.across)},
                           {"wrapT", wrapOf(sampling.down)}});
  return glb.add("textures", {{"sampler", sampler}, {"source", glb.addPicture(picture)}});
}

/// Adds cloth or paper with a picture.
std::size_t addPrinted(const char* name, image::Image picture, float roughness, body::Wrap wrap,
                       GlbFile& glb) {
  const std::size_t texture =
      addTexture(smallFileOf(madeSmall(std::move(picture))), {wrap, wrap}, glb);
  return glb.add("materials", {{"name", name},
                               {"pbrMetallicRoughness",
                                {{"baseColorTexture", {{"index", texture}}},
                                 {"metallicFactor", 0},
                                 {"roughnessFactor", roughness}}}});
}

Materials addMaterials(const render::BookTextures& cover, GlbFile& glb) {
  const auto cloth = [&](const char* name, const image::Image& picture) {
    return addPrinted(name, picture, kClothRoughness, body::Wrap::Clamp, glb);
  };
  return {cloth("front", cover.front), cloth("spine", cover.spine), cloth("back", cover.back),
          addPrinted("pages", render::builtinPaper(), kPaperRoughness, body::Wrap::Repeat, glb)};
}

/// Adds those that a part of the mesh has.
Materials addMaterials(const render::SurfaceLook& look, const geometry::Mesh& mesh, GlbFile& glb) {
  std::vector<std::optional<std::size_t>> textures(look.images.size());
  const auto textureOf = [&](int image) {
    const auto i = static_cast<std::size_t>(image);
    const std::string& file = look.surface.images[i];
    const bool isWebp = file.starts_with("RIFF");  // which glTF itself doesn't have
    if (!textures[i])
      textures[i] =
          addTexture(isWebp ? image::PngWriter().encode(look.images[i].view(), "a picture") : file,
                     look.surface.samplings[i], glb);
    return Json{{"index", *textures[i]}};
  };
  Materials numbers(look.surface.materials.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (mesh.parts[i].triangles.empty()) continue;
    const body::Material& material = look.surface.materials[i];
    const Eigen::Vector3f& colour = material.baseColour;
    Json numbered{{"baseColorFactor", {colour.x(), colour.y(), colour.z(), 1}},
                  {"metallicFactor", material.metalness},
                  {"roughnessFactor", material.roughness}};
    if (material.baseColourImage != body::kNoImage)
      numbered["baseColorTexture"] = textureOf(material.baseColourImage);
    if (material.metalRoughnessImage != body::kNoImage)
      numbered["metallicRoughnessTexture"] = textureOf(material.metalRoughnessImage);
    numbers[i] = glb.add("materials", {{"pbrMetallicRoughness", std::move(numbered)}});
  }
  return numbers;
}

/// The vertices of one part of a mesh.
struct PartVertices {
  std::vector<std::uint32_t> corners;
  std::vector<float> positions, normals, texCoords;
};

/// Returns a part's vertices in metres: `size` is that of the mesh's unit cube.
PartVertices verticesOf(const geometry::Mesh& mesh, const geometry::MeshPart& part,
                        const Eigen::Vector3f& size) {
  PartVertices made;
  std::vector<std::uint32_t> numbers(mesh.vertices.size());  // One more than a vertex's; 0 if new.
  for (const std::uint32_t corner : part.triangles) {
    if (numbers[corner] == 0) {
      const geometry::MeshVertex& vertex = mesh.vertices[corner];
      const Eigen::Vector3f position =
          (vertex.position - Eigen::Vector3f::Constant(0.5F)).cwiseProduct(size);
      const Eigen::Vector3f normal = vertex.normal.cwiseQuotient(size).normalized();
      made.positions.insert(made.positions.end(), position.begin(), position.end());
      made.normals.insert(made.normals.end(), normal.begin(), normal.end());
      made.texCoords.insert(made.texCoords.end(), {vertex.texCoord.x(), 1 - vertex.texCoord.y()});
      numbers[corner] = static_cast<std::uint32_t>(made.positions.size() / 3);
    }
    made.corners.push_back(numbers[corner] - 1);
  }
  return made;
}

Json primitiveOf(const PartVertices& part, std::size_t material, bool hasPictures, GlbFile& glb) {
  const std::size_t count = part.positions.size() / 3;
  Json attributes{{"POSITION", glb.addFloats(part.positions, 3, Numbers::Ranged)},
                  {"NORMAL", glb.addFloats(part.normals, 3, Numbers::OfVertices)}};
  if (hasPictures) attributes["TEXCOORD_0"] = glb.addFloats(part.texCoords, 2, Numbers::OfVertices);
  attributes["JOINTS_0"] = glb.addBytes({0, 0, 0, 0}, count, false);
  attributes["WEIGHTS_0"] = glb.addBytes({255, 0, 0, 0}, count, true);
  return {{"attributes", std::move(attributes)},
          {"indices", glb.addCorners(part.corners, count)},
          {"material", material}};
}

}  // namespace

std::size_t addBody(const scene::Scene& scene, GlbFile& glb) {
  const render::BodyLook look = picture::loadLooks(scene).looks.front();
  const auto* cover = std::get_if<render::BookTextures>(&look);
  const bool isBook = cover != nullptr;
  const render::SurfaceLook* other =
      isBook ? nullptr : std::get<std::shared_ptr<const render::SurfaceLook>>(look).get();
  const geometry::Mesh mesh =
      isBook ? geometry::makeBookMesh() : geometry::makeBodyMesh(other->surface, other->size);
  const Eigen::Vector3d& size = isBook ? scene.motions.front().body.size : other->size;
  const Materials materials = isBook ? addMaterials(*cover, glb) : addMaterials(*other, mesh, glb);
  const bool hasPictures = isBook || !other->images.empty();
  Json primitives = Json::array();
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const geometry::MeshPart& part = mesh.parts[i];
    if (part.hidden || part.triangles.empty()) continue;
    primitives.push_back(
        primitiveOf(verticesOf(mesh, part, size.cast<float>()), materials.at(i), hasPictures, glb));
  }
  return glb.add("meshes", {{"name", isBook ? "book" : "body"}, {"primitives", primitives}});
}

}  // namespace rotatebook::interchange
