// Meshes of files as surfaces of bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "body/surface.h"
#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// The changes that made a mesh closed, and the triangles that were left out.
struct Closing {
  /// The triangles' numbers in their file, from 0; empty if all were kept.
  std::vector<std::uint32_t> numbers{};
  std::vector<std::string> notes{};  ///< Sentences that say what.

  /// Returns the number in its file of a triangle, both from 0.
  std::size_t numberOf(std::size_t triangle) const {
    return numbers.empty() ? triangle : numbers[triangle];
  }
};

/// A surface that encloses a body, as its file has it, but for what the notes say.
struct ClosedMesh {
  Surface surface;  ///< Welded; requireClosed() accepts its mesh.
  Closing closing{};
  std::string undrawable{};  ///< Why its look can't be read; empty if it can.
};

/// Welds a surface. Leaves triangles out that have a corner twice, which changes nothing that a
/// surface encloses. Joins points that are nearer than kNearPoints where the surface isn't closed
/// without; else all bits stay as they are. Throws as welded(), requireClosed()
/// and requireVoidsInside() do.
Closing closeSurface(Surface& surface);

}  // namespace rotatebook::body
