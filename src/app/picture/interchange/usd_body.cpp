#include "picture/interchange/usd_body.h"

#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <fmt/core.h>

namespace rotatebook::interchange {
namespace {

using Eigen::Vector3f;

std::string nameOf(const ExportedBody& body, std::size_t material) {
  const std::string& name = body.materials[material].name;
  return name.empty() ? fmt::format("material_{}", material + 1) : name;
}

/// Returns the list of what `field` has in each part.
template <typename Item>
std::vector<Item> joined(const ExportedBody& body, std::vector<Item> ExportedPart::*field) {
  std::vector<Item> all;
  for (const ExportedPart& part : body.parts)
    all.insert(all.end(), (part.*field).begin(), (part.*field).end());
  return all;
}

void addTriangles(const ExportedBody& body, UsdLayer& layer) {
  const auto number = [](auto n) { return std::to_string(n); };
  std::vector<std::uint32_t> corners;
  std::uint32_t first = 0;
  for (const ExportedPart& part : body.parts) {
    for (const std::uint32_t corner : part.corners) corners.push_back(first + corner);
    first += static_cast<std::uint32_t>(part.positions.size());
  }
  layer.list("int[] faceVertexCounts", std::vector<int>(corners.size() / 3, 3), number);
  layer.list("int[] faceVertexIndices", corners, number);
}

void addVertices(const ExportedBody& body, UsdLayer& layer) {
  const auto vertex = [](const auto& v) { return usdText(v); };
  const auto perVertex = [&] {
    layer.line("interpolation = \"vertex\"");
    layer.close();
  };
  const std::vector<Vector3f> points = joined(body, &ExportedPart::positions);
  Vector3f low = points.front(), high = points.front();
  for (const Vector3f& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  layer.list("float3[] extent", std::vector<Vector3f>{low, high}, vertex);
  layer.list("point3f[] points", points, vertex);
  layer.list("normal3f[] normals", joined(body, &ExportedPart::normals), vertex, '(');
  perVertex();
  if (body.pictures.empty()) return;
  layer.list("texCoord2f[] primvars:st", joined(body, &ExportedPart::texCoords), vertex, '(');
  perVertex();
}

/// Binds the triangles of each part to its material.
void addSubsets(const ExportedBody& body, const std::string& materials, UsdLayer& layer) {
  layer.line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
  int face = 0;
  for (const ExportedPart& part : body.parts) {
    std::vector<int> faces;
    for (std::size_t i = 0; i < part.corners.size(); i += 3) faces.push_back(face++);
    const std::string name = nameOf(body, part.material);
    layer.open(fmt::format("def GeomSubset \"{}\"", name), '(');
    layer.line("prepend apiSchemas = [\"MaterialBindingAPI\"]");
    layer.close();
    layer.open("");
    layer.line("uniform token elementType = \"face\"");
    layer.line("uniform token familyName = \"materialBind\"");
    layer.list("int[] indices", faces, [](int n) { return std::to_string(n); });
    layer.line(fmt::format("rel material:binding = <{}/{}>", materials, name));
    layer.close();
  }
}

const char* usdWrap(body::Wrap wrap) {
  if (wrap == body::Wrap::Repeat) return "repeat";
  return wrap == body::Wrap::Clamp ? "clamp" : "mirror";
}

/// Adds the reader of a picture, whose values are multiplied by `factors`.
void addReader(const ExportedBody& body, std::size_t picture, const char* name,
               const std::string& path, const Eigen::Vector4f& factors, UsdLayer& layer) {
  const bool isColour = std::string_view(name) == "colour";
  const body::Sampling& sampling = body.pictures[picture].sampling;
  layer.open(fmt::format("def Shader \"{}\"", name));
  layer.line("uniform token info:id = \"UsdUVTexture\"");
  layer.line(fmt::format("asset inputs:file = @{}@", pictureName(body, picture)));
  layer.line(fmt::format("token inputs:sourceColorSpace = \"{}\"", isColour ? "sRGB" : "raw"));
  layer.line(fmt::format("float2 inputs:st.connect = <{}/st.outputs:result>", path));
  layer.line(fmt::format("token inputs:wrapS = \"{}\"", usdWrap(sampling.across)));
  layer.line(fmt::format("token inputs:wrapT = \"{}\"", usdWrap(sampling.down)));
  layer.line(fmt::format("float4 inputs:scale = ({}, {}, {}, {})", factors[0], factors[1],
                         factors[2], factors[3]));
  if (isColour) {
    layer.line("float3 outputs:rgb");
  } else {
    layer.line("float outputs:g");
    layer.line("float outputs:b");
  }
  layer.close();
}

void addSurface(const ExportedMaterial& material, const std::string& path, UsdLayer& layer) {
  const auto input = [&](const char* type, const char* name, const char* connected,
                         const std::string& value) {
    layer.line(connected != nullptr
                   ? fmt::format("{} inputs:{}.connect = <{}/{}>", type, name, path, connected)
                   : fmt::format("{} inputs:{} = {}", type, name, value));
  };
  layer.open("def Shader \"surface\"");
  layer.line("uniform token info:id = \"UsdPreviewSurface\"");
  input("color3f", "diffuseColor", material.colourPicture ? "colour.outputs:rgb" : nullptr,
        usdText(material.colour));
  input("float", "roughness", material.metalPicture ? "metal.outputs:g" : nullptr,
        fmt::format("{}", material.roughness));
  input("float", "metallic", material.metalPicture ? "metal.outputs:b" : nullptr,
        fmt::format("{}", material.metalness));
  layer.line("token outputs:surface");
  layer.close();
}

void addMaterialPrim(const ExportedBody& body, std::size_t index, const std::string& materials,
                     UsdLayer& layer) {
  const ExportedMaterial& material = body.materials[index];
  const std::string path = materials + "/" + nameOf(body, index);
  layer.open(fmt::format("def Material \"{}\"", nameOf(body, index)));
  layer.line(fmt::format("token outputs:surface.connect = <{}/surface.outputs:surface>", path));
  addSurface(material, path, layer);
  if (material.colourPicture || material.metalPicture) {
    layer.open("def Shader \"st\"");
    layer.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
    layer.line("string inputs:varname = \"st\"");
    layer.line("float2 outputs:result");
    layer.close();
  }
  const Vector3f& colour = material.colour;
  if (material.colourPicture)
    addReader(body, *material.colourPicture, "colour", path,
              {colour.x(), colour.y(), colour.z(), 1}, layer);
  if (material.metalPicture)
    addReader(body, *material.metalPicture, "metal", path,
              {1, material.roughness, material.metalness, 1}, layer);
  layer.close();
}

}  // namespace

std::string pictureName(const ExportedBody& body, std::size_t picture) {
  return fmt::format("pictures/{}.{}", picture + 1, body.pictures[picture].isPng() ? "png" : "jpg");
}

void addBody(const ExportedBody& body, const std::string& parent, UsdLayer& layer) {
  const std::string materials = parent + "/materials";
  layer.open(fmt::format("def Mesh \"{}\"", body.name));
  layer.line("uniform token subdivisionScheme = \"none\"");
  addTriangles(body, layer);
  addVertices(body, layer);
  addSubsets(body, materials, layer);
  layer.close();
  layer.open("def Scope \"materials\"");
  for (std::size_t i = 0; i < body.materials.size(); ++i)
    addMaterialPrim(body, i, materials, layer);
  layer.close();
}

}  // namespace rotatebook::interchange
