#include "timeline/trajectory_csv.h"

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/small_scene.h"

namespace rotatebook::timeline {
namespace {

using ::testing::ElementsAre;

constexpr const char* kHeader =
    "frame,time_s,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,kinetic_J,potential_J,total_J,tilt_deg,half_turns,"
    "stretch_min,stretch_max,c0x,c0y,c0z,c1x,c1y,c1z,c2x,c2y,c2z,c3x,c3y,c3z,c4x,c4y,c4z,"
    "c5x,c5y,c5z,c6x,c6y,c6z,c7x,c7y,c7z,error_deg,energy_ratio,L_ratio,regime,centre_drift_m,last_"
    "flip_s";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  if (text.ends_with(separator)) parts.emplace_back();
  return parts;
}

// A motion with every number different from the others, and springs that are stretched.
physics::Trajectory particleMotion() {
  return scene::testing::motionOf(
      scene::testing::smallScene({"simulation.model=particles", "simulation.damping=0.2"}));
}

// Returns the numbers that a row must hold, in the header's order; the frame's comes before them.
std::vector<double> valuesOf(const physics::Sample& sample, const physics::Sample& start) {
  const Eigen::Quaterniond& q = sample.attitude;
  const Eigen::Vector3d& w = sample.angularVelocity;
  const Eigen::Vector3d& L = sample.angularMomentum;
  std::vector<double> values = {sample.time,
                                q.w(),
                                q.x(),
                                q.y(),
                                q.z(),
                                w.x(),
                                w.y(),
                                w.z(),
                                L.x(),
                                L.y(),
                                L.z(),
                                sample.kinetic,
                                sample.potential,
                                sample.kinetic + sample.potential,
                                sample.tiltDeg,
                                static_cast<double>(sample.halfTurns),
                                sample.stretchMin,
                                sample.stretchMax};
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) values.push_back(sample.cage(axis, corner));
  }
  values.push_back(sample.errorDeg);
  values.push_back(sample.total() / start.total());
  values.push_back(L.norm() / start.angularMomentum.norm());
  values.push_back(static_cast<int>(sample.regime));
  values.push_back(sample.centreDrift());
  return values;
}

TEST(TrajectoryCsv, HasTheNamesOfTheContract) {
  const std::string csv = trajectoryCsv(particleMotion());
  EXPECT_EQ(csv.substr(0, csv.find('\n')), kHeader);
}

TEST(TrajectoryCsv, HasOneRowAFrame) {
  const std::vector<std::string> rows = split(trajectoryCsv(particleMotion()), '\n');
  ASSERT_EQ(rows.size(), 1 + scene::testing::kFrames);
  for (std::size_t frame = 0; frame < scene::testing::kFrames; ++frame) {
    const std::vector<std::string> cells = split(rows[frame + 1], ',');
    EXPECT_EQ(cells.size(), split(kHeader, ',').size());
    EXPECT_EQ(cells[0], std::to_string(frame));
  }
}

TEST(TrajectoryCsv, ReadsBackBitForBit) {
  const physics::Trajectory trajectory = particleMotion();
  EXPECT_GT(trajectory.samples.back().potential, 0);
  EXPECT_GT(trajectory.samples.back().errorDeg, 0);
  const std::vector<std::string> rows = split(trajectoryCsv(trajectory), '\n');
  const std::vector<std::string> names = split(kHeader, ',');
  for (std::size_t frame = 0; frame < trajectory.samples.size(); ++frame) {
    const std::vector<std::string> cells = split(rows.at(frame + 1), ',');
    const std::vector<double> wanted = valuesOf(trajectory.samples[frame], trajectory.samples[0]);
    ASSERT_EQ(cells.size(), wanted.size() + 2);  // the frame, and the last flip
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double read = std::strtod(cells[i + 1].c_str(), nullptr);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(wanted[i]))
          << names[i + 1] << " of frame " << frame << ": " << cells[i + 1];
    }
  }
}

TEST(TrajectoryCsv, HasTheTimeOfTheLastFlip) {
  physics::Trajectory motion;
  for (int n = 0; n < 5; ++n) {
    physics::Sample& sample = motion.samples.emplace_back();
    sample.time = n / 4.0;
    sample.halfTurns = n == 0 ? 0 : n < 3 ? 1 : 3;
  }
  std::vector<std::string> lastCells;
  for (const std::string& row : split(trajectoryCsv(motion), '\n')) {
    lastCells.push_back(split(row, ',').back());
  }
  EXPECT_THAT(lastCells, ElementsAre("last_flip_s", "", "0.25", "0.25", "0.75", "0.75"));
}

TEST(TrajectoryCsv, EndsEachRowWithALineFeed) {
  const std::string csv = trajectoryCsv(particleMotion());
  EXPECT_EQ(csv.back(), '\n');
  EXPECT_EQ(csv.find('\r'), std::string::npos);
}

}  // namespace
}  // namespace rotatebook::timeline
