// Whether this machine can render, part by part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/graphics_check.h"
#include "diagnose/remedies.h"
#include "video/encoder_check.h"

namespace rotatebook::diagnose {

/// Where the results would go.
struct FolderCheck {
  std::filesystem::path path{};
  std::uintmax_t freeBytes = 0;  ///< For this user.
  std::string failure{};         ///< Why nothing can be written there, or empty.
};

/// What checkUp() found.
struct Checkup {
  GraphicsCheck graphics{};
  std::vector<video::EncoderCheck> encoders{};  ///< One a format, in their order.
  std::string fontFailure{};  ///< Why the font that ships can't be loaded, or empty.
  FolderCheck folder{};
  int cores = 1;
  double memory = 0;                ///< [bytes]
  std::vector<Problem> problems{};  ///< Of all parts, the graphics' first.

  /// Whether a render with no options beside its folder would work: PNGs and MP4.
  bool ready() const;
};

/// In the folder, or what there is of its path, a file is begun and taken away: nothing is left.
Checkup checkUp(const std::filesystem::path& folder);

}  // namespace rotatebook::diagnose
