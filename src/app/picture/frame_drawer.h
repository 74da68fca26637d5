// The pictures of a clip, in any order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "image/linear_mean.h"
#include "picture/composition.h"
#include "picture/frame_painter.h"
#include "picture/textures.h"
#include "render/renderer.h"
#include "scene/reference_frame.h"
#include "scene/scene.h"
#include "timeline/clip_motion.h"
#include "timeline/shutter_moments.h"

namespace rotatebook::picture {

/// Draws frame n of a scene: the book, or one in each panel, and what is drawn over it. Owns an
/// OpenGL context; see render::Renderer.
class FrameDrawer final : public FramePainter {
 public:
  /// `motion`, the scene's, must outlive this. Throws as loadTextures(), Composition and
  /// render::Renderer do.
  FrameDrawer(const scene::Scene& scene, const timeline::ClipMotion& motion,
              const render::DeviceChoice& device = {});

  /// A picture of the right size and format for draw(), too.
  image::Image makePicture() const override { return composition_.makePicture(); }
  /// Draws over all of `picture`; `frame` is 0 to below motion.frameCount().
  void draw(std::int64_t frame, image::Image& picture);

  // The same in two steps.
  Exposure makeExposure() const override;
  void expose(std::int64_t frame, Exposure& exposure) override;
  void finish(const Exposure& exposure, image::Image& picture) override;

  /// render::Renderer::description()
  const std::string& description() const { return renderer_.description(); }
  /// Of the textures that it draws.
  const TextureChecksums& textureChecksums() const { return textureChecksums_; }

 private:
  /// Takes the textures as late as it can.
  FrameDrawer(const scene::Scene& scene, const timeline::ClipMotion& motion,
              const render::DeviceChoice& device, std::future<LoadedTextures> textures);

  physics::Cage cageOf(std::size_t motion, std::size_t sample) const;
  /// The mean of the moments after sample `sample`.
  void exposeBlurred(std::size_t motion, std::size_t sample, image::Image& picture);

  const timeline::ClipMotion* motion_;
  Composition composition_;
  scene::ReferenceFrame referenceFrame_;
  render::Camera camera_;
  TextureChecksums textureChecksums_;
  render::Renderer renderer_;  // of a panel
  timeline::ShutterMoments moments_;
  std::optional<image::LinearMean> mean_;  // of the pictures of moments_, if there are several
  std::optional<Exposure> exposure_;       // of draw()
};

}  // namespace rotatebook::picture
