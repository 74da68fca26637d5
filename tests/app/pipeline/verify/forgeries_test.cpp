// The table in docs/tables/forgeries.md of what is noticed, and what isn't.
#include "pipeline/verify/forgeries.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "pipeline/verify/picture_comparison.h"
#include "store/encoding.h"
#include "video/clip_reader.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::PictureForgery;

constexpr const char* kHead =
    "| change | 320x180 | 640x360 | 640x360, medium | 640x360, veryslow | 640x360, WebM |\n"
    "|---|---|---|---|---|---|\n";

/// The measures of a forged clip's pictures over their bounds; above 1 a picture is refused.
struct Excess {
  double smallest = 0;  ///< Of any picture; of each the largest measure counts.
  double largest = 0;
};

/// The pictures of a clip, which forgeries are made from.
class ForgedClips {
 public:
  explicit ForgedClips(const std::string& size)
      : scene_(scene::testing::smallScene({"clip.size=" + size})) {
    const timeline::ClipMotion motion = timeline::simulateScene(scene_);
    picture::FrameDrawer drawer(scene_, motion);
    for (std::int64_t frame = 0; frame < motion.frameCount(); ++frame) {
      pictures_.push_back(drawer.makePicture());
      drawer.draw(frame, pictures_.back());
      drawn_.push_back(video::planesToEncode(pictures_.back().view(), false));
    }
  }

  Excess excess(const PictureForgery& forgery, video::VideoFormat format,
                const std::string& preset = "book") const {
    const fs::path path = testing::emptyFolder() / "forged.video";
    write(forgery, format, preset, path);
    video::ClipReader reader(path);
    Excess excess{.smallest = std::numeric_limits<double>::infinity()};
    for (std::size_t frame = 0; reader.next(); ++frame) {
      const video::PictureFacts& coded = reader.pictureFacts();
      const PictureCheck check =
          compareWith(drawn_.at(frame), static_cast<std::int64_t>(frame), reader.picture(),
                      {coded.quantiser, coded.coarsestQuantiser});
      double largest = 0;
      for (const MeasureRow& row : kMeasures) {
        largest = std::max(largest, check.measured.*row.value / check.bound.*row.value);
      }
      excess.smallest = std::min(excess.smallest, largest);
      excess.largest = std::max(excess.largest, largest);
    }
    return excess;
  }

 private:
  void write(const PictureForgery& forgery, video::VideoFormat format, const std::string& preset,
             const fs::path& path) const {
    video::VideoSettings settings = store::videoSettings(scene_, "");
    settings.preset = preset;
    video::VideoWriter writer(format, path, settings);
    for (const image::Image& picture : pictures_) {
      image::Image forged = picture;
      forgery.apply(forged);
      writer.write(forged.view());
    }
    writer.finish();
  }

  scene::Scene scene_;
  std::vector<image::Image> pictures_;
  std::vector<video::Planes> drawn_;  // Of `pictures_`.
};

std::string documentation() {
  std::ostringstream text;
  text << std::ifstream(fs::path(ROTATEBOOK_SOURCE) / "docs/tables/forgeries.md").rdbuf();
  return text.str();
}

/// Returns the table's cell: `known`, the document's, if the excess is so close to 1 that a last
/// bit decides. Pixels and x264's streams (cpu-independent) are the same on every processor: of the
/// 170 shares none differed between two machines (measured 0). Other FFmpegs may give another
/// table.
std::string cellOf(const Excess& excess, const std::string& known) {
  constexpr double kClose = 0.01;
  const auto isClose = [](double value) { return std::abs(value - 1) < kClose; };
  if (!known.empty() && (isClose(excess.smallest) || isClose(excess.largest))) return known;
  if (excess.smallest > 1) return "in each picture";
  return excess.largest > 1 ? "in some" : "no";
}

/// Returns the cells after the row's name in the document; empty ones if there is no such row.
std::vector<std::string> documentedCells(const std::string& text, const std::string& name) {
  std::vector<std::string> cells(5);
  const std::size_t at = text.find("\n| " + name + " | ");
  if (at == std::string::npos) return cells;
  std::istringstream rest(text.substr(at + name.size() + 6));
  for (std::string& cell : cells) {
    std::getline(rest, cell, '|');
    cell = cell.substr(0, cell.find_last_not_of(' ') + 1);
    rest.get();
  }
  return cells;
}

TEST(Forgeries, AreNoticedAsTheDocumentationSays) {
  const std::string text = documentation();
  const ForgedClips small("[320, 180]"), large("[640, 360]");
  std::string table = kHead, shares;
  for (const PictureForgery& forgery : testing::forgeries()) {
    const std::vector<std::string> known = documentedCells(text, forgery.name);
    const std::vector<Excess> excesses{small.excess(forgery, video::VideoFormat::Mp4),
                                       large.excess(forgery, video::VideoFormat::Mp4),
                                       large.excess(forgery, video::VideoFormat::Mp4, "medium"),
                                       large.excess(forgery, video::VideoFormat::Mp4, "veryslow"),
                                       large.excess(forgery, video::VideoFormat::WebM)};
    table += "| " + forgery.name + " |";
    for (std::size_t i = 0; i < excesses.size(); ++i) {
      table += " " + cellOf(excesses[i], known[i]) + " |";
      shares += std::to_string(excesses[i].smallest) + " to " +
                std::to_string(excesses[i].largest) + "; ";
    }
    table += "\n";
    shares += forgery.name + "\n";
  }
  EXPECT_NE(text.find(table), std::string::npos) << "docs/tables/forgeries.md is to have\n"
                                                 << table << "measured over bound:\n"
                                                 << shares;
}

}  // namespace
}  // namespace rotatebook::pipeline
