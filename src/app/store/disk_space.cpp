#include "store/disk_space.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::store {
namespace {

// A frame's bytes grow with its pixels to this power: edges and letters of the book take a larger
// share of small pictures.
constexpr double kPower = 0.85;
// Bytes a frame over pixels to that power, measured from 96x54 to 1280x720 on the starter scene; in
// brackets on other scenes, with overlays and faster rotation. FormatRow::weight is that of videos.
constexpr double kPngWeight = 3;  // measured 2.8 to 3.0, without a caption
// Each letter of the caption adds, up to so many bytes: it fills more of a small picture, and makes
// the book smaller on a large one.
constexpr double kLetterWeight = 0.009;  // measured 0.001 to 0.0088
constexpr double kLargestLetter = 35;    // measured 18 to 32. [bytes]
constexpr double kVideoBase = 8192;      // A video without its frames: measured 3 to 6 kB. [bytes]
constexpr double kTableRow = 890;        // A row of a table: measured 825 to 888. [bytes]
constexpr double kChecksumLine = 50;     // A line of frames.xxh128. [bytes]
constexpr double kFileBlock = 4096;      // Most file systems round up to this. [bytes]
constexpr double kSmallFiles = 3 * kFileBlock;  // Scene, manifest, checksums. [bytes]

/// Returns the bytes that the caption adds to a PNG.
double captionBytes(const scene::Scene& scene, double picture) {
  if (!scene::shows(scene, scene::Overlay::Caption)) return 0;
  return static_cast<double>(characterCount(scene.caption)) *
         std::min(kLetterWeight * picture, kLargestLetter);
}

double bytesNeeded(const scene::Scene& scene, const FilesToWrite& files) {
  const double picture =
      std::pow(static_cast<double>(scene.clip.width) * scene.clip.height, kPower);
  const double png = kPngWeight * picture + captionBytes(scene, picture) + kFileBlock;
  const double table = kTableRow * static_cast<double>(scene.clip.frameCount()) + kFileBlock;
  double bytes = kSmallFiles + table * static_cast<double>(scene.motions.size());
  bytes += png;  // the poster
  bytes += static_cast<double>(files.pngs) * (png + kChecksumLine);
  for (const video::VideoFormat format : files.formats) {
    bytes += kVideoBase + rowOf(format).weight * picture * static_cast<double>(files.frames);
  }
  return bytes;
}

}  // namespace

DiskSpace diskSpace(const scene::Scene& scene, const FilesToWrite& files,
                    const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if (error)
    throw MachineError(
        fmt::format("can't read the free space of {}: {}", folder.string(), error.message()));
  return {bytesNeeded(scene, files), static_cast<double>(space.available)};
}

std::string spaceWarning(const DiskSpace& space, const std::filesystem::path& folder, bool pngs) {
  if (space.needed <= space.free) return "";
  const auto sized = [](double bytes) {
    if (bytes < 1e6) return fmt::format("{} kB", std::llround(bytes / 1e3));
    return bytes < 1e9 ? fmt::format("{} MB", std::llround(bytes / 1e6))
                       : fmt::format("{} GB", roundedText(bytes / 1e9, 2));
  };
  return fmt::format("about {} are needed in {} and {} are free: make room{}", sized(space.needed),
                     oneLine(folder.string()), sized(space.free),
                     pngs ? ", or leave PNGs out with --no-png" : "");
}

}  // namespace rotatebook::store
