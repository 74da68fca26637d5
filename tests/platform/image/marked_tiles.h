// What pictures have shown in tiles with the same marks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "image/image.h"

namespace rotatebook::image::testing {

/// Remembers the tiles of pictures of one size and format by their marks.
class MarkedTiles {
 public:
  /// Adds a picture's; returns whether all show what those with their marks did before.
  bool agreeWith(const Image& picture) {
    bool agree = picture.view().marks != nullptr;
    Tiles(picture.width(), picture.height())
        .forEach(picture.area(), [&](std::size_t number, const Area& tile) {
          const std::uint64_t mark = agree ? picture.view().marks[number] : 0;
          const auto [found, isNew] = shown_.try_emplace({number, mark}, bytesOf(picture, tile));
          agree = agree && mark != 0 && found->second == bytesOf(picture, tile);
          if (!isNew) ++known_;
        });
    return agree;
  }

  /// Returns how many tiles had the marks of earlier ones.
  std::size_t known() const { return known_; }

 private:
  static std::string bytesOf(const Image& picture, const Area& tile) {
    const std::ptrdiff_t size = bytesPerPixel(picture.format());
    std::string bytes;
    for (int y = tile.y; y < tile.bottom(); ++y)
      bytes +=
          picture.bytes().substr(static_cast<std::size_t>(y * picture.stride() + tile.x * size),
                                 static_cast<std::size_t>(tile.width * size));
    return bytes;
  }

  std::map<std::pair<std::size_t, std::uint64_t>, std::string> shown_;
  std::size_t known_ = 0;
};

}  // namespace rotatebook::image::testing
