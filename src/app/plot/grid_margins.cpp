#include "plot/grid_margins.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "overlay/canvas.h"
#include "plot/plot.h"
#include "scene/key_rows.h"
#include "scene/source_locations.h"

namespace rotatebook::plot {
namespace {

using overlay::Colour;
using overlay::Layer;

// Shares of the picture's shorter side, times the size of overlays; and the smallest. [pixels]
constexpr double kMarginLetters = 0.0265, kSmallestMarginLetters = 9;
constexpr double kOuterMargin = 0.03, kSmallestMargin = 6;
constexpr double kWidestName = 0.13;   // of the rows' key, as a share of the picture's width
constexpr double kWidestValue = 0.25;  // of a row's value, likewise
constexpr int kSmallestGridCell = 16;  // shorter side [pixels]

constexpr Colour kValueColour{0.97, 0.96, 0.93}, kNameColour{0.72, 0.72, 0.74};

int wholePixels(double length) {
  return static_cast<int>(std::lround(length));
}

std::string valueText(const scene::AxisValue& value) {
  return value.number ? tickText(*value.number) : value.label;
}

template <typename Texts, typename Length>
int largestOf(const Texts& texts, const Length& length) {
  int most = 0;
  for (const auto& text : texts) most = std::max(most, length(text.layer));
  return most;
}

int layerHeight(const Layer& layer) {
  return wholePixels(overlay::boxOf(layer).height);
}

int layerWidth(const Layer& layer) {
  return wholePixels(overlay::boxOf(layer).width);
}

}  // namespace

GridMargins::GridMargins(const scene::Scene& scene, int bottomRows)
    : type_(overlay::Typesetter::of(scene)), ink_(scene) {
  const double unit = std::min(scene.clip.width, scene.clip.height) * scene.overlay.scale;
  const double letters = std::max(kMarginLetters * unit, kSmallestMarginLetters);
  nameStyle_ = {.size = letters, .colour = kNameColour};
  valueStyle_ = {.size = letters, .colour = kValueColour, .tabular = true};
  scene::atLocationOf(scene, "grid", [&] { layOut(scene, bottomRows); });
}

void GridMargins::layOut(const scene::Scene& scene, int bottomRows) {
  const scene::GridSettings& grid = *scene.grid;
  const auto columns = static_cast<int>(grid.columnCount()),
             rows = static_cast<int>(grid.rowCount());
  const int width = scene.clip.width, height = scene.clip.height;
  const double side = std::min(width, height);
  Lengths lengths{.margin = wholePixels(std::max(kOuterMargin * side, kSmallestMargin)),
                  .gap = wholePixels(0.5 * valueStyle_.size)};

  // Left of the cells
  std::vector<Text> rowValues, rowName;
  lengths.left = lengths.margin;
  if (grid.rows && !scene.textless) {
    rowValues = valuesOf(*grid.rows, wholePixels(kWidestValue * width));
    rowName = linesOf(nameOf(*grid.rows), wholePixels(kWidestName * width));
    lengths.left +=
        std::max(largestOf(rowValues, layerWidth), largestOf(rowName, layerWidth)) + lengths.gap;
  }
  cells_.width = (width - lengths.left - lengths.margin) / columns;

  // Above them
  std::vector<Text> columnValues;
  int above = 0;
  if (grid.columns && !scene.textless) {
    columnValues = valuesOf(*grid.columns, std::max(1, cells_.width));
    above = layerHeight(type_.draw(nameOf(*grid.columns), nameStyle_, width)) + lengths.gap / 2 +
            largestOf(columnValues, layerHeight);
  }
  int nameHeight = 0;
  for (const Text& line : rowName) nameHeight += layerHeight(line.layer);
  above = std::max(above, nameHeight);
  lengths.top = lengths.margin * 2 / 3 + above + (above > 0 ? lengths.gap / 2 : 0);
  const int bottom = bottomRows > 0 ? bottomRows : lengths.margin;
  cells_.height = (height - lengths.top - bottom) / rows;
  if (std::min(cells_.width, cells_.height) < kSmallestGridCell) {
    throw InputError(
        fmt::format("the {} books of the grid have no room in {} pixels; make the picture larger, "
                    "or the texts shorter",
                    columns * rows, sizeText(width, height)));
  }
  for (int i = 0; i < columns * rows; ++i) {
    cells_.positions.push_back(
        {lengths.left + i % columns * cells_.width, lengths.top + i / columns * cells_.height});
  }
  if (!columnValues.empty()) placeColumns(*grid.columns, std::move(columnValues), lengths);
  if (!rowValues.empty()) placeRows(std::move(rowValues), std::move(rowName), lengths);
}

std::vector<GridMargins::Text> GridMargins::valuesOf(const scene::Axis& axis, int width) const {
  std::vector<Text> values;
  for (const scene::AxisValue& value : axis.values) {
    values.push_back({type_.draw(valueText(value), valueStyle_, width)});
  }
  return values;
}

std::vector<GridMargins::Text> GridMargins::linesOf(const std::string& name, int width) const {
  std::vector<Text> lines;
  std::istringstream words(name);
  std::string line;
  const auto add = [&] { lines.push_back({type_.draw(line, nameStyle_, 4 * width)}); };
  for (std::string word; words >> word;) {
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && type_.measure(longer, nameStyle_, 4 * width).width > width) {
      add();
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) add();
  return lines;
}

void GridMargins::place(Text& text, double x, double y) {
  text.x = x;
  text.y = y;
  texts_.push_back(std::move(text));
}

/// Centres the values over their columns, on one line at the bottom; the key's name is above them.
void GridMargins::placeColumns(const scene::Axis& columns, std::vector<Text> values,
                               const Lengths& lengths) {
  const int bottom = lengths.top - lengths.gap / 2, tallest = largestOf(values, layerHeight);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double room = cells_.width - layerWidth(values[i].layer);
    place(values[i], cells_.positions[i].x + std::round(room / 2),
          bottom - layerHeight(values[i].layer));
  }
  const int room = cells_.width * static_cast<int>(values.size());
  Text name{type_.draw(nameOf(columns), nameStyle_, room)};
  place(name, lengths.left + std::round((room - layerWidth(name.layer)) / 2.0),
        bottom - tallest - lengths.gap / 2 - layerHeight(name.layer));
}

/// Puts the values beside the middles of their rows, and the key's name above them.
void GridMargins::placeRows(std::vector<Text> values, std::vector<Text> name,
                            const Lengths& lengths) {
  const int right = lengths.left - lengths.gap;
  const std::size_t columns = cells_.positions.size() / values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double room = cells_.height - layerHeight(values[i].layer);
    place(values[i], right - layerWidth(values[i].layer),
          cells_.positions[i * columns].y + std::round(room / 2));
  }
  int y = lengths.top - lengths.gap / 2;
  for (auto line = name.rbegin(); line != name.rend(); ++line) {
    y -= layerHeight(line->layer);
    place(*line, right - layerWidth(line->layer), y);
  }
}

void GridMargins::draw(image::Image& picture) const {
  overlay::Canvas canvas(picture.width(), picture.height(), ink_);
  for (const Text& text : texts_) canvas.write(text.layer, {text.x, text.y});
  canvas.layOver(picture);
}

}  // namespace rotatebook::plot
