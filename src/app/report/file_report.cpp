#include "report/file_report.h"

#include <cmath>

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::report {

std::string spaceWarning(const store::DiskSpace& space, const std::filesystem::path& folder,
                         bool pngs) {
  if (space.needed <= space.free) return "";
  const auto sized = [](double bytes) {
    if (bytes < 1e6) return std::to_string(std::llround(bytes / 1e3)) + " kB";
    return bytes < 1e9 ? std::to_string(std::llround(bytes / 1e6)) + " MB"
                       : roundedText(bytes / 1e9, 2) + " GB";
  };
  return "about " + sized(space.needed) + " are needed in " + oneLine(folder.string()) + " and " +
         sized(space.free) + " are free: make room" +
         (pngs ? ", or leave PNGs out with --no-png" : "");
}

}  // namespace rotatebook::report
