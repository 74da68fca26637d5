// How pictures lie on the surfaces of .glb files.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "body/message_of.h"
#include "meshes/glb_box.h"
#include "meshes/mesh_readers.h"
#include "messages.h"

namespace rotatebook::meshes {
namespace {

using body::testing::messageOf;
using Eigen::Vector2f;
using testing::BoxFile;
using testing::bytesOf;
using ::testing::ElementsAre;
using testing::forEachPoint;
using ::testing::IsEmpty;

constexpr const char* kPictures =
    R"(, "textures": [{"source": 0}], "images": [{"uri": "data:image/png;base64,UE5H"}])";

/// Returns the box with a material, two sets of texture coordinates, (0.25, 0.5) and (0.75, 1), and
/// a picture.
BoxFile pictured(const std::string& material, const std::string& pictures = kPictures) {
  BoxFile file{.primitive = ", \"material\": 0"};
  file.addAttribute("TEXCOORD_0", "VEC2", 5126, forEachPoint(bytesOf({0.25F, 0.5F})));
  file.addAttribute("TEXCOORD_1", "VEC2", 5126, forEachPoint(bytesOf({0.75F, 1.0F})));
  file.root = R"(, "materials": [{"pbrMetallicRoughness": {)" + material + "}}]" + pictures;
  return file;
}

body::Surface lookOf(const BoxFile& file) {
  const body::ClosedMesh read = readMesh("a.glb", file.bytes());
  if (!read.undrawable.empty()) throw InputError(read.undrawable);
  return read.surface;
}

Vector2f coordinatesOf(const std::string& use) {
  const body::Surface surface = lookOf(pictured("\"baseColorTexture\": {\"index\": 0" + use + "}"));
  EXPECT_EQ(surface.texCoords.size(), 12U);
  return surface.texCoords.at(11)[2];
}

std::vector<std::string> notesOf(const BoxFile& file) {
  return readMesh("a.glb", file.bytes()).closing.notes;
}

TEST(GlbPictures, LieBySecondTextureCoordinates) {
  EXPECT_EQ(coordinatesOf(""), Vector2f(0.25F, 0.5F));
  EXPECT_EQ(coordinatesOf(R"(, "texCoord": 1)"), Vector2f(0.75F, 1));
}

// As glTF's own example: a quarter turn that shows the lower left quarter.
TEST(GlbPictures, AreScaledTurnedAndMoved) {
  const auto changed = [](const std::string& transform) {
    return coordinatesOf(R"(, "extensions": {"KHR_texture_transform": {)" + transform + "}}");
  };
  EXPECT_EQ(changed(R"("scale": [4, 2])"), Vector2f(1, 1));
  EXPECT_EQ(changed(R"("offset": [4, 2])"), Vector2f(4.25F, 2.5F));
  EXPECT_EQ(changed(R"("texCoord": 1)"), Vector2f(0.75F, 1));
  const Vector2f turned =
      changed(R"("offset": [0, 1], "rotation": 1.5707963267948966, "scale": [0.5, 0.5])");
  EXPECT_LT((turned - Vector2f(0.25F, 0.875F)).norm(), 1e-7);
  EXPECT_MESSAGE(messageOf([&] { changed(R"("scale": [1])"); }));
  EXPECT_MESSAGE(messageOf([&] { changed(R"("rotation": 1e9)"); }));
}

TEST(GlbPictures, LieByWholeNumbersAsShares) {
  BoxFile file{.primitive = ", \"material\": 0"};
  file.root =
      std::string(
          R"(, "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])") +
      kPictures;
  file.addAttribute("TEXCOORD_0", "VEC2", 5123,
                    forEachPoint(bytesOf<std::uint16_t>({65535, 13107})), ", \"normalized\": true");
  EXPECT_EQ(lookOf(file).texCoords.at(0)[0], Vector2f(1, 0.2F));
}

TEST(GlbPictures, MayBeInTheDescription) {
  const body::Surface surface = lookOf(pictured("\"baseColorTexture\": {\"index\": 0}"));
  EXPECT_THAT(surface.images, ElementsAre("PNG"));
}

TEST(GlbPictures, MayBeWebP) {
  const body::Surface surface =
      lookOf(pictured("\"baseColorTexture\": {\"index\": 0}",
                      R"(, "textures": [{"extensions": {"EXT_texture_webp": {"source": 0}}}],
         "images": [{"uri": "data:image/webp;base64,UklGRg=="}])"));
  EXPECT_THAT(surface.images, ElementsAre("RIFF"));
}

TEST(GlbPictures, AreReadAsTheirSamplersSay) {
  const auto samplingsOf = [](const std::string& sampler) {
    return lookOf(pictured(R"("baseColorTexture": {"index": 0},
                              "metallicRoughnessTexture": {"index": 1})",
                           R"(, "textures": [{"source": 0}, {"source": 0, "sampler": 0}],
         "samplers": [{)" + sampler +
                               R"(}], "images": [{"uri": "data:image/png;base64,UE5H"}])"));
  };
  const body::Surface mixed = samplingsOf(R"("wrapS": 33071, "wrapT": 33648, "magFilter": 9728)");
  EXPECT_THAT(mixed.images, ElementsAre("PNG", "PNG"));
  EXPECT_THAT(
      mixed.samplings,
      ElementsAre(body::Sampling{}, body::Sampling{body::Wrap::Clamp, body::Wrap::Mirror, true}));
  EXPECT_EQ(mixed.materials[0].metalRoughnessImage, 1);
  const body::Surface same = samplingsOf(R"("wrapS": 10497, "minFilter": 9728, "magFilter": 9729)");
  EXPECT_THAT(same.images, ElementsAre("PNG"));
  EXPECT_THAT(same.samplings, ElementsAre(body::Sampling{}));
}

TEST(GlbPictures, ThatArentDrawnAreNoted) {
  const BoxFile other = pictured(R"("baseColorTexture": {"index": 0},
                                    "metallicRoughnessTexture": {"index": 0, "texCoord": 1})");
  EXPECT_THAT(notesOf(other),
              ElementsAre("the picture of a material's metalness and roughness, whose texture "
                          "coordinates aren't those of its colour, isn't drawn"));
  EXPECT_EQ(lookOf(other).materials[0].metalRoughnessImage, body::kNoImage);
  const BoxFile ktx =
      pictured("\"baseColorTexture\": {\"index\": 0}",
               R"(, "textures": [{"extensions": {"KHR_texture_basisu": {"source": 0}}}],
         "images": [{"uri": "a.ktx2"}])");
  EXPECT_THAT(notesOf(ktx),
              ElementsAre("a material's picture that is neither PNG, JPEG nor WebP isn't drawn"));
  EXPECT_EQ(lookOf(ktx).materials[0].baseColourImage, body::kNoImage);
  BoxFile coloured;
  coloured.addAttribute("COLOR_0", "VEC4", 5126, forEachPoint(bytesOf({1.0F, 0.0F, 0.0F, 1.0F})));
  EXPECT_THAT(notesOf(coloured), ElementsAre("its vertex colours aren't drawn"));
  EXPECT_THAT(notesOf(pictured(R"("baseColorTexture": {"index": 0, "texCoord": 2})")),
              ElementsAre("a mesh without TEXCOORD_2 has one colour of its picture"));
  EXPECT_THAT(notesOf(pictured(R"("baseColorTexture": {"index": 0},
                                  "metallicRoughnessTexture": {"index": 0})")),
              IsEmpty());
}

TEST(GlbMaterials, ThatArentDrawnAsTheyAreAreNoted) {
  const auto notesOfMaterial = [](const std::string& material) {
    BoxFile file{.primitive = ", \"material\": 0"};
    file.root = ", \"materials\": [{" + material + "}]";
    return notesOf(file);
  };
  EXPECT_THAT(notesOfMaterial(R"("alphaMode": "OPAQUE", "emissiveFactor": [0, 0, 0])"), IsEmpty());
  EXPECT_THAT(notesOfMaterial(R"("alphaMode": "BLEND")"),
              ElementsAre("its transparency isn't drawn"));
  EXPECT_THAT(notesOfMaterial(R"("emissiveFactor": [0, 0.5, 0])"),
              ElementsAre("the light of its materials isn't drawn"));
  const std::string specular =
      R"("extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [1, 0, 0, 1]}})";
  EXPECT_THAT(notesOfMaterial(specular),
              ElementsAre("colours of KHR_materials_pbrSpecularGlossiness aren't drawn"));
  EXPECT_THAT(notesOfMaterial(specular + R"(, "pbrMetallicRoughness": {})"), IsEmpty());
}

}  // namespace
}  // namespace rotatebook::meshes
