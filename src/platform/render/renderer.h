// Draws the book in its cage of eight corners.
#pragma once

#include <memory>
#include <string>

#include "image/image.h"
#include "physics/cuboid.h"
#include "render/camera.h"
#include "render/compositor.h"
#include "render/device/device.h"
#include "render/drawn_body.h"

namespace rotatebook::render {

/// What is seen behind the book.
enum class Background {
  Studio,       ///< A quiet, dark wall, brightest behind the book.
  Stars,        ///< A night sky.
  Transparent,  ///< Nothing: alpha is the share of each pixel that the book covers.
};

/// How pictures are drawn.
struct RenderSettings {
  int width = 1280;  ///< > 0 [pixels]
  int height = 720;  ///< > 0 [pixels]
  /// Draws so many times as wide and high and takes the mean, of light, of as many pixels: 1 or 2.
  int supersample = 1;
  Background background = Background::Studio;
  /// What the camera sees is shown above so many rows, which are left to others. 0 to below
  /// `height`. [pixels]
  int bottomRows = 0;
  Camera camera;
  DeviceChoice device{};
};

/// The pictures on the book's cover, upright as each side is looked at.
struct BookTextures {
  image::Image front, spine, back;
};

/// The cover that ships with the program.
image::Image builtinFront();
image::Image builtinSpine();
image::Image builtinBack();

/// Owns an OpenGL context; make, use and destroy it on one thread, one at a time in a process. A
/// picture depends on nothing but the settings, the textures and the cage.
class Renderer {
 public:
  /// Throws MachineError where there is no OpenGL 3.3 as settings.device asks for it, or one that
  /// draws nothing, InputError for a device that isn't there and for a size or texture that is too
  /// large for it.
  Renderer(const RenderSettings& settings, const BookTextures& textures);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// A picture of the right size and format for draw().
  image::Image makePicture() const;
  /// Draws the book in this cage (world), over all of `picture` (from makePicture()).
  /// Alpha is straight, and 255 throughout unless the background is transparent.
  /// Throws MachineError if OpenGL reports an error.
  void draw(const physics::Cage& cage, image::Image& picture);

  /// The same in two steps, of which the second, compositor().compose(), may be taken on another
  /// thread while this one draws the next one. `body` comes from makeBody().
  void draw(const physics::Cage& cage, DrawnBody& body);
  DrawnBody makeBody() const;
  Compositor& compositor();

  /// What draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5, EGL device 0".
  const std::string& description() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::render
