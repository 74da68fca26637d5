#include "study/execution.h"

#include <algorithm>

#include "base/number_text.h"

namespace rotatebook::study {

bool runInTurn(std::span<const std::size_t> indices, const Run& run) {
  std::ranges::for_each(indices, run);
  return true;
}

std::string RunEnd::text() const {
  switch (kind) {
    case Kind::Diverged:
      return "diverged at " + roundedText(time, 6) + " s";
    case Kind::NoConvergence:
      return "no convergence";
    case Kind::StepTooLong:
      return "step too long for its series";
    case Kind::Whole:
      break;
  }
  return "ok";
}

}  // namespace rotatebook::study
