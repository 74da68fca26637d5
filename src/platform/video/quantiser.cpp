#include "video/quantiser.h"

#include <algorithm>
#include <cmath>

extern "C" {
#include <libavutil/video_enc_params.h>
}

namespace rotatebook::video {
namespace {

constexpr double kWorstQuantiser = 51;  // H.264's.
constexpr double kDoubling = 6;         // It doubles the step.
constexpr int kWorstIndex = 255;        // VP9's.

AVVideoEncParams* parametersOf(const AVFrame& frame) {
  const AVFrameSideData* data = av_frame_get_side_data(&frame, AV_FRAME_DATA_VIDEO_ENC_PARAMS);
  return data == nullptr ? nullptr : reinterpret_cast<AVVideoEncParams*>(data->data);
}

/// Returns a block's quantiser in H.264's scale.
double quantiserOf(AVVideoEncParamsType type, int value) {
  if (type == AV_VIDEO_ENC_PARAMS_VP9) return quantiserOfVp9(value);
  return std::clamp(1.0 * value, 0.0, kWorstQuantiser);
}

}  // namespace

// VP9's table of AC steps, in eighths: 7 + index up to 95, then within 4 % exponential up to 1828
// (VP9 Bitstream Specification, 8.6.1). H.264's step is 0.625 at 0.
double quantiserOfVp9(int index) {
  constexpr int kLinear = 95;
  const int known = std::clamp(index, 0, kWorstIndex);
  const double growth = std::log(1828.0 / (7 + kLinear)) / (kWorstIndex - kLinear);
  const double eighths =
      (7 + std::min(known, kLinear)) * std::exp(growth * std::max(known - kLinear, 0));
  return std::clamp(kDoubling * std::log2(eighths / 8 / 0.625), 0.0, kWorstQuantiser);
}

std::optional<double> quantiserOf(const AVFrame& frame) {
  AVVideoEncParams* parameters = parametersOf(frame);
  if (parameters == nullptr) return std::nullopt;
  if (parameters->nb_blocks == 0) return quantiserOf(parameters->type, parameters->qp);
  double squares = 0, area = 0;  // Of steps, over that at 0.
  for (unsigned i = 0; i < parameters->nb_blocks; ++i) {
    const AVVideoBlockParams& block = *av_video_enc_params_block(parameters, i);
    const double pixels = 1.0 * block.w * block.h;
    const double quantiser = quantiserOf(parameters->type, parameters->qp + block.delta_qp);
    squares += pixels * std::exp2(2 * quantiser / kDoubling);
    area += pixels;
  }
  return area > 0 ? std::optional(kDoubling / 2 * std::log2(squares / area)) : std::nullopt;
}

std::optional<double> coarsestQuantiserOf(const AVFrame& frame) {
  AVVideoEncParams* parameters = parametersOf(frame);
  if (parameters == nullptr) return std::nullopt;
  double coarsest = 0;
  for (unsigned i = 0; i < parameters->nb_blocks; ++i) {
    const int change = av_video_enc_params_block(parameters, i)->delta_qp;
    coarsest = std::max(coarsest, quantiserOf(parameters->type, parameters->qp + change));
  }
  return parameters->nb_blocks == 0 ? quantiserOf(frame) : coarsest;
}

}  // namespace rotatebook::video
