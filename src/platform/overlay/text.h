// Text on pictures.
#pragma once

#include <memory>
#include <string>

#include "overlay/box.h"
#include "overlay/colour.h"
#include "overlay/ink.h"
#include "overlay/layer.h"
#include "scene/scene.h"

struct _cairo;  // NOLINT(bugprone-reserved-identifier): Cairo's name of its context

namespace rotatebook::overlay {

/// The look of a text.
struct TextStyle {
  double size = 16;  ///< Font size, > 0. [pixels]
  bool bold = false;
  Colour colour;
  double opacity = 1;    ///< 0 to 1
  double halo = 0;       ///< Width of a dark edge around the letters, >= 0. [pixels]
  bool tabular = false;  ///< All digits are equally wide, for numbers that change.
};

/// The width and height of a text. [pixels]
struct TextSize {
  int width = 0;
  int height = 0;
};

/// Returns `time` [s] as a clock shows it, with the decimal mark of `words`: "1.50 s".
std::string clockText(double time, const scene::Words& words);

/// Typesets text in one font family, identical to the last pixel on every machine with the same
/// libraries: with the font that ships with the program, no hinting, grey antialiasing. Use each on
/// one thread.
class Typesetter {
 public:
  /// Takes the font that ships with the program, Inter.
  Typesetter();
  /// Takes an installed font family. Throws InputError if there is none of that name.
  explicit Typesetter(const std::string& family);
  /// Takes the font that a scene's overlay.font names, a family or scene::kBuiltin, and turns
  /// colours into those for its background. Throws InputError with the line of the scene if there
  /// is no such family.
  static Typesetter of(const scene::Scene& scene) { return of(scene, Ink(scene)); }
  /// Likewise, but turns colours into those of `ink`.
  static Typesetter of(const scene::Scene& scene, const Ink& ink);
  Typesetter(Typesetter&&) noexcept;
  ~Typesetter();

  /// Returns the size of UTF-8 `text`, wrapped at word boundaries to lines of at most `width`
  /// [pixels]; a line feed ends a line, too.
  TextSize measure(const std::string& text, const TextStyle& style, int width) const;
  /// Returns whether the lines of `text` begin at the right, as in Hebrew and Arabic: whether its
  /// first letter is of such a script.
  bool isReadFromTheRight(const std::string& text) const;
  /// Draws the text, wrapped likewise: its top left is at the origin, the halo extends beyond.
  /// Throws InputError, naming the letter, if the font lacks one.
  Layer draw(const std::string& text, const TextStyle& style, int width) const;
  /// Draws it likewise with Cairo, with its top left at `position`: as letters where what `cairo`
  /// draws on has such.
  void draw(const std::string& text, const TextStyle& style, int width, _cairo* cairo,
            const Point& position) const;

 private:
  struct Parts;
  /// Loads the shipped font at first use: many pictures have no text.
  const Parts& parts() const;

  mutable std::unique_ptr<Parts> parts_;
  Ink ink_;
};

}  // namespace rotatebook::overlay
