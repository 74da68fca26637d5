// Quantisers with which decoded pictures were coded. Inside the room only.
#pragma once

#include <optional>

#include "video/ffmpeg.h"

namespace rotatebook::video {

/// Returns the quantiser whose step is the root mean square of those of the luma's blocks, in
/// H.264's scale, 0 to 51, where 6 more double the step. None if the decoder exported no
/// AV_FRAME_DATA_VIDEO_ENC_PARAMS.
std::optional<double> quantiserOf(const AVFrame& frame);

/// Returns the coarsest of the blocks' quantisers, likewise.
std::optional<double> coarsestQuantiserOf(const AVFrame& frame);

/// Returns VP9's quantiser `index`, 0 to 255, in H.264's scale, as far as steps are the same.
double quantiserOfVp9(int index);

}  // namespace rotatebook::video
