// Reads [[panel]], the motions that a clip shows side by side. Inside the room only.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {

inline constexpr std::size_t kMinPanels = 2;
inline constexpr std::size_t kMaxPanels = 6;

/// Reads `panels`. What a panel leaves out is taken from the sections of `file`, the whole scene
/// file, or else from the defaults. All panels have `timePerFrame`. [s] Throws InputError.
std::vector<Panel> readPanels(const ValueReader& panels, const ValueReader& file,
                              double timePerFrame);

}  // namespace rotatebook::scene
