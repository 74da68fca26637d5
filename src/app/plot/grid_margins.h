// The margins of a grid of books: the keys' names and values.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"
#include "overlay/text.h"
#include "plot/panel_grid.h"
#include "scene/scene.h"

namespace rotatebook::plot {

/// Arranges the cells of a scene's grid, and writes the columns' values above them and the rows'
/// values on their left.
class GridMargins {
 public:
  /// Leaves the picture's lower `bottomRows` [pixels] free. Throws InputError, with the line of the
  /// scene, if the font lacks a letter or the margins leave no room for the books.
  GridMargins(const scene::Scene& scene, int bottomRows);

  /// Returns the cells, all of one size, row by row.
  const PanelGrid& cells() const { return cells_; }
  /// Draws over `picture`, of the clip's size.
  void draw(image::Image& picture) const;

 private:
  /// A text and its top left on the picture. [pixels]
  struct Text {
    overlay::Layer layer;
    double x = 0, y = 0;
  };
  /// Lengths. [pixels]
  struct Lengths {
    int margin = 0, gap = 0, left = 0, top = 0;
  };

  std::vector<Text> valuesOf(const scene::Axis& axis, int width) const;
  void layOut(const scene::Scene& scene, int bottomRows);
  void place(Text& text, double x, double y);
  void placeColumns(const scene::Axis& columns, std::vector<Text> values, const Lengths& lengths);
  void placeRows(std::vector<Text> values, std::vector<Text> name, const Lengths& lengths);
  std::vector<Text> linesOf(const std::string& name, int width) const;

  overlay::Typesetter type_;
  overlay::Ink ink_;
  overlay::TextStyle nameStyle_, valueStyle_;
  PanelGrid cells_;
  std::vector<Text> texts_;
};

}  // namespace rotatebook::plot
