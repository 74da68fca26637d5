// Whether decoded pictures are those of a scene. Inside the room only.
#pragma once

#include <cstdint>
#include <map>

#include "image/image.h"
#include "picture/frame_drawer.h"
#include "scene/scene.h"
#include "verify/clip_check.h"
#include "video/planes.h"
#include "video/video_format.h"

namespace rotatebook::verify {

/// How far encoding may take a picture away from what was drawn.
video::Distance encodingBound(video::VideoFormat format, int crf);

/// Draws the frames of a scene and compares them with decoded ones.
class PictureComparison {
 public:
  /// `scene` and `drawer`, the scene's, which has `frames` frames, must outlive this.
  PictureComparison(const scene::Scene& scene, picture::FrameDrawer& drawer, std::int64_t frames,
                    video::VideoFormat format);

  /// Compares `picture` with frame `frame`, and with those beside it. Ascending frames are fastest.
  PictureCheck judge(std::int64_t frame, const video::Planes& picture);

 private:
  const video::Planes& drawn(std::int64_t frame);
  /// The frame within `reach` of `frame` that `picture` is likest to, if that is clearly liker than
  /// a distance of `rms`.
  std::optional<std::int64_t> liker(std::int64_t frame, const video::Planes& picture, double rms,
                                    std::int64_t reach);

  picture::FrameDrawer* drawer_;
  std::int64_t frames_;
  bool transparent_;
  video::Distance bound_;
  image::Image canvas_;
  std::map<std::int64_t, video::Planes> drawn_;  // the last few
};

}  // namespace rotatebook::verify
