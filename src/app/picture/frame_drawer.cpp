#include "picture/frame_drawer.h"

#include <algorithm>
#include <utility>

#include "picture/composition.h"
#include "picture/test_frame.h"

namespace rotatebook::picture {

// Reading textures and making overlays take half of the time in which a render starts: they run in
// parallel.
FrameDrawer::FrameDrawer(const scene::Scene& scene, const timeline::ClipMotion& motion,
                         const render::DeviceChoice& device, const TextureFiles& files)
    : FrameDrawer(scene, motion, device, std::async(std::launch::async, [&scene, &files] {
                    return loadLooks(scene, files);
                  })) {}

FrameDrawer::FrameDrawer(const scene::Scene& scene, const timeline::ClipMotion& motion,
                         const render::DeviceChoice& device, std::future<LoadedLooks> looks)
    : motion_(&motion),
      composition_(std::make_unique<Composition>(scene, motion)),
      referenceFrames_(referenceFramesOf(scene)),
      camera_(scene, composition_->screen()),
      distances_(scene, motion),
      renderer_([&] {
        LoadedLooks loaded = looks.get();
        textureChecksums_ = std::move(loaded.checksums);
        lookOf_ = std::move(loaded.lookOf);
        return makeRenderer(scene, composition_->screen(), loaded.looks, device);
      }()),
      moments_(scene),
      isGrid_(scene.grid.has_value()),
      turns_(std::ranges::count(referenceFrames_, scene::ReferenceFrame::Turning,
                                &scene::MotionFrame::kind) > 0 ||
             camera_.moves()),
      hasText_(!scene.overlay.show.empty() || scene.hasPanels()) {
  composition_->setBackground(renderer_.background());
  const geometry::Screen& screen = composition_->screen();
  if (moments_.count() > 1) mean_.emplace(screen.width, screen.height);
}

FrameDrawer::~FrameDrawer() = default;

std::string FrameDrawer::testFrame() const {
  return picture::testFrame(renderer_, hasText_);
}

image::Image FrameDrawer::makePicture() const {
  return composition_->makePicture();
}

void FrameDrawer::draw(std::int64_t frame, image::Image& picture) {
  if (!exposure_) exposure_ = makeExposure();
  expose(frame, *exposure_);
  compose(*exposure_, picture);
}

Exposure FrameDrawer::makeExposure() const {
  Exposure exposure;
  const std::size_t count = motion_->trajectories().size();
  if (mean_) {
    exposure.blurred.assign(count, renderer_.makePicture());
  } else {
    for (const std::size_t look : lookOf_) exposure.bodies.push_back(renderer_.makeBody(look));
  }
  return exposure;
}

void FrameDrawer::expose(std::int64_t frame, Exposure& exposure) {
  exposure.frame = frame;
  if (isGrid_ && !mean_ && !turns_) return exposeGrid(frame, exposure);
  for (std::size_t motion = 0; motion < motion_->trajectories().size(); ++motion) {
    const std::size_t sample = motion_->sampleAt(motion, frame);
    renderer_.setCamera(cameraAt(motion, frame));
    if (turns_ && !mean_) turnTo(motion, motion_->trajectories()[motion].samples[sample]);
    if (mean_) {
      exposeBlurred(motion, sample, exposure.blurred[motion]);
    } else {
      renderer_.draw(cageOf(motion, sample), exposure.bodies[motion]);
    }
  }
}

void FrameDrawer::exposeGrid(std::int64_t frame, Exposure& exposure) {
  std::vector<body::Cage> cages;
  std::vector<geometry::Camera> cameras;
  for (std::size_t motion = 0; motion < exposure.bodies.size(); ++motion) {
    cages.push_back(cageOf(motion, motion_->sampleAt(motion, frame)));
    cameras.push_back(cameraAt(motion, frame));
  }
  renderer_.draw(cages, cameras, exposure.bodies);
}

void FrameDrawer::exposeBlurred(std::size_t motion, std::size_t sample, image::Image& picture) {
  for (std::size_t i = 0; i < moments_.count(); ++i) {
    const physics::Sample& moment = moments_.at(motion, sample, i);
    if (turns_) turnTo(motion, moment);
    renderer_.draw(lookOf_[motion], referenceFrames_[motion].seen(moment).cage, picture);
    mean_->add(picture.view());
  }
  mean_->take(picture);
}

void FrameDrawer::turnTo(std::size_t motion, const physics::Sample& sample) {
  renderer_.setTurning(referenceFrames_[motion].fromWorld(sample).transpose());
}

void FrameDrawer::compose(const Exposure& exposure, image::Image& picture) {
  const DrawBody drawBody = [&](std::size_t motion, std::size_t sample,
                                const plot::PanelGrid::Position& place, image::Image& into) {
    if (!mean_) {
      renderer_.compose(exposure.bodies[motion], place.x, place.y, into);
      return exposure.bodies[motion].clipFromWorld;
    }
    image::paste(exposure.blurred[motion].view(), place.x, place.y, into);
    const body::Cage cage = cageOf(motion, sample);
    const geometry::Camera camera = cameraAt(motion, exposure.frame);
    return geometry::project(camera, cage, composition_->screen()).clipFromWorld;
  };
  composition_->draw(exposure.frame, drawBody, picture);
}

geometry::Camera FrameDrawer::cameraAt(std::size_t motion, std::int64_t frame) const {
  return geometry::movedAway(camera_.at(frame), distances_.at(motion, frame));
}

body::Cage FrameDrawer::cageOf(std::size_t motion, std::size_t sample) const {
  return referenceFrames_[motion].seen(motion_->trajectories()[motion].samples[sample]).cage;
}

}  // namespace rotatebook::picture
