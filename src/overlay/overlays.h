// What is written over the pictures of a clip.
#pragma once

#include <cstdint>
#include <memory>

#include "image/image.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// Draws over the pictures of one clip what its scene shows; what doesn't change is drawn once. Use
/// it on one thread. Letters are a share of the picture's height, but never too small to read.
class Overlays {
 public:
  /// Throws InputError if there is no such font, or if it lacks a letter of the scene's words.
  explicit Overlays(const scene::Scene& scene);
  ~Overlays();
  Overlays(Overlays&&) noexcept;
  Overlays& operator=(Overlays&&) noexcept;

  /// Rows at the picture's bottom that words take, 0 to half of them. [pixels]
  int bottomRows() const;
  /// Draws over `picture`, of the clip's size, which shows frame `frame`.
  void draw(std::int64_t frame, image::Image& picture);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::overlay
