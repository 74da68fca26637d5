// The pictures of any video, as they were given to its writer.
#pragma once

#include <filesystem>
#include <vector>

#include "image/image.h"

namespace rotatebook::video::testing {

struct DecodedPicture {
  double time = 0;       ///< From the file's start. [s]
  image::Image picture;  ///< Rgba8, opaque where the file has no alpha.
};

struct DecodedPictures {
  double duration = 0;  ///< As the container says. [s]
  std::vector<DecodedPicture> pictures;
};

/// Reads and decodes all of `path`, with VP9's alpha. Throws MachineError where that fails.
DecodedPictures decodePictures(const std::filesystem::path& path);

/// Peak signal to noise ratio of the colours of two pictures of one size, where both are opaque.
/// [dB]
double psnr(const image::Image& a, const image::Image& b);

}  // namespace rotatebook::video::testing
