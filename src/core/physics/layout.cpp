#include "physics/layout.h"

#include <string>

#include "base/error.h"

namespace rotatebook::physics {
namespace {

void requireSame(bool here, bool there, const std::string& flag) {
  if (here == there) return;
  throw InputError("rotatebook was built " + std::string(here ? "without " : "with ") + flag +
                   ", this program " + (here ? "with" : "without") +
                   " it; link rotatebook::core by CMake, which passes the flags on");
}

void requireSame(std::size_t here, std::size_t there, const std::string& type) {
  if (here == there) return;
  throw InputError("rotatebook was built with a " + type + " of " + std::to_string(here) +
                   " bytes, this program with one of " + std::to_string(there) +
                   "; build both with the same headers and flags");
}

}  // namespace

void requireSameLayout(const Layout& caller) {
  static const Layout here = layoutHere();
  requireSame(here.eigenVectorizes, caller.eigenVectorizes, "-DEIGEN_DONT_VECTORIZE");
  requireSame(here.contractsProducts, caller.contractsProducts, "-ffp-contract=off");
  requireSame(here.fastMath, caller.fastMath, "-fno-fast-math");
  requireSame(here.sample, caller.sample, "physics::Sample");
  requireSame(here.trajectory, caller.trajectory, "physics::Trajectory");
  requireSame(here.motionSettings, caller.motionSettings, "physics::MotionSettings");
}

}  // namespace rotatebook::physics
