#include "picture/still.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/error.h"
#include "base/number_text.h"
#include "image/png_file.h"
#include "picture/frame_drawer.h"
#include "scene/poster_frame.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {

std::int64_t frameAt(const scene::Scene& scene, const timeline::ClipMotion& motion, double time) {
  const FrameRate& rate = scene.clip.frameRate;
  const std::int64_t count = motion.frameCount();
  const bool early = motion.allDiverge();
  const double end = early ? static_cast<double>(count) * rate.period() : scene.clip.duration;
  if (time >= 0 && time <= end) return std::min(rate.framesIn(time), count - 1);
  throw InputError(fmt::format("there is no picture at {} s: the clip lasts from 0 to {} s{}",
                               shortestText(time), shortestText(end),
                               early ? ", a second after its motion diverges" : ""));
}

Still drawStill(const scene::Scene& scene, std::optional<double> time,
                const render::DeviceChoice& device) {
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  const std::int64_t frame =
      time ? frameAt(scene, motion, *time) : scene::posterFrame(scene.clip, motion.frameCount());
  FrameDrawer drawer(scene, motion, device);
  Still still{frame, drawer.makePicture()};
  drawer.draw(frame, still.picture);
  return still;
}

std::int64_t renderStill(const scene::Scene& scene, std::optional<double> time,
                         const std::filesystem::path& path, const render::DeviceChoice& device) {
  const Still still = drawStill(scene, time, device);
  image::writePng(path, still.picture.view(), scene::isTransparent(scene));
  return still.frame;
}

}  // namespace rotatebook::picture
