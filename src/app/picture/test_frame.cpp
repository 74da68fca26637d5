#include "picture/test_frame.h"

#include "base/checksum.h"
#include "image/image.h"
#include "overlay/caption_and_clock.h"
#include "scene/scene.h"

namespace rotatebook::picture {
namespace {

/// Returns the checksum of a picture with text on it.
std::string drawnText() {
  scene::Scene scene;
  scene.title = "Test frame: 0123456789";
  scene.clip.width = 320;
  scene.clip.height = 90;
  scene.overlay.show = {scene::Overlay::Caption, scene::Overlay::Clock};
  image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgb8);
  overlay::CaptionAndClock(scene).draw(0, picture);
  return checksumOf(picture.bytes());
}

}  // namespace

std::string testFrame(const render::Renderer& renderer, bool text) {
  return checksumOf(renderer.testFrame() + (text ? drawnText() : ""));
}

}  // namespace rotatebook::picture
