// CaptionAndClock on a picture.
#pragma once

#include <memory>
#include <string>

#include "overlay/layer.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// An opaque colour, sRGB, each part from 0 to 1.
struct Colour {
  double red = 1, green = 1, blue = 1;
};

/// How words look.
struct TextStyle {
  double size = 16;  ///< Height of the letters' body, > 0. [pixels]
  bool bold = false;
  Colour colour;
  double opacity = 1;    ///< 0 to 1
  double halo = 0;       ///< How far a dark edge reaches around the letters, >= 0. [pixels]
  bool tabular = false;  ///< All figures as wide as one another, for numbers that change.
};

/// The width and height that words take. [pixels]
struct TextSize {
  int width = 0;
  int height = 0;
};

/// Sets and draws words in one font family, the same to the last pixel on every machine with these
/// libraries: the font that ships with the program, no hinting, grey edges. Use one on one thread.
class Typesetter {
 public:
  /// The font that ships with the program, Inter.
  Typesetter();
  /// An installed family. Throws InputError, naming families that are near, if there is none of
  /// that name.
  explicit Typesetter(const std::string& family);
  /// What a scene's overlay.font means: a family, or scene::kBuiltin. Throws InputError with the
  /// place in the scene if there is no such family.
  static Typesetter of(const scene::Scene& scene);
  ~Typesetter();
  Typesetter(Typesetter&&) noexcept;
  Typesetter& operator=(Typesetter&&) noexcept;

  /// Size of UTF-8 `text`, broken into lines at words so that none is wider than `width` [pixels];
  /// a line feed ends a line, too.
  TextSize measure(const std::string& text, const TextStyle& style, int width) const;
  /// The words alone, their top left at the origin, the halo beyond it. Throws InputError, naming
  /// the letter, if the font lacks one.
  Layer draw(const std::string& text, const TextStyle& style, int width) const;

 private:
  struct Parts;
  /// The shipped font is loaded with the first words: many pictures have none.
  const Parts& parts() const;

  mutable std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::overlay
