#include "bridge/recordings.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/json.h"
#include "base/number_text.h"
#include "recording/inertial_recording.h"
#include "recording/read_recording.h"
#include "recording/toss.h"

namespace rotatebook::bridge {
namespace {

/// Returns the longest stretch, of the file's times, in which a body turns at least half as fast as
/// it mostly does while it turns; null of one that rests.
Json turningJson(std::string_view bytes, const std::string& name) {
  const recording::InertialRecording recording = recording::readInertial(bytes, name, {});
  std::vector<double> speeds, fast;
  for (const recording::InertialReading& reading : recording.readings) {
    speeds.push_back(reading.rate.angularVelocity.norm());
    if (speeds.back() > recording::kSlowestThrow) fast.push_back(speeds.back());
  }
  if (fast.empty()) return nullptr;
  const auto middle = fast.begin() + std::ssize(fast) / 2;
  std::nth_element(fast.begin(), middle, fast.end());
  std::size_t first = 0, count = 0, begin = 0;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (speeds[i] < *middle / 2) begin = i + 1;
    if (i + 1 > begin + count) std::tie(first, count) = std::pair(begin, i + 1 - begin);
  }
  const auto time = [&](std::size_t i) { return recording.zero + recording.readings[i].rate.time; };
  return Json::array({time(first), time(first + count - 1)});
}

}  // namespace

std::vector<double> flightNumbers(const double* readings, std::int32_t count) {
  recording::InertialRecording recording;
  for (const double* one = readings; one != readings + 7 * std::ptrdiff_t{count}; one += 7) {
    recording.readings.push_back({{one[0], Eigen::Vector3d(one + 1)}, Eigen::Vector3d(one + 4)});
  }
  const auto flight = recording::findFlight(recording);
  if (!flight) return {};
  return {flight->from, flight->to, flight->start.x(), flight->start.y(), flight->start.z()};
}

Json recordingJson(std::string_view bytes, const std::string& name) {
  return {{"duration", recording::readRecording(bytes, name, {}).duration()},
          {"turning", turningJson(bytes, name)}};
}

}  // namespace rotatebook::bridge
