// Bodies that deform, by morphs of their corners.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/mesh.h"
#include "meshes/glb_document.h"
#include "meshes/glb_numbers.h"
#include "meshes/mesh_readers.h"
#include "messages.h"
#include "physics/simulate.h"
#include "picture/interchange/motion_file.h"
#include "picture/interchange/played.h"

namespace rotatebook::interchange {
namespace {

using Eigen::Vector3d;
using testing::documentOf;
using ::testing::IsEmpty;
using testing::Played;
using testing::sceneOf;

/// Eight particles and springs as soft as those of scenes/particles-soft.toml.
scene::Scene softScene(const std::string& more = "") {
  scene::Scene scene = sceneOf("clip.duration = 4\n" + more);
  physics::SimulationSettings& steps = scene.motions.front().simulation;
  steps.model = physics::Model::Particles;
  steps.stiffness = 4;
  return scene;
}

/// The morphs of a file's first part.
class Morphs {
 public:
  explicit Morphs(std::string glb)
      : bytes_(std::move(glb)), document_(bytes_), json_(documentOf(bytes_)) {
    base = vectorsOf(json_["meshes"][0]["primitives"][0]["attributes"]["POSITION"]);
    normals = vectorsOf(json_["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]);
    const auto& sampler = json_["animations"][0]["samplers"][1];
    const meshes::GlbNumbers numbers(document_, sampler["output"], {"SCALAR", 1});
    for (std::size_t i = 0; i < numbers.count(); ++i) weights.push_back(numbers.at(i, 0));
    for (int corner = 0; corner < 8; ++corner) reach += targetOf(corner, 0, "POSITION")[0].x() / 2;
  }

  /// Returns what a corner does by its weight along an axis.
  std::vector<Vector3d> targetOf(int corner, int axis, const char* attribute) const {
    return vectorsOf(json_["meshes"][0]["primitives"][0]["targets"]
                          [static_cast<std::size_t>(3 * corner + axis)][attribute]);
  }
  /// Returns the corners' displacements at a share of the time from a key to the next.
  body::Cage displacementsAt(std::size_t key, double share) const {
    body::Cage all;
    for (std::size_t i = 0; i < 24; ++i) {
      const double weight =
          (1 - share) * weights[24 * key + i] + share * weights[24 * key + 24 + i];
      all(static_cast<int>(i) % 3, static_cast<int>(i) / 3) = (2 * weight - 1) * reach;
    }
    return all;
  }

  std::vector<Vector3d> base, normals;
  std::vector<double> weights;
  double reach = 0;  // [m]

 private:
  std::vector<Vector3d> vectorsOf(std::size_t accessor) const {
    const meshes::GlbNumbers numbers(document_, accessor, {"VEC3", 3});
    std::vector<Vector3d> all;
    for (std::size_t i = 0; i < numbers.count(); ++i) all.push_back(numbers.vectorAt(i));
    return all;
  }

  std::string bytes_;
  meshes::GlbDocument document_;
  nlohmann::json json_;
};

/// Returns the most that a corner is off at 1,000 times of the video. [m]
double cornerErrorOf(const scene::Scene& scene, const std::string& glb) {
  const Played turning(glb, 0);
  const Morphs morphs(glb);
  std::vector<double> shown, times;
  for (int i = 0; i < 1000; ++i) {
    shown.push_back(turning.times().back() * i / 1000);
    times.push_back(timeAt(scene, shown.back() / scene.clip.frameRate.period()));
  }
  const auto motion = physics::simulate(scene.motions.front().motion(), times);
  const double perSecond = static_cast<double>(turning.times().size() - 1) / turning.times().back();
  double largest = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double at = shown[i] * perSecond;
    const auto key = static_cast<std::size_t>(at);
    const body::Cage corners = scene.motions.front().body.corners() +
                               morphs.displacementsAt(key, at - static_cast<double>(key));
    const Eigen::Matrix3d attitude = turning.attitudeAt(shown[i]).toRotationMatrix();
    largest = std::max(largest,
                       (attitude * corners - motion.samples[i].cage).colwise().norm().maxCoeff());
  }
  return largest;
}

TEST(DeformingGlb, MovesItsCornersAsTheMotionDoes) {
  const scene::Scene scene = softScene();
  const MotionFile file = motionGlb(scene, 0, {});
  EXPECT_LT(cornerErrorOf(scene, file.bytes), 8e-5);  // measured 7.3e-5
  ASSERT_TRUE(file.errorM);
  EXPECT_NEAR(cornerErrorOf(scene, file.bytes), *file.errorM, 4e-7);  // measured 1.9e-7
  EXPECT_THAT(file.notes, IsEmpty());
  EXPECT_GT(cornerErrorOf(scene, motionGlb(scene, 0, {.keysPerSecond = 30}).bytes),
            2.5e-4);  // measured 2.9e-4
}

// Others clamp them to that.
TEST(DeformingGlb, HasWeightsFrom0To1) {
  const Morphs morphs(motionGlb(softScene(), 0, {}).bytes);
  const auto [least, most] = std::ranges::minmax(morphs.weights);
  EXPECT_GE(least, 0);
  EXPECT_LE(most, 1);
  EXPECT_TRUE(least == 0 || most == 1);
  EXPECT_GT(morphs.reach, 0.02);  // measured 0.022
}

TEST(DeformingGlb, IsTrilinearInItsCorners) {
  const scene::Scene scene = softScene();
  const Morphs morphs(motionGlb(scene, 0, {}).bytes);
  const body::Cage corners = scene.motions.front().body.corners();
  double largest = 0;  // [m]
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Vector3d> places(morphs.base.size(), Vector3d::Zero()), sums = places;
    for (int corner = 0; corner < 8; ++corner) {
      const std::vector<Vector3d> target = morphs.targetOf(corner, axis, "POSITION");
      for (std::size_t i = 0; i < target.size(); ++i) {
        places[i] += target[i][axis] / (2 * morphs.reach) * corners.col(corner);
        sums[i] += target[i];
      }
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vector3d still = morphs.base[i] + Vector3d::Constant(morphs.reach);
      largest = std::max(largest, (places[i] - still).norm());
      largest = std::max(largest, (sums[i] - 2 * morphs.reach * Vector3d::Unit(axis)).norm());
    }
  }
  EXPECT_LT(largest, 5e-8);  // measured 3.2e-8
}

/// Returns how the normal of a vertex turns as a corner begins to move along an axis.
Vector3d turnOf(const Vector3d& normal, const Vector3d& unitPosition, const Vector3d& size,
                int corner, int axis) {
  constexpr double kApart = 1e-3, kMove = 1e-5;  // [m]
  const auto weightAt = [&](const Vector3d& at) {
    return geometry::trilinearWeights(at.cast<float>())[corner];
  };
  const Vector3d across = normal.unitOrthogonal(), beside = normal.cross(across);
  const auto moved = [&](const Vector3d& tangent) -> Vector3d {
    const Vector3d step = kApart * tangent.cwiseQuotient(size);
    const double rise =
        (weightAt(unitPosition + step) - weightAt(unitPosition - step)) / (2 * kApart);
    return tangent + kMove * rise * Vector3d::Unit(axis);
  };
  return (moved(across).cross(moved(beside)).normalized() - normal) / kMove;
}

TEST(DeformingGlb, TurnsItsNormals) {
  const scene::Scene scene = softScene();
  const Morphs morphs(motionGlb(scene, 0, {}).bytes);
  const Vector3d& size = scene.motions.front().body.size;
  double largest = 0, most = 0;
  for (int target = 0; target < 24; ++target) {
    const std::vector<Vector3d> turns = morphs.targetOf(target / 3, target % 3, "NORMAL");
    for (std::size_t i = 0; i < turns.size(); i += 37) {
      const Vector3d at = (morphs.base[i] + Vector3d::Constant(morphs.reach)).cwiseQuotient(size) +
                          Vector3d::Constant(0.5);
      const Vector3d turn =
          2 * morphs.reach * turnOf(morphs.normals[i], at, size, target / 3, target % 3);
      largest = std::max(largest, (turns[i] - turn).norm());
      most = std::max(most, turn.norm());
    }
  }
  EXPECT_LT(largest, 1e-3);  // measured 7.1e-4, as smaller turns are left out
  EXPECT_GT(most, 0.8);      // measured 0.90
}

TEST(DeformingGlb, HoldsTheBookAsItLiesAtTheStart) {
  const scene::Scene scene = softScene();
  const body::Box box =
      body::boxAround(meshes::readGlb(motionGlb(scene, 0, {}).bytes).surface.mesh.points);
  EXPECT_TRUE(
      (box.high - box.low).isApprox(scene.motions.front().body.size, 1e-6));  // measured 5e-8
  EXPECT_LT((box.high + box.low).norm(), 1e-8);                               // measured 5.1e-9
}

TEST(DeformingGlb, IsSmallWithTheCover) {
  scene::Scene scene = softScene();
  scene.clip.duration = 24;
  scene.book.colour.reset();
  EXPECT_LT(motionGlb(scene, 0, {}).bytes.size(), 900'000U);  // measured 898,872
}

// A motion whose steps stretch the book, too.
TEST(DeformingGlb, GrowsAndTheCameraDrawsBack) {
  scene::Scene scene = sceneOf("camera.follow = \"size\"\nclip.duration = 24\n");
  physics::SimulationSettings& steps = scene.motions.front().simulation;
  steps.model = physics::Model::Matrix;
  steps.integrator = physics::Integrator::Euler;
  steps.normalizeEvery = 0;
  steps.substeps = 10;
  const std::string bytes = motionGlb(scene, 0, {}).bytes;
  EXPECT_GT(Morphs(bytes).reach, 0.1);  // measured 0.107
  const Played place(bytes, 2);
  EXPECT_EQ(place.path(), "translation");
  EXPECT_GT(place.key(1400).norm(), 1.5 * place.key(0).norm());  // measured 1.555
}

TEST(DeformingGlb, IsRefusedWithTangentsAndAsUsdz) {
  const scene::Scene scene = softScene();
  const auto refusalOf = [&](auto exported, const KeyOptions& options) -> std::string {
    try {
      exported(scene, 0, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_MESSAGE(refusalOf(motionGlb, {.tangents = true}));
  EXPECT_MESSAGE(refusalOf(motionUsdz, {}));
}

// It isn't seen, and costs half of the file.
TEST(DeformingGlb, LeavesOutWhatNobodySees) {
  scene::Scene scene = softScene();
  scene.motions.front().simulation.stiffness = 2000;
  const MotionFile file = motionGlb(scene, 0, {});
  EXPECT_FALSE(file.errorM);
  EXPECT_EQ(documentOf(file.bytes)["animations"][0]["channels"].size(), 1U);
  EXPECT_LT(file.errorDeg, 0.05);  // measured 0.030
}

}  // namespace
}  // namespace rotatebook::interchange
