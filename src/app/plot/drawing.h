// Lines, areas, letters and pictures of plots, which become files of any format. Inside the room
// only.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "overlay/box.h"
#include "overlay/canvas.h"
#include "overlay/text.h"
#include "plot/plot_files.h"

struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier): Cairo's name

namespace rotatebook::plot {

using overlay::Box;
using overlay::Colour;
using overlay::Pen;
using overlay::Point;
using overlay::TextStyle;

/// Releases Cairo's objects.
struct Deleter {
  void operator()(_cairo* cairo) const;
  void operator()(_cairo_surface* surface) const;
};
using Cairo = std::unique_ptr<_cairo, Deleter>;
using Surface = std::unique_ptr<_cairo_surface, Deleter>;

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

  const Box& sheet() const { return sheet_; }
  const overlay::Typesetter& type() const { return type_; }
  /// Returns what draws lines and areas.
  overlay::Canvas& canvas() { return *canvas_; }
  /// Draws a picture of PixelFormat::Rgb8 into `box`, each of its pixels as a rectangle of one
  /// colour.
  void picture(const image::Image& picture, const Box& box);
  /// Writes text, wrapped to lines of at most `width`, such that the point at the shares `anchor`
  /// of its width and height is at `position`. Throws InputError, naming the letter, if the font
  /// lacks one.
  Box write(const std::string& text, const TextStyle& style, const Point& position,
            const Point& anchor = Point(0, 0), double width = 1e4);
  /// Returns all that was written.
  const std::vector<Written>& texts() const { return texts_; }

  /// Returns the sheet as pixels, `scale` of them for each of its own.
  image::Image pixels(double scale = 1) const;
  /// Returns the bytes of a file of one of the formats, which its ending names; `scale` is only of
  /// pixels. They are the same for the same drawing. Throws MachineError.
  std::string file(std::string_view ending, double scale = 1) const;

 private:
  Box sheet_;
  overlay::Typesetter type_;
  Surface surface_;  // records what is drawn
  Cairo cairo_;
  std::unique_ptr<overlay::Canvas> canvas_;
  std::vector<Written> texts_;
};

/// Returns a plot in the formats that the files end in: .png, .svg or .pdf. Throws MachineError.
std::vector<PlotFile> filesOf(const Drawing& drawing,
                              const std::vector<std::filesystem::path>& files, double scale = 1);

/// Returns the box of a text that write() would write at the origin.
Box boxOf(const overlay::Typesetter& type, const std::string& text, const TextStyle& style,
          double width = 1e4);

/// Returns the letters that the pictures of `scene` have. Throws like Typesetter::of().
overlay::Typesetter lettersOf(const scene::Scene& scene);

}  // namespace rotatebook::plot
