// Comparison of decoded pictures with the frames of a scene. Inside the room only.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "image/image.h"
#include "picture/frame_drawer.h"
#include "pipeline/verify/clip_check.h"
#include "scene/scene.h"
#include "video/planes.h"

namespace rotatebook::pipeline {

/// Returns the largest deviation of a decoded picture from the drawn one that encoding with
/// `quantiser` explains, in pictures of `width` x `height` pixels.
Deviation encodingBound(double quantiser, int width, int height);

/// The quantisers that a decoder reports of a picture, if it does.
struct CodedWith {
  std::optional<double> quantiser{};  ///< As in video::PictureFacts.
  std::optional<double> coarsest{};   ///< The coarsest of a block.
};

/// Compares `picture` with `drawn`, its frame `frame`. The bound is that of `coding`'s quantiser,
/// but at most that of kCoarsestProof, and no larger than codingNoise() explains; of single blocks
/// at least that of the coarsest, as far as a fine clip has such.
PictureCheck compareWith(const video::Planes& drawn, std::int64_t frame,
                         const video::Planes& picture, const CodedWith& coding);

/// Draws the frames of a scene and compares them with decoded ones.
class PictureComparison {
 public:
  /// `drawer` draws `scene`, whose clip has `frames` frames, and must outlive this.
  PictureComparison(const scene::Scene& scene, picture::FrameDrawer& drawer, std::int64_t frames);

  /// Compares `picture` with frame `frame`, as compareWith() does, and with its neighbours. Fastest
  /// with ascending frames.
  PictureCheck compare(std::int64_t frame, const video::Planes& picture, const CodedWith& coding);

 private:
  const video::Planes& drawn(std::int64_t frame);
  /// Returns the frame within `reach` of `frame` that is closest to `picture`, if its distance is
  /// clearly less than `rms`.
  std::optional<std::int64_t> closerFrame(std::int64_t frame, const video::Planes& picture,
                                          double rms, std::int64_t reach);

  picture::FrameDrawer* drawer_;
  std::int64_t frames_;
  bool transparent_;
  image::Image picture_;
  std::map<std::int64_t, video::Planes> drawn_;  // The last few.
};

}  // namespace rotatebook::pipeline
