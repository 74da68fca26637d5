// What plots are drawn with: lines, areas, letters and pictures, which become files of any format.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "overlay/box.h"
#include "overlay/canvas.h"
#include "overlay/text.h"

namespace rotatebook::plot {

using overlay::Box;
using overlay::Colour;
using overlay::Pen;
using overlay::Point;
using overlay::TextStyle;

/// A text on a drawing.
struct Written {
  std::string text;
  Box box;
};

/// A sheet of paper, whose unit is a pixel of 1/96 inch. Use it on one thread.
class Drawing {
 public:
  /// Makes a sheet of that width and height, > 0, whose letters are of `type`.
  Drawing(double width, double height, const Colour& ground, overlay::Typesetter type);
  Drawing(Drawing&&) noexcept;
  ~Drawing();

  double width() const;
  double height() const;

  /// Strokes a line through two points or more, with round caps and joins.
  void line(std::span<const Point> points, const Pen& pen);
  /// Strokes separate lines, each from one point to the next.
  void lines(std::span<const Point> pairs, const Pen& pen);
  /// Fills a polygon.
  void area(std::span<const Point> corners, const Colour& colour);
  void disc(const Point& centre, double radius, const Colour& colour);
  void roundedBox(const Box& box, double radius, const Colour& colour);
  /// Draws a picture without alpha into `box`, each of its pixels as a rectangle of one colour.
  void picture(const image::Image& picture, const Box& box);
  /// Writes text, wrapped to lines of at most `width`, such that the point at the shares `anchor`
  /// of its width and height is at `position`. Throws InputError, naming the letter, if the font
  /// lacks one.
  Box write(const std::string& text, const TextStyle& style, const Point& position,
            const Point& anchor = Point(0, 0), double width = 1e4);

  /// Returns the size of a text that write() writes.
  overlay::TextSize sizeOf(const std::string& text, const TextStyle& style,
                           double width = 1e4) const;
  /// Returns all that was written.
  const std::vector<Written>& texts() const;

  /// Returns the sheet as pixels, `scale` of them for each of its own.
  image::Image pixels(double scale = 1) const;
  /// Return the bytes of a file. They are the same for the same drawing, but that an SVG has other
  /// names of its parts. Throw MachineError.
  std::string png(double scale) const;
  std::string svg(double scale) const;
  std::string pdf(double scale) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A format of a plot's file.
struct FormatRow {
  std::string_view ending;                            ///< With its dot.
  std::string (Drawing::*bytes)(double scale) const;  ///< The scale is only of pixels.
};

/// The formats that each plot is written in: the one list of them.
inline constexpr std::array<FormatRow, 3> kFormats{
    {{".png", &Drawing::png}, {".svg", &Drawing::svg}, {".pdf", &Drawing::pdf}}};

/// Writes a plot in each format, into its plotFiles(): each appears whole or not at all.
/// Throws MachineError.
void writePlot(const Drawing& drawing, const std::vector<std::filesystem::path>& files,
               double scale = 1);

/// Returns the letters that the pictures of `scene` have. Throws like Typesetter::of().
overlay::Typesetter lettersOf(const scene::Scene& scene);

/// Throws InputError if that font lacks a letter of `texts`: before the runs rather than after.
void requireLetters(const scene::Scene& scene, const std::vector<std::string>& texts);

}  // namespace rotatebook::plot
