#include "recording/inertial_recording.h"

#include <cmath>

#include "base/number_text.h"

namespace rotatebook::recording {

std::string timeText(double time) {
  int digits = 4;
  for (double whole = std::abs(time); whole >= 1 && digits < 17; whole /= 10) ++digits;
  return roundedText(time, digits);
}

}  // namespace rotatebook::recording
