#include "study/run_value.h"

#include <cmath>

namespace rotatebook::study {

scene::Outcome outcomeOf(double value) {
  if (std::isnan(value)) return scene::Outcome::Refused;
  if (value == kNever) return scene::Outcome::Never;
  return value == kDiverged ? scene::Outcome::Diverged : scene::Outcome::Value;
}

}  // namespace rotatebook::study
