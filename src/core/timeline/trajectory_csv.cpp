#include "timeline/trajectory_csv.h"

#include <optional>

#include "base/number_text.h"
#include "timeline/motion_summary.h"

namespace rotatebook::timeline {
namespace {

std::string header() {
  std::string text =
      "frame,time_s,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,kinetic_J,potential_J,total_J,tilt_deg,"
      "half_turns,stretch_min,stretch_max";
  for (int corner = 0; corner < 8; ++corner) {
    for (const char axis : {'x', 'y', 'z'}) {
      text += ",c" + std::to_string(corner) + axis;
    }
  }
  return text + ",error_deg,energy_ratio,L_ratio,regime,centre_drift_m,last_flip_s\n";
}

void append(std::string& row, double value) {
  row += ',' + shortestText(value);
}

template <typename Values>
void appendAll(std::string& row, const Values& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) append(row, values.data()[i]);
}

void appendRow(std::string& text, std::size_t frame, const physics::Sample& sample,
               const physics::Sample& start, std::optional<double> lastFlip) {
  text += std::to_string(frame);
  append(text, sample.time);
  append(text, sample.attitude.w());
  appendAll(text, sample.attitude.vec());
  appendAll(text, sample.angularVelocity);
  appendAll(text, sample.angularMomentum);
  append(text, sample.kinetic);
  append(text, sample.potential);
  append(text, sample.total());
  append(text, sample.tiltDeg);
  text += ',' + std::to_string(sample.halfTurns);
  append(text, sample.stretchMin);
  append(text, sample.stretchMax);
  appendAll(text, sample.cage);  // Column by column: corner by corner.
  append(text, sample.errorDeg);
  append(text, sample.total() / start.total());
  append(text, sample.angularMomentum.norm() / start.angularMomentum.norm());
  text += ',' + std::to_string(static_cast<int>(sample.regime));
  append(text, sample.centreDrift());
  text += ',' + (lastFlip ? shortestText(*lastFlip) : "") + '\n';
}

}  // namespace

void writeCsv(const physics::Trajectory& trajectory,
              const std::function<void(std::string_view)>& take) {
  requireSameLayout();
  constexpr std::size_t kPieceSize = 65'536;  // [bytes]
  std::string text = header();
  const physics::Sample* before = &trajectory.samples.front();
  std::optional<double> lastFlip;
  for (std::size_t frame = 0; frame < trajectory.samples.size(); ++frame) {
    const physics::Sample& sample = trajectory.samples[frame];
    if (sample.halfTurns > before->halfTurns) lastFlip = halfTurnTime(*before, sample);
    before = &sample;
    appendRow(text, frame, sample, trajectory.samples.front(), lastFlip);
    if (text.size() < kPieceSize) continue;
    take(text);
    text.clear();
  }
  take(text);
}

std::string trajectoryCsv(const physics::Trajectory& trajectory) {
  std::string csv;
  writeCsv(trajectory, [&csv](std::string_view piece) { csv += piece; });
  return csv;
}

}  // namespace rotatebook::timeline
