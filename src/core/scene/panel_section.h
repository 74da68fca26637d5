// [[panel]], in and out.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {

inline constexpr std::size_t kMinPanels = 2;
inline constexpr std::size_t kMaxPanels = 6;

/// Reads `panels`, each over the sections of `file`, the whole: what a panel leaves out is as the
/// file has it, or else the default. All have `timePerFrame`. [s] Throws InputError.
std::vector<Panel> readPanels(const ValueReader& panels, const ValueReader& file,
                              double timePerFrame);

}  // namespace rotatebook::scene
