#include "pipeline/frame_drawer.h"

#include "pipeline/textures.h"

namespace rotatebook::pipeline {

FrameDrawer::FrameDrawer(const scene::Scene& scene, const ClipMotion& motion)
    : motion_(&motion),
      composition_(scene, motion),
      frame_(scene.camera.frame),
      camera_(cameraOf(scene, composition_.screen())),
      renderer_(makeRenderer(scene, composition_.screen())),
      moments_(scene) {
  const render::Screen& screen = composition_.screen();
  if (moments_.count() > 1) mean_.emplace(screen.width, screen.height);
}

void FrameDrawer::draw(std::int64_t frame, image::Image& picture) {
  const DrawBook drawBook = [this](std::size_t motion, std::size_t sample, image::Image& panel) {
    return this->drawBook(motion, sample, panel);
  };
  composition_.draw(frame, drawBook, picture);
}

Eigen::Matrix4d FrameDrawer::drawBook(std::size_t motion, std::size_t sample,
                                      image::Image& picture) {
  const auto& samples = motion_->trajectories()[motion].samples;
  const physics::Corners corners = physics::seenFrom(frame_, samples[sample]).corners;
  if (mean_) {
    drawBlurred(motion, sample, picture);
  } else {
    renderer_.draw(corners, picture);
  }
  return render::project(camera_, corners, composition_.screen()).clipFromWorld;
}

void FrameDrawer::drawBlurred(std::size_t motion, std::size_t sample, image::Image& picture) {
  for (std::size_t i = 0; i < moments_.count(); ++i) {
    renderer_.draw(physics::seenFrom(frame_, moments_.at(motion, sample, i)).corners, picture);
    mean_->add(picture.view());
  }
  mean_->take(picture);
}

}  // namespace rotatebook::pipeline
