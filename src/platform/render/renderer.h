// Draws the book in its deformation cage of eight corners.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "base/rgb.h"
#include "geometry/book_mesh.h"
#include "geometry/camera.h"
#include "image/image.h"
#include "physics/cuboid.h"
#include "render/compositor.h"
#include "render/device/device.h"
#include "render/drawn_body.h"

namespace rotatebook::render {

/// Backgrounds behind the book.
enum class Background {
  Studio,       ///< A quiet, dark wall, brightest behind the book.
  Stars,        ///< A night sky.
  Transparent,  ///< Nothing: alpha is the pixel coverage of the book.
  Plain,        ///< RenderSettings::plainColour throughout.
};

/// Settings of a Renderer.
struct RenderSettings {
  int width = 1280;  ///< > 0 [pixels]
  int height = 720;  ///< > 0 [pixels]
  /// Factor, 1 or 2, by which the drawing is wider and higher than the picture, which takes the
  /// mean of its pixels in linear light.
  int supersample = 1;
  Background background = Background::Studio;
  Rgb plainColour{};  ///< For Background::Plain.
  /// Rows at the bottom that the camera's view leaves free. 0 to below `height`. [pixels]
  int bottomRows = 0;
  geometry::Camera camera;
  geometry::MeshDetail detail = geometry::MeshDetail::Full;
  DeviceChoice device{};
};

/// The pictures on the book's cover, each upright to a viewer of its side. One of a single pixel is
/// plain cloth, in which no gold is stamped, whatever its colour.
struct BookTextures {
  image::Image front, spine, back;
};

/// Return the parts of the built-in cover.
image::Image builtinFront();
image::Image builtinSpine();
image::Image builtinBack();
/// Returns the picture of a side of plain cloth.
image::Image plainCloth(const Rgb& colour);

/// Owns an OpenGL context. Create, use and destroy it on one thread, one at a time in a process. A
/// picture depends on nothing but the settings, the textures and the cage.
class Renderer {
 public:
  /// Throws MachineError if settings.device gives no OpenGL 3.3, or one that draws nothing;
  /// InputError if that device doesn't exist, or a size or texture is too large for it.
  Renderer(const RenderSettings& settings, const BookTextures& textures);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Replaces the camera of the settings from the next draw() on.
  void setCamera(const geometry::Camera& camera);

  /// Returns a picture of the right size and format for draw().
  image::Image makePicture() const;
  /// Draws the book in this cage (world [m]) and the background over all of `picture`, from
  /// makePicture().
  /// Alpha is straight, and 255 throughout unless the background is transparent.
  /// Throws MachineError if OpenGL reports an error.
  void draw(const physics::Cage& cage, image::Image& picture);

  /// Draws the book alone, the first of two steps. The second, compositor().compose(), may run on
  /// another thread while this one draws the next frame into another body. `body`: from makeBody().
  void draw(const physics::Cage& cage, DrawnBody& body);
  DrawnBody makeBody() const;
  /// Draws the book in each of `cages`, as `cameras` with the same index has it, into the body with
  /// the same index, from makeBody(). OpenGL waits once for all of them, which is faster where they
  /// are small. Throws like draw().
  void draw(std::span<const physics::Cage> cages, std::span<const geometry::Camera> cameras,
            std::span<DrawnBody> bodies);
  Compositor& compositor();

  /// Draws a small test frame, in which every pixel of the book is computed as in frames, and
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
