// Tables of a book's motions, as other programs and instruments write them, right or wrong.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "base/number_text.h"
#include "physics/recorded_start.h"
#include "physics/simulate.h"
#include "recording/gyroscope.h"
#include "recording/read_recording.h"
#include "timeline/judge.h"

namespace rotatebook::timeline {

inline constexpr double kDegree = 0.017453292519943295;  ///< [rad]

/// Moments of the book that is thrown. [kg m^2]
inline const Eigen::Vector3d kThrownBook{0.0041667, 0.0020083, 0.0059083};

/// Returns the book's throw about its middle axis, one step a frame for 10 s.
inline physics::MotionSettings thrownBook(physics::Integrator integrator = physics::Integrator::Rk4,
                                          double framesASecond = 60) {
  physics::MotionSettings motion;
  motion.inertia = kThrownBook.asDiagonal();
  motion.initial.value = {6.28, 0, 0.0628};
  motion.simulation.integrator = integrator;
  motion.simulation.substeps = 1;
  motion.simulation.timePerFrame = 1 / framesASecond;
  return motion;
}

inline physics::MotionSettings exactBook(double framesASecond = 60) {
  physics::MotionSettings motion = thrownBook(physics::Integrator::Rk4, framesASecond);
  motion.simulation.model = physics::Model::Exact;
  return motion;
}

/// What a table has, and is wrong about.
struct Table {
  std::string time = "time_s";
  std::string rates = "wx,wy,wz";  // names; empty for attitudes alone
  bool areAlongBody = false;
  bool isInverse = false;
  bool isScalarLast = false;  // though the columns are called qw, qx, qy, qz
  double secondsPerUnit = 1, ratesPerUnit = 1;
  double noise = 0;       // standard deviation of the attitudes [rad]
  double rateNoise = 0;   // [rad/s]
  double rateStep = 0;    // that the rates are rounded to; not if 0 [rad/s]
  double seconds = 10;    // duration
  double ratesDelay = 0;  // in rows
  bool isTurned = true;   // so that the attitudes don't begin with the identity
  Eigen::Matrix3d columns = Eigen::Matrix3d::Identity();  // of the rates, which it is applied to
  Eigen::Vector3d bias{0, 0, 0};                          // of them [rad/s]
  Eigen::Quaterniond bodyTurn = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond worldTurn = Eigen::Quaterniond::Identity();  // both of the attitudes alone
  std::function<void(std::vector<physics::Sample>&)> spoil{};     // the samples
  std::uint64_t seed = 1;
};

/// Normal numbers, the same everywhere.
class Noise {
 public:
  explicit Noise(std::uint64_t seed = 1) : state_(seed) {}
  double next() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) {
      state_ = state_ * 6364136223846793005U + 1442695040888963407U;
      sum += static_cast<double>(state_ >> 11) / 9007199254740992.0;
    }
    return sum;
  }
  Eigen::Vector3d vector() { return {next(), next(), next()}; }

 private:
  std::uint64_t state_;
};

inline std::string rowOf(const physics::Sample& sample, const physics::Sample& ofRates,
                         const Table& table, Noise& noise) {
  Eigen::Quaterniond q = sample.attitude * recording::rotationBy(table.noise * noise.vector());
  Eigen::Vector3d rate = ofRates.angularVelocity;
  if (table.areAlongBody) rate = ofRates.attitude.conjugate() * rate;
  rate =
      (table.columns * rate + table.bias + table.rateNoise * noise.vector()) / table.ratesPerUnit;
  if (table.rateStep > 0) rate = (rate / table.rateStep).array().round().matrix() * table.rateStep;
  q = table.worldTurn * q * table.bodyTurn;
  if (table.isInverse) q = q.conjugate();
  std::vector<double> cells{sample.time / table.secondsPerUnit, q.w(), q.x(), q.y(), q.z()};
  if (table.isScalarLast) cells = {cells[0], q.x(), q.y(), q.z(), q.w()};
  if (!table.rates.empty()) cells.insert(cells.end(), {rate.x(), rate.y(), rate.z()});
  std::string row;
  for (const double cell : cells) row += (row.empty() ? "" : ",") + shortestText(cell);
  return row + "\n";
}

/// Returns the table's text of a motion.
inline std::string textOf(const physics::MotionSettings& motion, const Table& table) {
  const auto count =
      static_cast<std::int64_t>(table.seconds / motion.simulation.timePerFrame + 1.5);
  physics::Trajectory trajectory = physics::simulate(motion, count);
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  Noise noise(table.seed);
  if (table.spoil) table.spoil(trajectory.samples);
  std::string text =
      table.time + ",qw,qx,qy,qz" + (table.rates.empty() ? "" : "," + table.rates) + "\n";
  for (physics::Sample& sample : trajectory.samples) {
    if (!table.isTurned) break;
    sample.attitude = turned * sample.attitude;
    sample.angularVelocity = turned * sample.angularVelocity;
  }
  const physics::Sample* before = &trajectory.samples.front();
  for (const physics::Sample& sample : trajectory.samples) {
    text += rowOf(sample, table.ratesDelay > 0 ? *before : sample, table, noise);
    before = &sample;
  }
  return text;
}

/// Returns the verdict on a table, of a body with these moments.
inline Verdict verdictOnText(const std::string& text, const Eigen::Vector3d& moments = kThrownBook,
                             const recording::ReadOptions& options = {}) {
  physics::MotionSettings motion;
  motion.inertia = moments.asDiagonal();
  auto recorded =
      std::make_shared<recording::RecordedMotion>(recording::readRecording(text, "m.csv", options));
  std::vector<double> times;
  for (const auto& moment : recorded->moments()) times.push_back(moment.time);
  physics::takeRecording(motion, recorded, "m.csv");
  return judge(motion, physics::simulate(motion, times));
}

}  // namespace rotatebook::timeline
