#include "engines/record.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "base/error.h"
#include "engines/comparison.h"

namespace rotatebook::bench {
namespace {

constexpr int kRecordedASecond = 60;

/// A mode that is recorded, and the name of its file.
struct Recorded {
  std::string_view family;  // the beginning of its name
  std::size_t mode;         // its index
  const char* file;
};

constexpr std::array kRecorded{
    Recorded{"Bullet", 0, "bullet"},   Recorded{"ODE", 0, "ode"},
    Recorded{"MuJoCo", 0, "mujoco"},   Recorded{"MuJoCo", 1, "mujoco-rk4"},
    Recorded{"Simbody", 0, "simbody"},
};

// Nine digits: more than single precision has, and little enough for small files.
std::string rowOf(double time, const EngineState& state) {
  const Eigen::Quaterniond q(state.worldFromBody);
  const Eigen::Vector3d& w = state.angularVelocity;
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", time, q.w(),
                q.x(), q.y(), q.z(), w.x(), w.y(), w.z());
  return text.data();
}

std::string headOf(const Motion& motion, const Family& family, const Mode& mode) {
  const Eigen::Vector3d& size = motion.book.size;
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
                "# %s, %s%s; a solid book of %g x %g x %g m, %g kg\n"
                "time_s,qw,qx,qy,qz,wx,wy,wz\n",
                family.name.c_str(), mode.name.c_str(), mode.stepMatters ? ", steps of 1/60 s" : "",
                size.x(), size.y(), size.z(), motion.book.mass);
  return text.data();
}

void record(const Motion& motion, const Family& family, const Mode& mode,
            const std::filesystem::path& file) {
  const std::unique_ptr<Engine> engine = mode.make(motion, 1.0 / kRecordedASecond);
  std::string text = headOf(motion, family, mode) + rowOf(0, engine->state());
  for (int step = 1; step <= kDuration * kRecordedASecond; ++step) {
    engine->advance(1);
    text += rowOf(static_cast<double>(step) / kRecordedASecond, engine->state());
  }
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << text).flush()) throw MachineError("can't write " + file.string());
}

}  // namespace

void recordEngines(const Motion& motion, const std::vector<Family>& families,
                   const std::filesystem::path& folder) {
  for (const Recorded& one : kRecorded) {
    for (const Family& family : families) {
      if (!family.name.starts_with(one.family) || family.modes.size() <= one.mode) continue;
      record(motion, family, family.modes[one.mode], folder / (std::string(one.file) + ".csv"));
    }
  }
}

}  // namespace rotatebook::bench
