// What .glb files have and need beside a plain mesh.
#include <chrono>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "body/glb_box.h"
#include "body/mass_properties.h"
#include "body/mesh_readers.h"
#include "body/message_of.h"

namespace rotatebook::body {
namespace {

using ::testing::AllOf;
using testing::BoxFile;
using testing::bytesOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::messageOf;
using ::testing::Not;

std::string saidOf(const BoxFile& file) {
  return messageOf([&] { readMesh("a.glb", file.bytes()); });
}

BoxFile needing(const std::string& extension) {
  return {.root = R"(, "extensionsRequired": ["KHR_materials_unlit", ")" + extension + "\"]"};
}

TEST(GlbExtensions, OfLooksAreOfNoMatterToTheShape) {
  for (const char* name :
       {"KHR_texture_transform", "KHR_materials_variants", "KHR_materials_transmission",
        "KHR_lights_punctual", "EXT_lights_image_based", "EXT_texture_webp", "KHR_texture_basisu",
        "MSFT_texture_dds", "KHR_xmp_json_ld", "KHR_animation_pointer", "VRMC_materials_mtoon",
        "EXT_structural_metadata", "KHR_mesh_quantization", "KHR_node_visibility"})
    EXPECT_EQ(saidOf(needing(name)), "accepted") << name;
}

TEST(GlbExtensions, OfCompressionAreRefusedWithTheirRemedy) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    EXPECT_THAT(saidOf(needing(name)),
                AllOf(HasSubstr(name), HasSubstr("export it without compression")));
  }
}

TEST(GlbExtensions, ThatArentKnownAreRefused) {
  EXPECT_THAT(
      saidOf(needing("ACME_shape")),
      AllOf(HasSubstr("needs the extension \"ACME_shape\""),
            HasSubstr("may change its shape; export it without"), Not(HasSubstr("compression"))));
}

// Whole numbers of 2 bytes, which the node makes 1, 2 and 3 long.
TEST(GlbExtensions, OfQuantisedPositionsAreRead) {
  BoxFile file;
  std::string points, normalised;
  for (std::int16_t i = 0; i < 8; ++i) {
    const auto side = [&](int bit) { return static_cast<std::int16_t>((i >> bit & 1) * 100); };
    points += bytesOf({side(0), side(1), side(2), std::int16_t{0}});
    for (int bit = 0; bit < 3; ++bit) normalised += (i >> bit & 1) != 0 ? '\x7f' : '\x81';
    normalised += '\0';
  }
  file.add("VEC3", 5122, 8, points);
  file.views.replace(file.views.rfind('}'), 1, ", \"byteStride\": 8}");
  file.nodes = R"({"mesh": 0, "scale": [0.01, 0.02, 0.03]})";
  std::string bytes = file.bytes();
  bytes.replace(bytes.find("\"POSITION\": 0"), 13, "\"POSITION\": 2");
  EXPECT_NEAR(massPropertiesOf(readMesh("a.glb", bytes).mesh, 1).volume, 6, 1e-14);
  BoxFile bytesFile;
  bytesFile.add("VEC3", 5120, 8, normalised, ", \"normalized\": true");
  bytesFile.views.replace(bytesFile.views.rfind('}'), 1, ", \"byteStride\": 4}");
  bytes = bytesFile.bytes();
  bytes.replace(bytes.find("\"POSITION\": 0"), 13, "\"POSITION\": 2");
  EXPECT_DOUBLE_EQ(massPropertiesOf(readMesh("a.glb", bytes).mesh, 1).volume, 8);
}

// Edges and corners beside the triangles, as programs for engineers export them.
TEST(GlbReader, LeavesLinesAndPointsOut) {
  for (const char* mode : {"0", "1", "2", "3"}) {
    BoxFile file;
    file.primitive = std::string(R"(}, {"attributes": {"POSITION": 0}, "mode": )") + mode;
    const ClosedMesh read = readMesh("a.glb", file.bytes());
    EXPECT_EQ(read.mesh.triangles.size(), 12U);
    EXPECT_THAT(read.closing.notes,
                ElementsAre("points and lines have no volume, and are left out"));
  }
  BoxFile file;
  file.primitive = ", \"mode\": 1";
  EXPECT_THAT(saidOf(file), HasSubstr("there are no triangles (points and lines have no volume"));
}

// The sides as a strip, one end as a fan, the other as a list.
TEST(GlbReader, TakesStripsAndFans) {
  BoxFile file;
  const auto add = [&](const std::string& indices, int count, const char* mode) {
    file.primitive += R"(}, {"attributes": {"POSITION": 0}, "indices": )" +
                      std::to_string(file.add("SCALAR", 5121, count, indices)) +
                      ", \"mode\": " + mode;
  };
  add(bytesOf<std::uint8_t>({0, 4, 2, 6, 3, 7, 1, 5, 0, 4}), 10, "5");
  add(bytesOf<std::uint8_t>({0, 2, 3, 1}), 4, "6");
  std::string bytes = file.bytes();
  const std::string indices = "\"count\": 36";
  // Of the list, the last quad alone
  bytes.replace(bytes.find(indices), indices.size(), "\"count\": 6 ");
  const std::string offset = "\"byteOffset\": 96, \"byteLength\": 72";
  bytes.replace(bytes.find(offset), offset.size(), "\"byteOffset\":156, \"byteLength\": 12");
  const ClosedMesh read = readMesh("a.glb", bytes);
  EXPECT_EQ(read.mesh.triangles.size(), 12U);
  EXPECT_DOUBLE_EQ(massPropertiesOf(read.mesh, 1).volume, 6);
}

std::string base64Of(const std::string& bytes) {
  constexpr const char* kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      bits = bits << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (int shift = 18; shift >= 0; shift -= 6) text += kLetters[bits >> shift & 63];
  }
  if (bytes.size() % 3 != 0) text.replace(text.size() - (3 - bytes.size() % 3), 2, "==");
  return text;
}

TEST(GlbReader, TakesDataInItsDescription) {
  BoxFile file;
  std::string bytes = file.bytes();
  const auto with = [&](const std::string& uri) {
    std::string json = bytes.substr(20, bytes.find("\"buffers\"") - 20);
    return testing::glb(json + R"("buffers": [{"uri": ")" + uri + "\"}]}", "");
  };
  const std::string uri = "data:application/octet-stream;base64,";
  const ClosedMesh read = readMesh("a.glb", with(uri + base64Of(testing::boxData())));
  EXPECT_DOUBLE_EQ(massPropertiesOf(read.mesh, 1).volume, 6);
  const auto said = [&](const std::string& other) {
    return messageOf([&] { readMesh("a.glb", with(other)); });
  };
  EXPECT_THAT(said("data:text/plain,a"), HasSubstr("data that isn't base64"));
  EXPECT_THAT(said(uri + "AA*A"), HasSubstr("data that isn't base64"));
  EXPECT_THAT(said(uri + "AAAA"), HasSubstr("reaches beyond"));
  EXPECT_THAT(said("box.bin"), HasSubstr("its data is in another file"));
}

TEST(GlbReader, TakesDescriptionsThatArePaddedWithZeros) {
  BoxFile file{.root = "}" + std::string(3, '\0')};
  std::string bytes = file.bytes();
  bytes.replace(bytes.find(std::string(3, '\0') + "}"), 4, 4, '\0');
  EXPECT_EQ(readMesh("a.glb", bytes).mesh.triangles.size(), 12U);
}

// A buffer without an address is the file's own data only if it is the first.
TEST(GlbReader, RefusesDataThatIsntThere) {
  BoxFile file{.buffers = "{}, {}"};
  file.add("VEC3", 5126, 8, testing::boxData().substr(0, 96));
  file.views.replace(file.views.find('{'), 1, "{\"buffer\": 1, ");
  std::string bytes = file.bytes();
  bytes.replace(bytes.find("\"POSITION\": 0"), 13, "\"POSITION\": 2");
  EXPECT_THAT(messageOf([&] { readMesh("a.glb", bytes); }), HasSubstr("reaches beyond the file's"));
  file = BoxFile();
  file.accessors = R"(, {"componentType": 5126, "count": 8, "type": "VEC3"})";
  bytes = file.bytes();
  bytes.replace(bytes.find("\"POSITION\": 0"), 13, "\"POSITION\": 2");
  EXPECT_THAT(messageOf([&] { readMesh("a.glb", bytes); }),
              HasSubstr("its numbers aren't in the file, or are compressed"));
}

// 15 MB of objects in a list that nothing uses.
TEST(GlbReader, TakesTimeInProportionToTheDescription) {
  BoxFile file;
  file.root = ", \"extras\": [{}";
  for (int i = 0; i < 5'000'000; ++i) file.root += ",{}";
  file.root += "]";
  const std::string bytes = file.bytes();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(readMesh("a.glb", bytes).mesh.triangles.size(), 12U);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(seconds.count(), 30);  // measured 0.6; it was hours
}

}  // namespace
}  // namespace rotatebook::body
