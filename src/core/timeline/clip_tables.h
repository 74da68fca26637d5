// The tables of a clip's motions.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// Returns the number of tables that a clip has: one for each motion, but a grid has a single one.
std::size_t tableCount(const scene::Scene& scene);

/// Passes table `index` to `take` in pieces: writeCsv() of a motion, or gridCsv().
void writeTable(const scene::Scene& scene, const ClipMotion& motion, std::size_t index,
                const std::function<void(std::string_view)>& take);
/// Returns the same table as a whole.
std::string tableText(const scene::Scene& scene, const ClipMotion& motion, std::size_t index);
/// Returns whether a row without its line end is the header of such a table: of a motion's or of a
/// grid's, of this version or an earlier one.
bool isTableHeader(std::string_view row);
/// Returns the number of its rows, without the header.
std::size_t rowCount(const scene::Scene& scene, const ClipMotion& motion, std::size_t index);

/// Returns a table of a grid, one row a cell, row by row: the values of its column and its row,
/// under the names of their keys; then, of the motion's last frame, the same quantities as
/// expectations have, and the time at which it diverged, empty if it didn't. SI units; numbers read
/// back to the same bits.
std::string gridCsv(const scene::Scene& scene, const ClipMotion& motion);

}  // namespace rotatebook::timeline
