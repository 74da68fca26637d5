// Skeletons, morph targets, and what else moves the points of a .glb file.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "body/mass_properties.h"
#include "body/message_of.h"
#include "meshes/glb_box.h"
#include "meshes/mesh_readers.h"
#include "messages.h"

namespace rotatebook::meshes {
namespace {

using body::testing::messageOf;
using testing::BoxFile;
using testing::bytesOf;
using ::testing::ElementsAre;
using testing::forEachPoint;

body::MassProperties propertiesOf(const BoxFile& file) {
  return body::massPropertiesOf(readMesh("a.glb", file.bytes()).surface.mesh, 1);
}

std::string saidOfPose(const BoxFile& file) {
  return messageOf([&] { readMesh("a.glb", file.bytes()); });
}

/// Returns the box bound to one joint, node 1, whose binding moves it by (-1, 0, 0) at first.
BoxFile skinned(const std::string& nodes) {
  BoxFile file{.nodes = nodes};
  file.addAttribute("JOINTS_0", "VEC4", 5121, forEachPoint(std::string(4, '\0')));
  file.addAttribute("WEIGHTS_0", "VEC4", 5126, forEachPoint(bytesOf({1.0F, 0.0F, 0.0F, 0.0F})));
  const int bindings = file.add("MAT4", 5126, 1,
                                bytesOf({1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F,  //
                                         0.0F, 0.0F, 1.0F, 0.0F, -1.0F, 0.0F, 0.0F, 1.0F}));
  file.root =
      R"(, "skins": [{"joints": [1], "inverseBindMatrices": )" + std::to_string(bindings) + "}]";
  return file;
}

// A node's own place isn't that of a mesh with a skin.
TEST(GlbSkeleton, ReplacesThePlaceOfItsNode) {
  const body::MassProperties found = propertiesOf(
      skinned(R"({"mesh": 0, "skin": 0, "scale": [100, 100, 100], "translation": [5, 5, 5]}, {})"));
  EXPECT_DOUBLE_EQ(found.volume, 6);
  EXPECT_LT((found.centre - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-15);  // measured 0
}

// The joint is a child of another node: 2 x 3 as large, at 10 + 2 x (4 + 3 x -1).
TEST(GlbSkeleton, PosesTheMeshByItsJoints) {
  const body::MassProperties found = propertiesOf(
      skinned(R"({"mesh": 0, "skin": 0}, {"translation": [4, 0, 0], "scale": [3, 3, 3]},
                 {"children": [1], "translation": [10, 0, 0], "scale": [2, 2, 2]})"));
  EXPECT_NEAR(found.volume, 6 * 216, 1e-10);                            // measured 0
  EXPECT_LT((found.centre - Eigen::Vector3d(12, 0, 0)).norm(), 1e-13);  // measured 0
}

TEST(GlbSkeleton, KeepsTheOutsideWhereItMirrors) {
  const auto found = propertiesOf(
      skinned(R"({"mesh": 0, "skin": 0, "scale": [-1, 1, 1]}, {"scale": [-2, 1, 1]})"));
  EXPECT_DOUBLE_EQ(found.volume, 12);
}

// Half of each of two joints, one of which is 2 further along z; as bytes and shorts.
TEST(GlbSkeleton, BlendsJoints) {
  BoxFile file{.nodes = R"({"mesh": 0, "skin": 0}, {}, {"translation": [0, 0, 2]})"};
  file.addAttribute("JOINTS_0", "VEC4", 5123, forEachPoint(bytesOf<std::uint16_t>({0, 0, 1, 0})));
  file.addAttribute("WEIGHTS_0", "VEC4", 5121, forEachPoint(std::string("\x40\0\x40\0", 4)),
                    ", \"normalized\": true");
  file.root = R"(, "skins": [{"joints": [1, 2]}])";
  const body::MassProperties found = propertiesOf(file);
  EXPECT_DOUBLE_EQ(found.volume, 6);
  EXPECT_LT((found.centre - Eigen::Vector3d(0, 0, 1)).norm(), 1e-15);  // measured 0
}

TEST(GlbSkeleton, IsRefusedWhereItIsBroken) {
  BoxFile file{.nodes = R"({"mesh": 0, "skin": 0}, {})"};
  EXPECT_MESSAGE(saidOfPose(file));
  file.root = R"(, "skins": [{"joints": [1]}])";
  EXPECT_MESSAGE(saidOfPose(file));
  BoxFile other = skinned(R"({"mesh": 0, "skin": 0}, {"children": [1]})");
  EXPECT_MESSAGE(saidOfPose(other));
  other = skinned(R"({"mesh": 0, "skin": 0}, {})");
  other.root = R"(, "skins": [{"joints": []}])";
  EXPECT_MESSAGE(saidOfPose(other));
  other.root = R"(, "skins": [{"joints": [7]}])";
  EXPECT_MESSAGE(saidOfPose(other));
  other.root = R"(, "skins": [{"joints": [1, 1], "inverseBindMatrices": 4}])";
  EXPECT_MESSAGE(saidOfPose(other));
}

/// Returns the box with a morph target that moves its upper points (z = 1.5) up by 3.
BoxFile morphed(const std::string& weights) {
  BoxFile file{.mesh = ", \"weights\": " + weights};
  std::string shifts;
  for (int i = 0; i < 8; ++i) shifts += bytesOf({0.0F, 0.0F, i < 4 ? 0.0F : 3.0F});
  const int shift = file.add("VEC3", 5126, 8, shifts);
  file.primitive = R"(, "targets": [{}, {"POSITION": )" + std::to_string(shift) + "}]";
  return file;
}

TEST(GlbMorph, MovesPointsByItsWeights) {
  EXPECT_DOUBLE_EQ(propertiesOf(morphed("[0, 0]")).volume, 6);
  EXPECT_DOUBLE_EQ(propertiesOf(morphed("[1, 0]")).volume, 6);
  EXPECT_DOUBLE_EQ(propertiesOf(morphed("[0, 1]")).volume, 12);
  EXPECT_DOUBLE_EQ(propertiesOf(morphed("[0, 0.5]")).volume, 9);
  BoxFile file = morphed("[0, 1]");
  file.nodes = R"({"mesh": 0, "weights": [0, 2]})";
  EXPECT_DOUBLE_EQ(propertiesOf(file).volume, 18) << "a node's weights are before its mesh's";
}

TEST(GlbMorph, IsRefusedWhereItIsBroken) {
  EXPECT_MESSAGE(saidOfPose(morphed("[0, \"a\"]")));
  BoxFile file = morphed("[0, 1]");
  file.primitive = R"(, "targets": [{}, {"POSITION": 1}])";
  EXPECT_MESSAGE(saidOfPose(file));
}

// Zeros, of which the rows from 4 on are replaced.
TEST(GlbMorph, MayBeSparse) {
  BoxFile file = morphed("[0, 1]");
  const std::string rows = bytesOf<std::uint8_t>({4, 5, 6, 7});
  std::string values;
  for (int i = 0; i < 4; ++i) values += bytesOf({0.0F, 0.0F, 6.0F});
  const int places = file.add("SCALAR", 5121, 4, rows), shifts = file.add("VEC3", 5126, 4, values);
  file.accessors += R"(, {"componentType": 5126, "count": 8, "type": "VEC3", "sparse": {"count": 4,
      "indices": {"componentType": 5121, "bufferView": )" +
                    std::to_string(places) + R"(}, "values": {"bufferView": )" +
                    std::to_string(shifts) + "}}}";
  file.primitive = R"(, "targets": [{}, {"POSITION": )" + std::to_string(file.accessorCount) + "}]";
  EXPECT_DOUBLE_EQ(propertiesOf(file).volume, 18);
  BoxFile wrong = file;
  wrong.data[wrong.data.size() - values.size() - 4] = 9;  // a row that isn't there
  EXPECT_MESSAGE(saidOfPose(wrong));
}

TEST(GlbReader, LeavesHiddenNodesOut) {
  BoxFile file;
  file.nodes =
      R"({"mesh": 0, "children": [1]}, {"mesh": 0, "translation": [9, 0, 0], "extensions":
         {"KHR_node_visibility": {"visible": false}}, "children": [2]}, {"mesh": 0})";
  const body::ClosedMesh read = readMesh("a.glb", file.bytes());
  EXPECT_DOUBLE_EQ(body::massPropertiesOf(read.surface.mesh, 1).volume, 6);
  EXPECT_THAT(read.closing.notes, ElementsAre("nodes that the file hides are left out"));
}

TEST(GlbReader, RefusesCopiesThatItWouldMiss) {
  BoxFile file;
  file.nodes = R"({"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {}}}})";
  EXPECT_MESSAGE(saidOfPose(file));
}

}  // namespace
}  // namespace rotatebook::meshes
