#include "engines/record.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "base/error.h"

namespace rotatebook::bench {
namespace {

constexpr int kRecordedSeconds = 12;  // as long as the clips of them

/// A motion that is recorded, and the name of its file.
struct Recorded {
  std::string_view family;  // the beginning of its name
  std::size_t mode;         // its index
  const char* file;
  int stepsASecond = 60;
  int stepsARow = 1;
  double mass = 1;  // [kg]
};

// All in steps of 1/60 s, then MuJoCo in its own, Bullet with a book that its single precision
// bears, and ODE in its more exact mode. Bullet's own step is 1/60 s; ODE has none of its own.
constexpr std::array kRecorded{
    Recorded{"Bullet", 0, "bullet"},
    Recorded{"ODE", 0, "ode"},
    Recorded{"MuJoCo", 0, "mujoco"},
    Recorded{"MuJoCo", 1, "mujoco-rk4"},
    Recorded{"Simbody", 0, "simbody"},
    Recorded{"Bullet", 0, "bullet-2kg", 60, 1, 2},
    Recorded{"ODE", 1, "ode-finite-rotation"},
    Recorded{"MuJoCo", 0, "mujoco-2ms", 500, 10},
    Recorded{"MuJoCo", 1, "mujoco-rk4-2ms", 500, 10},
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

std::string headOf(const Motion& motion, const Family& family, const Mode& mode,
                   const Recorded& one) {
  const Eigen::Vector3d& size = motion.book.size;
  const std::string steps =
      mode.stepMatters ? ", steps of 1/" + std::to_string(one.stepsASecond) + " s" : "";
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
                "# %s, %s%s; a solid book of %g x %g x %g m, %g kg\n"
                "time_s,qw,qx,qy,qz,wx,wy,wz\n",
                family.name.c_str(), mode.name.c_str(), steps.c_str(), size.x(), size.y(), size.z(),
                motion.book.mass);
  return text.data();
}

void record(Motion motion, const Family& family, const Recorded& one,
            const std::filesystem::path& file) {
  motion.book.mass = one.mass;
  const Mode& mode = family.modes[one.mode];
  const std::unique_ptr<Engine> engine = mode.make(motion, 1.0 / one.stepsASecond);
  std::string text = headOf(motion, family, mode, one) + rowOf(0, engine->state());
  const int steps = kRecordedSeconds * one.stepsASecond;
  for (int step = one.stepsARow; step <= steps; step += one.stepsARow) {
    engine->advance(one.stepsARow);
    text += rowOf(static_cast<double>(step) / one.stepsASecond, engine->state());
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
      record(motion, family, one, folder / (std::string(one.file) + ".csv"));
    }
  }
}

}  // namespace rotatebook::bench
