#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "body/mass_properties.h"
#include "body/message_of.h"
#include "meshes/glb_files.h"
#include "meshes/mesh_readers.h"
#include "messages.h"

namespace rotatebook::meshes {
namespace {

using body::testing::messageOf;
using testing::boxData;
using testing::boxIn;
using testing::glb;
using testing::kAccessors;

TEST(GlbReader, ReadsTheBodiesOfAScene) {
  const body::TriangleMesh mesh =
      readMesh("a.glb", boxIn(R"("scene": 1, "scenes": [{}, {"nodes": [0]}],
                                 "nodes": [{"mesh": 0}, {"mesh": 0}])"))
          .surface.mesh;
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_DOUBLE_EQ(body::massPropertiesOf(mesh, 1).volume, 6);
}

TEST(GlbReader, PutsNodesInTheirPlaces) {
  const body::TriangleMesh mesh =
      readMesh("a.glb",
               boxIn(R"("nodes": [{"children": [1], "translation": [10, 0, 0], "scale": [2, 2, 2]},
                       {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}])"))
          .surface.mesh;
  const body::MassProperties found = body::massPropertiesOf(mesh, 1);
  EXPECT_NEAR(found.volume, 48, 1e-12);                         // measured 7e-15
  EXPECT_NEAR(found.centre.x(), 10, 1e-12);                     // measured 0
  EXPECT_NEAR(found.inertia(0, 0), 48 * 4 * 10 / 12.0, 1e-11);  // of sides 4, 2, 6; measured 3e-14
  EXPECT_NEAR(found.inertia(2, 2), 48 * 4 * 5 / 12.0, 1e-11);   // measured 2e-14
}

TEST(GlbReader, KeepsTheOutsideOfAMirroredNode) {
  const body::TriangleMesh mesh =
      readMesh("a.glb",
               boxIn(R"("nodes": [{"mesh": 0, "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 5,0,0,1]}])"))
          .surface.mesh;
  EXPECT_DOUBLE_EQ(body::massPropertiesOf(mesh, 1).volume, 6);
}

TEST(GlbReader, SaysWhatItCannotRead) {
  const std::string node = R"("nodes": [{"mesh": 0}])";
  const auto withChange = [&](const std::string& from, const std::string& to) {
    std::string json = "{" + node + "," + kAccessors;
    json.replace(json.find(from), from.size(), to);
    return messageOf([&] { readGlb(glb(json, boxData())); });
  };
  EXPECT_EQ(withChange("VEC3", "VEC3"), "accepted");
  EXPECT_MESSAGE(withChange("VEC3", "VEC2"));
  EXPECT_MESSAGE(withChange("5126", "5124"));
  EXPECT_MESSAGE(withChange("5126", "5125"));
  EXPECT_MESSAGE(withChange("\"count\": 8", "\"count\": 9"));
  EXPECT_MESSAGE(withChange("\"count\": 8", "\"count\": 7"));
  EXPECT_MESSAGE(withChange("\"count\": 36", "\"count\": 35"));
  EXPECT_MESSAGE(withChange("\"byteLength\": 72", "\"byteLength\": 71"));
  EXPECT_MESSAGE(withChange("\"byteLength\": 96", "\"byteLength\": 96, \"byteStride\": 4"));
  EXPECT_MESSAGE(withChange("\"byteOffset\": 96", "\"byteOffset\": 97"));
  EXPECT_MESSAGE(withChange("\"bufferView\": 1", "\"bufferView\": 2"));
  EXPECT_MESSAGE(withChange("\"bufferView\": 1,", ""));
  EXPECT_MESSAGE(withChange("\"indices\": 1", "\"indices\": 1, \"mode\": 7"));
  EXPECT_MESSAGE(withChange("\"POSITION\": 0", "\"NORMAL\": 0"));
  EXPECT_MESSAGE(withChange("\"indices\": 1", "\"indices\": 1, \"material\": 0"));
  EXPECT_MESSAGE(withChange("{\"byteLength\": 168}", "{\"uri\": \"a.bin\"}"));
  EXPECT_MESSAGE(withChange("{\"mesh\": 0}", "{\"mesh\": 1}"));
  EXPECT_MESSAGE(withChange("{\"mesh\": 0}", "{\"mesh\": -1}"));
  EXPECT_MESSAGE(withChange("{\"mesh\": 0}", "{\"children\": [\"a\"]}"));
  EXPECT_MESSAGE(withChange("{\"mesh\": 0}", "{\"mesh\": 4294967296}"));
  EXPECT_MESSAGE(withChange("{\"mesh\": 0}", "{\"scale\": [1, 2]}"));
  EXPECT_MESSAGE(withChange("\"nodes\"", "\"scenes\": [{\"nodes\": [3]}], \"nodes\""));
  EXPECT_MESSAGE(withChange("\"nodes\": [{\"mesh\": 0}]",
                            R"("scenes": [{"nodes": [0]}], "nodes": [{"children": [0]}])"));
}

/// Returns the box with a material, and with texture coordinates that are its positions.
std::string boxWithMaterial(const std::string& material, const std::string& image) {
  std::string json = std::string("{\"nodes\": [{\"mesh\": 0}],") + kAccessors;
  const auto replace = [&json](const std::string& from, const std::string& to) {
    json.replace(json.find(from), from.size(), to);
  };
  replace("\"POSITION\": 0", "\"POSITION\": 0, \"TEXCOORD_0\": 2");
  replace("\"indices\": 1", "\"indices\": 1, \"material\": 1");
  replace("\"type\": \"SCALAR\"}", R"("type": "SCALAR"},
    {"bufferView": 2, "componentType": 5126, "count": 8, "type": "VEC2"})");
  replace("\"byteLength\": 72}", R"("byteLength": 72},
    {"buffer": 0, "byteLength": 96, "byteStride": 12}, {"buffer": 0, "byteOffset": 4, "byteLength": 4})");
  json.pop_back();
  return glb(json + R"(, "materials": [{}, {"pbrMetallicRoughness": )" + material +
                 R"(}], "textures": [{"source": 0}], "images": [)" + image + "]}",
             boxData());
}

TEST(GlbReader, ReadsMaterials) {
  const body::Surface surface =
      readGlb(
          boxWithMaterial(
              R"({"baseColorFactor": [0.5, 0.25, 1, 1], "metallicFactor": 0, "roughnessFactor": 0.75,
          "baseColorTexture": {"index": 0}})",
              R"({"bufferView": 3, "mimeType": "image/png"})"))
          .surface;
  ASSERT_EQ(surface.materials.size(), 3U);
  const body::Material& material = surface.materials[surface.materialOf.at(0)];
  EXPECT_EQ(material.baseColour, Eigen::Vector3f(0.5F, 0.25F, 1));
  EXPECT_EQ(material.metalness, 0);
  EXPECT_EQ(material.roughness, 0.75F);
  EXPECT_EQ(material.baseColourImage, 0);
  EXPECT_EQ(material.metalRoughnessImage, body::kNoImage);
  ASSERT_EQ(surface.images.size(), 1U);
  EXPECT_EQ(surface.images[0], boxData().substr(4, 4));
  ASSERT_EQ(surface.texCoords.size(), surface.mesh.triangles.size());
  const Eigen::Vector3d& corner = surface.mesh.points[surface.mesh.triangles[0][0]];
  EXPECT_EQ(surface.texCoords[0][0], corner.head<2>().cast<float>().eval());
}

TEST(GlbReader, RefusesMaterialsThatAreNone) {
  const auto messageFor = [](const std::string& material, const std::string& image) {
    const NotedSurface read = readGlb(boxWithMaterial(material, image));
    EXPECT_EQ(read.surface.mesh.triangles.size(), 12U);
    EXPECT_EQ(read.surface.materials.size(), 1U);
    return read.undrawable;
  };
  const std::string kTexture = R"({"baseColorTexture": {"index": 0}})";
  EXPECT_MESSAGE(messageFor(R"({"metallicFactor": 2})", "{}"));
  EXPECT_MESSAGE(messageFor(R"({"baseColorFactor": [1, "a"]})", "{}"));
  EXPECT_MESSAGE(messageFor(R"({"baseColorTexture": {"index": 1}})", "{}"));
  EXPECT_MESSAGE(messageFor(kTexture, R"({"uri": "a.png"})"));
  EXPECT_MESSAGE(messageFor(kTexture, R"({"bufferView": 9})"));
}

// Each of a thousand nodes has the mesh, whose primitives have no points.
TEST(GlbReader, RefusesManyPrimitives) {
  const auto repeated = [](const std::string& text, int count) {
    std::string list = text;
    for (int i = 1; i < count; ++i) list += "," + text;
    return "[" + list + "]";
  };
  const std::string json =
      "{\"nodes\": " + repeated("{\"mesh\": 0}", 1000) +
      ", \"meshes\": [{\"primitives\": " + repeated("{\"attributes\": {\"POSITION\": 0}}", 1000) +
      R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 0, "type": "VEC3"}],
         "bufferViews": [{"buffer": 0}], "buffers": [{}]})";
  EXPECT_MESSAGE(messageOf([&] { readGlb(glb(json, "")); }));
}

TEST(GlbReader, HasAPictureOnce) {
  const std::string image = R"({"bufferView": 3})";
  std::string bytes = boxWithMaterial(
      R"({"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}})",
      image + "," + image);
  const std::string one = "\"textures\": [{\"source\": 0}]";
  // Of the same length, since the file states it
  const std::string two = "\"textures\":[{},{\"source\":1}]";
  ASSERT_EQ(one.size(), two.size() - 1);
  bytes.replace(bytes.find(one) - 1, one.size() + 1, two);
  const body::Surface surface = readGlb(bytes).surface;
  EXPECT_EQ(surface.images.size(), 1U);
  EXPECT_EQ(surface.materials[1].metalRoughnessImage, 0);
}

TEST(GlbReader, RefusesWhatIsNoGlb) {
  EXPECT_MESSAGE(messageOf([] { readGlb(""); }));
  EXPECT_MESSAGE(messageOf([] { readGlb("glTF\x01\0\0\0\0\0\0\0"); }));
  EXPECT_MESSAGE(messageOf([] { readGlb(std::string("glTF\x01\0\0\0\0\0\0\0", 12)); }));
  EXPECT_MESSAGE(messageOf([] { readGlb(std::string("glTF\x02\0\0\0\0\0\0\0", 12)); }));
  EXPECT_MESSAGE(messageOf([] { readGlb(std::string("glTF\x02\0\0\0\x0c\0\0\0", 12)); }));
  EXPECT_MESSAGE(messageOf([] { readGlb(glb("[1]", "")); }));
  EXPECT_MESSAGE(messageOf([] { readGlb(glb("{", "")); }));
  EXPECT_MESSAGE(messageOf([] { readGlb(glb(std::string(1 << 20, '['), "")); }));
  const std::string whole = boxIn(R"("nodes": [{"mesh": 0}])");
  EXPECT_MESSAGE(messageOf([&] { readGlb(std::string_view(whole).substr(0, whole.size() - 1)); }));
}

}  // namespace
}  // namespace rotatebook::meshes
