// What pages draw: the camera and the meshes of bodies.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bridge/bridge.h"
#include "browser/bridge/bridge_slots.h"
#include "geometry/camera.h"
#include "scene/scene_text.h"
#include "timeline/scene_camera.h"

namespace rotatebook::bridge {
namespace {

using testing::context;
using testing::giveFile;
using ::testing::HasSubstr;
using testing::kAll;
using testing::kFrames;
using testing::kScene;
using testing::put;
using testing::read;
using testing::readAnew;
using testing::taken;
using testing::with;

TEST(Bridge, HasNoCameraOfWhatIsntThere) {
  readAnew(0, std::string(kScene) + "[camera]\nfollow = \"size\"\n");
  rb_advance(context(), 0, kAll, kAll);
  const std::array<double, 2> straight{0, 0};
  std::array<float, 16> matrix{}, sky{};
  std::array<float, 3> eye{};
  const auto camera = [&](std::int32_t slot, std::int32_t motion, std::int32_t frame, float width) {
    return rb_camera(context(), slot, motion, frame, width, 90, straight.data(), 1, matrix.data(),
                     eye.data(), sky.data());
  };
  EXPECT_EQ(camera(-1, 0, 0, 160), 0);
  EXPECT_EQ(camera(0, 1, 0, 160), 0);
  EXPECT_EQ(camera(0, -1, 0, 160), 0);
  EXPECT_EQ(eye[2], 0) << "nothing is written";
  for (const std::int32_t frame : {-5, kFrames, 1'000'000'000}) {
    EXPECT_EQ(camera(0, 0, frame, 160), 1);
    EXPECT_GT(eye[2], 0);
  }
  for (const float width : {0.0f, -1e30f, 1e30f, std::nanf("")}) {
    EXPECT_EQ(camera(0, 0, 0, width), 1) << width;
  }
}

// Where the program's picture of a corner is, but with y up.
TEST(Bridge, HasTheProgramsCamera) {
  read(0, kScene);
  const std::array<double, 2> straight{0, 0}, turned{0.3, 0};
  std::array<float, 16> matrix{}, sky{};
  std::array<float, 3> eye{};
  rb_camera(context(), 0, 0, 0, 1280, 720, straight.data(), 1, matrix.data(), eye.data(),
            sky.data());
  const scene::Scene scene = scene::parseScene(kScene, "scene.toml");
  const geometry::Screen screen{1280, 720, 0};
  const body::Cage cage = scene.motions[0].body.corners();
  const auto projection = geometry::project(timeline::cameraOf(scene, screen), cage, screen);
  constexpr double kBound = 1e-6;  // measured 6e-8
  const auto difference = [&] {
    const Eigen::Matrix4d clipFromWorld = Eigen::Map<Eigen::Matrix4f>(matrix.data()).cast<double>();
    const Eigen::Vector4d here = clipFromWorld * cage.col(6).homogeneous();
    const Eigen::Vector4d there = projection.clipFromWorld * cage.col(6).homogeneous();
    return (Eigen::Vector2d(here.x(), -here.y()) / here.w() - there.head<2>() / there.w()).norm();
  };
  EXPECT_LT(difference(), kBound);
  EXPECT_NEAR(eye[2], scene.cameraPosition.z(), kBound);
  rb_camera(context(), 0, 0, 0, 1280, 720, turned.data(), 1, matrix.data(), eye.data(), sky.data());
  EXPECT_GT(difference(), 0.01) << "of a camera that is turned";
}

TEST(Bridge, HasTheBooksMesh) {
  std::int32_t count = 0;
  const float* vertices = rb_mesh_vertices(context(), &count);
  EXPECT_GT(count, 1000);
  for (std::int32_t i = 0; i < count; ++i) {
    EXPECT_GE(vertices[13 * i], 0) << "position in the unit cube";
    EXPECT_LE(vertices[13 * i], 1);
    EXPECT_GE(vertices[13 * i + 9], 1) << "number of a surface";
  }
  for (std::int32_t part = 0; part < 5; ++part) {
    std::int32_t indexCount = 0;
    const std::uint16_t* indices = rb_mesh_indices(context(), part, &indexCount);
    EXPECT_GT(indexCount, 0);
    EXPECT_EQ(indexCount % 3, 0);
    for (std::int32_t i = 0; i < indexCount; ++i) EXPECT_LT(indices[i], count);
  }
}

TEST(Bridge, HasTheMeshesOfOtherBodies) {
  read(0, kScene);
  EXPECT_EQ(taken(rb_body(context(), 0, 0)), "null") << "the book";
  EXPECT_LT(rb_body(context(), 0, 1), 0) << "no such motion";
  read(0, "[body]\nshape = \"t-handle\"\n[initial]\nangular_velocity = [4, 0, 0]\n");
  const std::string json = taken(rb_body(context(), 0, 0));
  EXPECT_THAT(json, HasSubstr("\"parts\":[{\"first\":0,"));
  const std::size_t vertices = std::stoul(json.substr(json.find(':') + 1));
  EXPECT_GT(vertices, 1000U);
  for (std::size_t i = 0; i < vertices; ++i) {
    EXPECT_GE(rb_body_vertices(context())[13 * i], -1e-6) << "position in the unit cube";
    EXPECT_LE(rb_body_vertices(context())[13 * i], 1 + 1e-6);
  }
  for (std::size_t i = 0; i < 300; ++i) EXPECT_LT(rb_body_indices(context())[i], vertices);
}

TEST(Bridge, ReadsMeshesThatItWasGiven) {
  constexpr std::string_view kName = "a.obj";
  constexpr std::string_view kTetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  constexpr std::string_view kBody =
      "[body]\nmesh = \"a.obj\"\ndensity = 1\n[initial]\nangular_velocity = [4, 0, 0]\n";
  EXPECT_LT(rb_read(context(), 0, put(kBody)), 0);
  giveFile(kName, kTetrahedron);
  read(0, kBody);
  EXPECT_THAT(taken(rb_body(context(), 0, 0)), HasSubstr("\"vertices\":12,\"indices\":12"));
  // Of a record, which has the numbers alone, a box is drawn
  const std::string record = taken(rb_scene_text(context(), 0));
  ASSERT_EQ(rb_file(context(), 0, 0), 0);
  read(0, record);
  EXPECT_THAT(taken(rb_body(context(), 0, 0)), HasSubstr("\"indices\":2148"));
}

}  // namespace
}  // namespace rotatebook::bridge
