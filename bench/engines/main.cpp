// One table of this program's integrators and the engines that people use: the same book, the same
// spin, the same steps, in one run. Compare the times of one run with each other, not with those of
// another machine or day. With --record FOLDER it writes the engines' motions instead.
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string_view>

#include "engines/record.h"
#include "engines/table.h"

namespace rotatebook::bench {
namespace {

/// The book that turns once a second about its middle axis, tilted by 0.01 rad toward z.
Motion flippingBook() {
  constexpr double kTilt = 0.01;
  Motion motion;
  motion.book.size = {0.15, 0.22, 0.04};
  motion.book.mass = 1;
  motion.angularVelocity = {std::cos(kTilt), 0, std::sin(kTilt)};
  motion.angularVelocity *= 2 * std::numbers::pi;
  return motion;
}

std::vector<Family> families() {
  Family bullet{"Bullet", "libbullet-dev", {}, {}};
  Family ode{"ODE", "libode-dev", {}, {}};
  Family mujoco{"MuJoCo", "libmujoco-dev", {}, {}};
  Family simbody{"Simbody", "libsimbody-dev", {}, {}};
  if constexpr (ROTATEBOOK_HAS_BULLET) bullet = bulletFamily();
  if constexpr (ROTATEBOOK_HAS_ODE) ode = odeFamily();
  if constexpr (ROTATEBOOK_HAS_MUJOCO) mujoco = mujocoFamily();
  if constexpr (ROTATEBOOK_HAS_SIMBODY) simbody = simbodyFamily();
  return {ownFamily(), bullet, ode, mujoco, simbody};
}

}  // namespace
}  // namespace rotatebook::bench

int main(int argc, char** argv) {
  using namespace rotatebook::bench;
  try {
    if (argc == 3 && argv[1] == std::string_view("--record")) {
      recordEngines(flippingBook(), families(), argv[2]);
    } else {
      printTable(flippingBook(), families());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rotatebook_engines_bench: %s\n", error.what());
    return 3;
  }
  return 0;
}
