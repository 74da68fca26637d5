// A check of whether this machine can render, part by part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/graphics_check.h"
#include "diagnose/remedies.h"
#include "video/encoder_check.h"

namespace rotatebook::diagnose {

/// The folder that results would be written to.
struct FolderCheck {
  std::filesystem::path path{};
  std::uintmax_t freeBytes = 0;  ///< Available to this user.
  std::string failure{};         ///< Why nothing can be written there, or empty.
};

/// The results of checkUp().
struct Checkup {
  GraphicsCheck graphics{};
  std::vector<video::EncoderCheck> encoders{};  ///< In the order of video::kVideoFormats.
  std::string fontFailure{};                    ///< Why the shipped font can't be loaded, or empty.
  FolderCheck folder{};
  int cores = 1;
  double memory = 0;                ///< [bytes]
  std::vector<Problem> problems{};  ///< Of all parts, the graphics' first.

  /// Returns whether a render to PNGs and MP4 with default options would work.
  bool ready() const;
};

/// Checks the machine. Creates and removes a file in `folder`, or in the nearest parent that
/// exists.
Checkup checkUp(const std::filesystem::path& folder);

/// Checks the drivers after a process that drew with `choice` crashed. Returns the problem of the
/// driver that it used, if that one ends a process. Throws what checkGraphics() throws.
std::optional<Problem> explainCrash(const render::DeviceChoice& choice);

}  // namespace rotatebook::diagnose
