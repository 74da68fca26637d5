// Draws bodies in their deformation cages of eight corners.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "body/cuboid.h"
#include "geometry/camera.h"
#include "image/image.h"
#include "render/book_textures.h"
#include "render/drawn_body.h"
#include "render/render_settings.h"

namespace rotatebook::render {

struct SurfaceLook;

/// The look of a body: the book with its cover, or any surface.
using BodyLook = std::variant<BookTextures, std::shared_ptr<const SurfaceLook>>;

/// Owns an OpenGL context. Create, use and destroy it on one thread, one at a time in a process. A
/// picture depends on nothing but the settings, the look and the cage.
class Renderer {
 public:
  /// Draws the bodies of one or more looks. Throws MachineError if settings.device gives no
  /// OpenGL 3.3, or one that draws nothing; InputError if that device doesn't exist, or a size or
  /// texture is too large for it.
  Renderer(const RenderSettings& settings, const std::vector<BodyLook>& looks);
  /// Likewise of the book alone.
  Renderer(const RenderSettings& settings, const BookTextures& textures);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Replaces the camera of the settings from the next draw() on.
  void setCamera(const geometry::Camera& camera);

  /// Lets what stands still in the world, wall and stars, be seen by a camera that turns from the
  /// next draw() of one body on: `worldFromFrame` takes the axes of its frame to the world's.
  void setTurning(const Eigen::Matrix3d& worldFromFrame);

  /// Returns a picture of the right size and format for draw().
  image::Image makePicture() const;
  /// Draws the first body in this cage (world [m]) and the background over all of `picture`, from
  /// makePicture().
  /// Alpha is straight, and 255 throughout unless the background is transparent.
  /// Throws MachineError if OpenGL reports an error.
  void draw(const body::Cage& cage, image::Image& picture);
  /// Likewise the body of that look.
  void draw(std::size_t look, const body::Cage& cage, image::Image& picture);

  /// Draws the body alone, the first of two steps. The second, compose(), may run on another thread
  /// while this one draws the next frame into another body. `body`: from makeBody().
  void draw(const body::Cage& cage, DrawnBody& body);
  /// Returns a body of that look to draw.
  DrawnBody makeBody(std::size_t look = 0) const;
  /// Draws each of `bodies` in its cage, as `cameras` with the same index has it. OpenGL waits once
  /// for all of them, which is faster where they are small. Throws like draw().
  void draw(std::span<const body::Cage> cages, std::span<const geometry::Camera> cameras,
            std::span<DrawnBody> bodies);
  /// Composes a drawn body into `picture`, which shows background() from (x, y) on, touching it
  /// alone. A body that a turning camera sees replaces the background, too.
  void compose(const DrawnBody& body, int x, int y, image::Image& picture);
  /// Returns a picture, of the settings' size, without a body.
  const image::Image& background() const;

  /// Draws a small test frame, in which every pixel of a body is computed as in frames, and
  /// returns its checksum. It depends on the driver and the processor alone, and on the background
  /// of the settings: renderers of one description may draw other pixels, and have another checksum
  /// then. Throws MachineError if OpenGL reports an error.
  std::string testFrame() const;

  /// Describes what draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5, EGL device 0".
  const std::string& description() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::render
