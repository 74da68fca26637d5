// Files of glTF, for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "body/solids.h"

namespace rotatebook::meshes::testing {

inline void appendWord(std::string& bytes, std::uint32_t word) {
  bytes.append(reinterpret_cast<const char*>(&word), sizeof(word));
}

/// Returns a file of a description and binary data.
inline std::string glb(const std::string& json, const std::string& binary) {
  std::string bytes = "glTF";
  appendWord(bytes, 2);
  appendWord(bytes, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  appendWord(bytes, static_cast<std::uint32_t>(json.size()));
  appendWord(bytes, 0x4E4F534A);
  bytes += json;
  appendWord(bytes, static_cast<std::uint32_t>(binary.size()));
  appendWord(bytes, 0x004E4942);
  return bytes + binary;
}

/// Makes the lengths that a file of glb() states larger, after text was put into its description.
inline void restateLengths(std::string& bytes, std::size_t more) {
  for (const std::size_t at : {8, 12}) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + at, sizeof(length));
    length += static_cast<std::uint32_t>(more);
    std::memcpy(bytes.data() + at, &length, sizeof(length));
  }
}

/// The positions and 16-bit indices of a box of the sides 1, 2 and 3.
inline std::string boxData() {
  const body::TriangleMesh box = body::testing::boxMesh(1, 2, 3);
  std::string data;
  for (const auto& point : box.points) {
    for (const double number : point) {
      const auto single = static_cast<float>(number);
      data.append(reinterpret_cast<const char*>(&single), sizeof(single));
    }
  }
  for (const auto& triangle : box.triangles) {
    for (const std::uint32_t point : triangle) {
      const auto index = static_cast<std::uint16_t>(point);
      data.append(reinterpret_cast<const char*>(&index), sizeof(index));
    }
  }
  return data;
}

/// The rest of a description whose mesh 0 is that box.
inline constexpr const char* kAccessors = R"(
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
                {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
  "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
  "buffers": [{"byteLength": 168}]})";

/// Returns that box as mesh 0 of a file with these nodes.
inline std::string boxIn(const std::string& nodes) {
  return glb("{" + nodes + "," + kAccessors, boxData());
}

}  // namespace rotatebook::meshes::testing
