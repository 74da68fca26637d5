// Draws the pictures of a clip, in any order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "image/linear_mean.h"
#include "picture/frame_painter.h"
#include "picture/looks.h"
#include "render/renderer.h"
#include "scene/reference_frame.h"
#include "scene/scene.h"
#include "timeline/camera_distances.h"
#include "timeline/clip_motion.h"
#include "timeline/scene_camera.h"
#include "timeline/shutter_moments.h"

namespace rotatebook::picture {

class Composition;

/// Draws frame n of a scene: the body, or one in each panel, and the overlays. Owns an OpenGL
/// context; see render::Renderer.
class FrameDrawer final : public FramePainter {
 public:
  /// `motion`, the scene's, must outlive this; `files` are the scene's textures as far as they were
  /// read already. Throws like loadLooks(), Composition and render::Renderer.
  FrameDrawer(const scene::Scene& scene, const timeline::ClipMotion& motion,
              const render::DeviceChoice& device = {}, const TextureFiles& files = {});
  ~FrameDrawer() override;

  /// Returns a picture of the right size and format for draw() and compose().
  image::Image makePicture() const override;
  /// Draws over all of `picture`; `frame` is 0 to below motion.frameCount().
  void draw(std::int64_t frame, image::Image& picture);

  // The two steps of draw().
  Exposure makeExposure() const override;
  void expose(std::int64_t frame, Exposure& exposure) override;
  void compose(const Exposure& exposure, image::Image& picture) override;

  /// Returns render::Renderer::description().
  const std::string& description() const { return renderer_.description(); }
  /// Returns picture::testFrame() of its renderer.
  std::string testFrame() const;
  /// Returns the checksums of the textures that it draws.
  const TextureChecksums& textureChecksums() const { return textureChecksums_; }

 private:
  /// Waits for the looks only when the renderer needs them.
  FrameDrawer(const scene::Scene& scene, const timeline::ClipMotion& motion,
              const render::DeviceChoice& device, std::future<LoadedLooks> looks);

  body::Cage cageOf(std::size_t motion, std::size_t sample) const;
  geometry::Camera cameraAt(std::size_t motion, std::int64_t frame) const;
  /// Lets the background be seen from a motion's frame of reference at that moment.
  void turnTo(std::size_t motion, const physics::Sample& sample);
  /// Draws the bodies of a grid, all at once.
  void exposeGrid(std::int64_t frame, Exposure& exposure);
  /// Draws the mean of the moments during which the shutter is open after `sample`.
  void exposeBlurred(std::size_t motion, std::size_t sample, image::Image& picture);

  const timeline::ClipMotion* motion_;
  std::unique_ptr<Composition> composition_;
  std::vector<scene::MotionFrame> referenceFrames_;  // by motion
  timeline::CameraPath camera_;                      // at the distance that the scene states
  timeline::CameraDistances distances_;
  TextureChecksums textureChecksums_;
  std::vector<std::size_t> lookOf_;  // by motion
  render::Renderer renderer_;        // of a panel
  timeline::ShutterMoments moments_;
  bool isGrid_;
  bool turns_;                             // The camera, before a background that stands still.
  bool hasText_;                           // Overlays or panels' labels.
  std::optional<image::LinearMean> mean_;  // of the pictures of moments_, if there are several
  std::optional<Exposure> exposure_;       // used by draw()
};

}  // namespace rotatebook::picture
