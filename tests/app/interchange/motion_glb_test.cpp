// The file is read back by the reader of meshes.
#include "interchange/motion_glb.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "body/glb_document.h"
#include "body/glb_numbers.h"
#include "body/mesh_readers.h"
#include "physics/simulate.h"
#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::interchange {
namespace {

using body::GlbDocument;
using body::GlbNumbers;
using Eigen::Quaterniond;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A throw as the starter's, of plain cloth, whose picture needn't be read.
scene::Scene sceneOf(const std::string& more = "", const std::string& spin = "5.0") {
  return scene::parseScene(R"(title = "Throw"
book.color = "#2b5d8a"
initial.angular_velocity = [)" +
                               spin + R"(, 0.0, 0.0]
initial.tilt = ["1 deg", "z"]
simulation.model = "exact"
)" + more,
                           "throw.toml");
}

/// Returns the document of a file, of which the reader of meshes leaves out what isn't a mesh's.
nlohmann::json documentOf(const std::string& glb) {
  constexpr std::size_t kLengthAt = 12, kDocumentAt = 20;
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + kLengthAt, sizeof length);
  return nlohmann::json::parse(glb.substr(kDocumentAt, length));
}

/// The keys of an animation's channel, and what programs show between them.
class Played {
 public:
  Played(const std::string& glb, std::size_t channel) {
    const nlohmann::json json = documentOf(glb);
    const GlbDocument document(glb);
    const auto& animation = json["animations"][0];
    const auto& sampler = animation["samplers"][channel];
    isCubic_ = sampler["interpolation"] == "CUBICSPLINE";
    const auto& target = animation["channels"][channel]["target"];
    path_ = target["path"].get<std::string>();
    const GlbNumbers times(document, sampler["input"], {"SCALAR", 1});
    for (std::size_t i = 0; i < times.count(); ++i) times_.push_back(times.at(i, 0));
    const bool isTurning = path_ == "rotation";
    const std::size_t columns = isTurning ? 4 : 3;
    const GlbNumbers values(document, sampler["output"], {isTurning ? "VEC4" : "VEC3", columns});
    for (std::size_t i = 0; i < values.count(); ++i) {
      Eigen::Vector4d row = Eigen::Vector4d::Zero();
      for (std::size_t k = 0; k < columns; ++k) row[static_cast<Eigen::Index>(k)] = values.at(i, k);
      rows_.push_back(row);
    }
  }

  const std::string& path() const { return path_; }
  const std::vector<double>& times() const { return times_; }
  /// Returns the value of a key.
  const Eigen::Vector4d& key(std::size_t i) const { return rows_[isCubic_ ? 3 * i + 1 : i]; }

  /// Returns the attitude at a time between the first key and the last, as glTF 2.0 has it
  /// (appendix C).
  Quaterniond attitudeAt(double time) const {
    const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
    const auto b = static_cast<std::size_t>(next - times_.begin()), a = b - 1;
    const double d = times_[b] - times_[a], t = (time - times_[a]) / d;
    if (!isCubic_) return Quaterniond(key(a)).slerp(t, Quaterniond(key(b)));
    const double t2 = t * t, t3 = t2 * t;
    return Quaterniond(Eigen::Vector4d((2 * t3 - 3 * t2 + 1) * key(a) +
                                       d * (t3 - 2 * t2 + t) * rows_[3 * a + 2] +
                                       (3 * t2 - 2 * t3) * key(b) + d * (t3 - t2) * rows_[3 * b]))
        .normalized();
  }

 private:
  bool isCubic_ = false;
  std::string path_;
  std::vector<double> times_;
  std::vector<Eigen::Vector4d> rows_;
};

/// Returns the most that the animation is off the motion at 1,000 times of the video. [degrees]
double errorOf(const scene::Scene& scene, const Played& played) {
  constexpr int kTimes = 1000;
  std::vector<double> shown, times;
  for (int i = 0; i < kTimes; ++i) {
    shown.push_back(played.times().back() * i / (kTimes - 1));
    times.push_back(timeAt(scene, shown.back() / scene.clip.frameRate.period()));
  }
  const auto motion = physics::simulate(scene.motions.front().motion(), times);
  double largest = 0;
  for (std::size_t i = 0; i < shown.size(); ++i)
    largest =
        std::max(largest, played.attitudeAt(shown[i]).angularDistance(motion.samples[i].attitude));
  return largest * 180 / std::numbers::pi;
}

double errorOf(const scene::Scene& scene, const GlbOptions& options) {
  const MotionGlb glb = motionGlb(scene, 0, options);
  const double error = errorOf(scene, Played(glb.bytes, 0));
  // Times are rounded to 32 bits: measured 1.4e-4
  EXPECT_NEAR(error, glb.errorDeg, 0.05 * error + 2e-4);
  return error;
}

TEST(MotionGlb, TurnsTheBodyAsTheMotionDoes) {
  const scene::Scene scene = sceneOf();
  EXPECT_LT(errorOf(scene, {}), 0.04);                                        // measured 0.030
  EXPECT_LT(errorOf(scene, {.keysPerSecond = 15, .tangents = true}), 0.002);  // measured 0.0015
  EXPECT_LT(errorOf(scene, {.tangents = true}), 2e-4);                        // measured 1.5e-4
  EXPECT_GT(errorOf(scene, {.keysPerSecond = 30}), 0.1);                      // measured 0.118
}

TEST(MotionGlb, TakesMoreKeysForAFastSpin) {
  const scene::Scene scene = sceneOf("clip.duration = 4\n", "20.0");
  EXPECT_GT(errorOf(scene, {.keysPerSecond = 60}), 0.4);  // measured 0.473
  EXPECT_LT(errorOf(scene, {}), 0.05);                    // measured 0.030
  EXPECT_EQ(motionGlb(scene, 0, {}).keys, 957U);
}

// It holds, and passes from speed to speed.
TEST(MotionGlb, GoesByTheClockOfTheVideo) {
  const scene::Scene scene = sceneOf(R"(clip.fps = 25
clip.speed = [{ from = 2, to = 4, value = 0.25 }, { from = 5, to = 6, value = 0 }]
)");
  EXPECT_LT(errorOf(scene, {}), 0.04);                  // measured 0.030
  EXPECT_LT(errorOf(scene, {.tangents = true}), 2e-4);  // measured 1.4e-4
  const MotionGlb glb = motionGlb(scene, 0, {});
  EXPECT_EQ(glb.keys, 718U);  // Up to the last of 300 frames, at 11.96 s
  EXPECT_NEAR(glb.seconds, 11.95, 1e-9);
}

TEST(MotionGlb, KeepsTheSignOfItsAttitudesAndItsTimesRise) {
  for (const bool tangents : {false, true}) {
    const std::string bytes = motionGlb(sceneOf(), 0, {.tangents = tangents}).bytes;
    const Played played(bytes, 0);
    ASSERT_EQ(played.times().size(), 720U);
    EXPECT_EQ(played.times().front(), 0);
    for (std::size_t i = 1; i < 720; ++i) {
      ASSERT_GT(played.times()[i], played.times()[i - 1]);
      ASSERT_GT(played.key(i).dot(played.key(i - 1)), 0.99) << i;
    }
    const nlohmann::json json = documentOf(bytes);
    const auto& input =
        json["accessors"][json["animations"][0]["samplers"][0]["input"].get<std::size_t>()];
    EXPECT_THAT(input["min"], ElementsAre(0));
    EXPECT_THAT(input["max"], ElementsAre(played.times().back()));
  }
}

TEST(MotionGlb, HoldsTheBookAsItLiesAtTheStart) {
  const scene::Scene scene = sceneOf();
  const body::Surface surface = body::readGlb(motionGlb(scene, 0, {}).bytes).surface;
  const auto start = physics::simulate(scene.motions.front().motion(), 1).samples.front();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& point : surface.mesh.points)
    points.push_back(start.attitude.conjugate() * point);
  const body::Box box = body::boxAround(points);
  EXPECT_TRUE((box.high - box.low).isApprox(scene.motions.front().body.size, 1e-4));
  EXPECT_GT(surface.mesh.triangles.size(), 1000U);
  // Those of the sides and the leaves, and the reader's own
  EXPECT_EQ(surface.materials.size(), 5U);
  EXPECT_EQ(surface.images.size(), 4U);
}

TEST(MotionGlb, IsSmallWithTheCover) {
  scene::Scene scene = sceneOf("clip.duration = 24\n");
  scene.book.colour.reset();
  EXPECT_LT(motionGlb(scene, 0, {}).bytes.size(), 400'000U);  // measured 291,060
}

TEST(MotionGlb, SaysWhatItIsOf) {
  const scene::Scene scene = sceneOf();
  const std::string bytes = motionGlb(scene, 0, {}).bytes;
  EXPECT_EQ(bytes.find(kGlbBeginning), 20U);
  const nlohmann::json extras = documentOf(bytes)["asset"]["extras"];
  EXPECT_EQ(scene::parseScene(extras["scene"].get<std::string>(), "throw.toml").motions,
            scene.motions);
  EXPECT_EQ(extras["motion_xxh128"], timeline::motionChecksum(timeline::simulateScene(scene)));
  EXPECT_TRUE(bytes == motionGlb(scene, 0, {}).bytes);
}

TEST(MotionGlb, TurnsTheCameraWithItsFrame) {
  const scene::Scene scene = sceneOf("camera.frame = \"body\"\n");
  const std::string bytes = motionGlb(scene, 0, {}).bytes;
  const Played body(bytes, 0), place(bytes, 1), camera(bytes, 2);
  EXPECT_EQ(place.path(), "translation");
  // The camera sees the book at rest
  const auto seen = [&](std::size_t i) {
    return Quaterniond(camera.key(i)).conjugate() * Quaterniond(body.key(i));
  };
  double largest = 0;
  for (std::size_t i = 0; i < 720; ++i)
    largest = std::max(largest, seen(i).angularDistance(seen(0)));
  EXPECT_LT(largest, 1e-6);  // measured 1.2e-7
  EXPECT_GT((place.key(300) - place.key(0)).norm(), 0.1);
  EXPECT_EQ(documentOf(motionGlb(sceneOf(), 0, {}).bytes)["animations"][0]["channels"].size(), 1U);
}

TEST(MotionGlb, HasOtherBodiesAndPanels) {
  const scene::Scene scene = scene::parseScene(R"([initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
duration = 0.2
[[panel]]
label = "one"
[[panel]]
label = "disc"
body = { shape = "disc" }
)",
                                               "two.toml");
  const std::string bytes = motionGlb(scene, 1, {}).bytes;
  const nlohmann::json document = documentOf(bytes);
  EXPECT_EQ(document["asset"]["extras"]["panel"], "disc");
  EXPECT_EQ(document["materials"].size(), 1U);
  EXPECT_THAT(body::readGlb(bytes).surface.images, IsEmpty());
}

std::string refusalOf(const scene::Scene& scene) {
  try {
    motionGlb(scene, 0, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MotionGlb, IsRefusedWhereABodyDeformsOrThereAreManyMotions) {
  EXPECT_EQ(refusalOf(sceneOf()), "accepted");
  scene::Scene particles = sceneOf();
  particles.motions.front().simulation.model = physics::Model::Particles;
  EXPECT_THAT(refusalOf(particles), HasSubstr("deforms the body"));
  EXPECT_THAT(refusalOf(sceneOf("grid.columns = { key = \"body.mass\", values = [1, 2] }\n")),
              HasSubstr("grid has many"));
  scene::Scene stretched = sceneOf();
  physics::SimulationSettings& steps = stretched.motions.front().simulation;
  steps.model = physics::Model::Matrix;
  steps.integrator = physics::Integrator::Euler;
  steps.normalizeEvery = 0;
  steps.substeps = 10;
  EXPECT_THAT(refusalOf(stretched), HasSubstr("stretch or shrink the body by up to"));
}

TEST(MotionGlb, SaysThatItsKeysAreTooFew) {
  EXPECT_THAT(motionGlb(sceneOf(), 0, {}).notes, IsEmpty());
  EXPECT_THAT(motionGlb(sceneOf(), 0, {.keysPerSecond = 3}).notes,
              ElementsAre(HasSubstr("take more keys")));
}

}  // namespace
}  // namespace rotatebook::interchange
