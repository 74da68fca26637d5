#include "recording/attitudes_alone.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "recording/gyroscope.h"

namespace rotatebook::recording {

double slopeUncertainty(const std::vector<RecordedMoment>& moments) {
  std::vector<RecordedMoment> others = moments;
  differentiateAttitudes(others, 1);
  double difference = 0, all = 0;
  for (std::size_t i = 2; i + 2 < moments.size(); ++i) {
    difference += (others[i].angularVelocity - moments[i].angularVelocity).squaredNorm();
    all += moments[i].angularVelocity.squaredNorm();
  }
  return all > 0 ? std::sqrt(difference / all) : 0;
}

RecordedMotion attitudesAlone(const RecordedMotion& motion) {
  std::vector<RecordedMoment> moments = motion.moments();
  differentiateAttitudes(moments);
  const double uncertainty = slopeUncertainty(moments);
  return RecordedMotion(std::move(moments), {SpinSource::Slopes, uncertainty});
}

}  // namespace rotatebook::recording
