#include "picture/thumbnail.h"

#include <algorithm>
#include <cmath>

#include "picture/frame_drawer.h"
#include "scene/poster_frame.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {
namespace {

constexpr double kWidth = 480;          // [pixels]
constexpr double kSmallestHeight = 96;  // of a very wide thumbnail [pixels]

int evenSide(double pixels) {
  return 2 * std::max(1, static_cast<int>(std::lround(pixels / 2)));
}

}  // namespace

scene::Scene thumbnailScene(const scene::Scene& scene) {
  scene::Scene small = scene;
  const scene::ClipSettings& clip = scene.clip;
  const double scale = std::min(1.0, std::max(kWidth / clip.width, kSmallestHeight / clip.height));
  small.clip.width = evenSide(scale * clip.width);
  small.clip.height = evenSide(scale * clip.height);
  small.look.supersample = 2;  // thin lines look rough in small pictures
  small.textless = true;
  return small;
}

image::Image drawThumbnail(const scene::Scene& scene, const render::DeviceChoice& device) {
  const scene::Scene small = thumbnailScene(scene);
  const timeline::ClipMotion motion = timeline::simulateScene(small);
  FrameDrawer drawer(small, motion, device);
  image::Image picture = drawer.makePicture();
  drawer.draw(scene::posterFrame(small.clip, motion.frameCount()), picture);
  return picture;
}

}  // namespace rotatebook::picture
