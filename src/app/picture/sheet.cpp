#include "picture/sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/core.h>

#include "base/clip_limits.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "image/png_file.h"
#include "overlay/text.h"
#include "picture/frame_drawer.h"
#include "picture/still.h"
#include "scene/poster_frame.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::picture {
namespace {

// Shares of a picture's height.
constexpr double kTextSize = 0.05;
constexpr double kPictureGap = 0.06;
constexpr double kMaxPixels = 2.5e8;  // each takes twice 4 bytes of memory
constexpr double kSmallestText = 11;  // [pixels]

constexpr std::uint8_t kBackground = 22;            // 0 to 255
constexpr overlay::Colour kText{0.86, 0.86, 0.84};  // contrast to the background 12.6

/// A picture and the label below it.
struct Cell {
  image::Image picture;
  overlay::Layer label;
};

/// The sheet's lengths. [pixels]
struct Grid {
  int columns;
  int rows;
  int gap;
  int cellWidth;
  int cellHeight;  ///< Of a picture and its label.

  int width() const { return columns * (cellWidth + gap) + gap; }
  int height() const { return rows * (cellHeight + gap) + gap; }
};

void refuseOtherSizes(const std::vector<scene::Scene>& scenes) {
  const scene::ClipSettings& first = scenes.front().clip;
  for (const scene::Scene& scene : scenes) {
    if (scene.clip.width == first.width && scene.clip.height == first.height) continue;
    throw InputError(
        fmt::format("{} differs in size from {}; set one size for all, for example --size 480x270",
                    scene.name, scenes.front().name));
  }
}

/// Throws InputError, before anything is drawn, if the pictures would take too much memory: all are
/// kept until the sheet is composed.
void refuseTooMany(const std::vector<scene::Scene>& scenes, const SheetOptions& options) {
  const scene::ClipSettings& clip = scenes.front().clip;
  const std::size_t each =
      options.times.empty() ? static_cast<std::size_t>(options.count) : options.times.size();
  const double pixels = static_cast<double>(each * scenes.size()) * clip.width * clip.height;
  if (pixels <= kMaxPixels) return;
  throw InputError(
      fmt::format("the sheet would have {} pictures of {}, {} million pixels, but may have at most "
                  "{}; take fewer or smaller pictures, for example --size 480x270",
                  each * scenes.size(), sizeText(clip.width, clip.height),
                  roundedText(pixels / 1e6, 3), roundedText(kMaxPixels / 1e6, 3)));
}

std::vector<std::int64_t> framesOf(const scene::Scene& scene, const timeline::ClipMotion& motion,
                                   const SheetOptions& options) {
  std::vector<std::int64_t> frames;
  for (const double time : options.times) frames.push_back(frameAt(scene, motion, time));
  if (!frames.empty()) return frames;
  const std::int64_t last = motion.frameCount() - 1;
  if (options.count == 1) return {scene::posterFrame(scene.clip, last + 1)};
  for (int i = 0; i < options.count; ++i) {
    frames.push_back(std::llround(static_cast<double>(last) * i / (options.count - 1)));
  }
  return frames;
}

/// Returns the frame's time in the video, as --times and still take it, and where the motion's is
/// another, that, too: "6.00 s, t = 1.20 s".
std::string timeText(const scene::Scene& scene, const timeline::ClipMotion& motion,
                     std::int64_t frame) {
  const scene::Words& words = scene.overlay.words;
  const double inVideo = static_cast<double>(frame) * scene.clip.frameRate.period();
  const std::string video = overlay::clockText(inVideo, words);
  const double time = timeAt(scene, static_cast<double>(motion.clockFrame(frame)));
  const std::string clock = overlay::clockText(time, words);
  return video == clock ? video : video + ", t = " + clock;
}

void addCells(const scene::Scene& scene, const SheetOptions& options, bool named,
              std::vector<Cell>& cells) {
  // The letters of overlay.words and titles are those of overlay.font
  const auto type = overlay::Typesetter::of(scene, overlay::Ink());
  const timeline::ClipMotion motion = timeline::simulateScene(scene);
  const std::vector<std::int64_t> frames = framesOf(scene, motion, options);
  const overlay::TextStyle style{std::max(kSmallestText, kTextSize * scene.clip.height), false,
                                 kText};
  FrameDrawer drawer(scene, motion, options.device);
  for (const std::int64_t frame : frames) {
    image::Image picture = drawer.makePicture();
    drawer.draw(frame, picture);
    std::string label = named ? scene.title : "";
    if (frames.size() > 1 || !named) {
      label += (named ? ", " : "") + timeText(scene, motion, frame);
    }
    cells.push_back({std::move(picture), type.draw(label, style, scene.clip.width)});
  }
}

Grid gridFor(const std::vector<Cell>& cells, int columns) {
  const auto count = static_cast<int>(cells.size());
  const image::Image& picture = cells.front().picture;
  int labelHeight = 0;
  for (const Cell& cell : cells) labelHeight = std::max(labelHeight, cell.label.height);
  Grid grid{};
  grid.columns = columns > 0 ? columns : static_cast<int>(std::ceil(std::sqrt(count)));
  grid.columns = std::min(grid.columns, count);
  grid.rows = (count + grid.columns - 1) / grid.columns;
  grid.gap = std::max(4, static_cast<int>(std::lround(kPictureGap * picture.height())));
  grid.cellWidth = picture.width();
  grid.cellHeight = picture.height() + grid.gap / 3 + labelHeight;
  return grid;
}

void refuseTooLarge(const Grid& grid) {
  if (grid.width() <= kMaxPictureSide && grid.height() <= kMaxPictureSide) return;
  throw InputError(
      fmt::format("the sheet would have {} pixels, but a side may have at most {}; take fewer or "
                  "smaller pictures, for example --size 480x270",
                  sizeText(grid.width(), grid.height()), kMaxPictureSide));
}

}  // namespace

image::Image drawSheet(const std::vector<scene::Scene>& scenes, const SheetOptions& options) {
  refuseOtherSizes(scenes);
  refuseTooMany(scenes, options);
  std::vector<Cell> cells;
  for (const scene::Scene& scene : scenes) {
    addCells(scene, options, scenes.size() > 1, cells);
  }
  const Grid grid = gridFor(cells, options.columns);
  refuseTooLarge(grid);
  image::Image sheet(grid.width(), grid.height(), cells.front().picture.format());
  std::fill_n(sheet.row(0), sheet.stride() * sheet.height(), kBackground);
  for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
    Cell& cell = cells[static_cast<std::size_t>(i)];
    const int x = grid.gap + i % grid.columns * (grid.cellWidth + grid.gap);
    const int y = grid.gap + i / grid.columns * (grid.cellHeight + grid.gap);
    image::paste(cell.picture.view(), x, y, sheet);
    cell.label.x = x;
    cell.label.y = y + cell.picture.height() + grid.gap / 3;
    blend(cell.label, sheet);
  }
  return sheet;
}

}  // namespace rotatebook::picture
