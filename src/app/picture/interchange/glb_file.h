// A .glb file in the making: glTF 2.0 with its binary data. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json.h"

namespace rotatebook::interchange {

/// The use of a list of numbers.
enum class Numbers {
  OfVertices,
  OfKeys,
  Ranged,  ///< Of vertices or keys, with their least and greatest values, as positions and times.
};

/// A document and its binary data, which grow together.
class GlbFile {
 public:
  /// Begins with the object "asset".
  explicit GlbFile(Json asset);

  /// Adds an object to a list of the document, such as "nodes"; returns its number there.
  std::size_t add(const char* list, Json object);
  /// Sets a member of the document.
  void set(const char* member, Json value) { json_[member] = std::move(value); }

  // Each returns the number of an accessor.
  /// Adds rows of so many 32-bit floats, 1, 2, 3 or 4.
  std::size_t addFloats(const std::vector<float>& numbers, std::size_t columns, Numbers use);
  /// Adds the rows (x, 0, 0), (0, x, 0) and (0, 0, x), with x from a list: positions of vertices,
  /// whose bytes the three accessors share.
  std::array<std::size_t, 3> addAlongAxes(const std::vector<float>& numbers);
  /// Adds `rows` of three floats, which are 0 but for those at `places`, in rising order.
  std::size_t addSparse(const std::vector<std::uint32_t>& places, const std::vector<float>& values,
                        std::size_t rows);
  /// Adds so many rows of the same four bytes, a vertex each.
  std::size_t addBytes(const std::array<std::uint8_t, 4>& row, std::size_t rows, bool normalised);
  /// Adds the corners of triangles, each below `vertices`.
  std::size_t addCorners(const std::vector<std::uint32_t>& corners, std::size_t vertices);

  /// Adds a picture, a PNG or JPEG; returns its number among "images".
  std::size_t addPicture(std::string_view bytes);

  /// Returns the file's bytes.
  std::string bytes() const;

 private:
  std::size_t addView(std::string_view bytes, int target);

  Json json_;
  std::string binary_;
};

}  // namespace rotatebook::interchange
