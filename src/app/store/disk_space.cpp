#include "store/disk_space.h"

#include <cmath>
#include <system_error>

#include "base/error.h"

namespace rotatebook::store {
namespace {

// A frame's bytes grow with its pixels to this power: edges and letters of the book take a larger
// share of small pictures.
constexpr double kPower = 0.85;
// Bytes a frame over pixels to that power, measured from 96x54 to 1280x720 on the starter scene; in
// brackets on other scenes, with overlays and faster rotation. FormatRow::weight is that of videos.
constexpr double kPngWeight = 5;      // measured 3.6 to 3.8 (2.7 to 7.0)
constexpr double kVideoBase = 8192;   // A video without its frames: measured 3 to 6 kB. [bytes]
constexpr double kTableRow = 890;     // A row of a table: measured 825 to 888. [bytes]
constexpr double kChecksumLine = 50;  // A line of frames.xxh128. [bytes]
constexpr double kFileBlock = 4096;   // Most file systems round up to this. [bytes]
constexpr double kSmallFiles = 3 * kFileBlock;  // Scene, manifest, checksums. [bytes]

double bytesNeeded(const scene::Scene& scene, const FilesToWrite& files) {
  const double picture =
      std::pow(static_cast<double>(scene.clip.width) * scene.clip.height, kPower);
  const double png = kPngWeight * picture + kFileBlock;
  const double table = kTableRow * static_cast<double>(scene.clip.frameCount()) + kFileBlock;
  double bytes = kSmallFiles + table * static_cast<double>(motionsOf(scene).size());
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
    throw MachineError("can't read the free space of " + folder.string() + ": " + error.message());
  return {bytesNeeded(scene, files), static_cast<double>(space.available)};
}

}  // namespace rotatebook::store
