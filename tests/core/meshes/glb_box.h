// A box as glTF, with more than its shape, for tests.
#pragma once

#include <initializer_list>
#include <string>

#include "meshes/glb_files.h"

namespace rotatebook::meshes::testing {

/// Returns numbers as bytes.
template <typename Number>
std::string bytesOf(std::initializer_list<Number> numbers) {
  std::string bytes;
  for (const Number number : numbers)
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
  return bytes;
}

/// Returns a row of numbers as often as a box has points.
inline std::string forEachPoint(const std::string& row) {
  std::string rows;
  for (int i = 0; i < 8; ++i) rows += row;
  return rows;
}

/// A file of the box of the sides 1, 2 and 3 as mesh 0, whose parts can be added to.
struct BoxFile {
  std::string nodes = R"({"mesh": 0})";
  std::string attributes{};  ///< More of its primitive: , "NAME": ACCESSOR
  std::string primitive{};   ///< More members of these, each after a comma.
  std::string mesh{};
  std::string root{};
  std::string buffers = "{}";
  std::string accessors{}, views{}, data = boxData();
  int accessorCount = 2;

  /// Adds an accessor, such as "VEC3" of floats (5126), and returns its number.
  int add(const std::string& type, int componentType, int count, const std::string& bytes,
          const std::string& more = "") {
    accessors += ", {\"bufferView\": " + std::to_string(accessorCount) +
                 ", \"componentType\": " + std::to_string(componentType) +
                 ", \"count\": " + std::to_string(count) + ", \"type\": \"" + type + "\"" + more +
                 "}";
    views += ", {\"byteOffset\": " + std::to_string(data.size()) +
             ", \"byteLength\": " + std::to_string(bytes.size()) + "}";
    data += bytes;
    return accessorCount++;
  }

  /// Adds an attribute of the primitive.
  void addAttribute(const std::string& name, const std::string& type, int componentType,
                    const std::string& bytes, const std::string& more = "") {
    attributes += ", \"" + name + "\": " + std::to_string(add(type, componentType, 8, bytes, more));
  }

  std::string bytes() const {
    return glb(R"({"asset": {"version": "2.0"}, "nodes": [)" + nodes +
                   R"(], "scenes": [{"nodes": [0]}], "meshes": [{"primitives": [{"indices": 1,
                     "attributes": {"POSITION": 0)" +
                   attributes + "}" + primitive + "}]" + mesh + R"(}], "accessors": [
                     {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
                     {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"})" +
                   accessors + R"(], "bufferViews": [{"byteLength": 96},
                     {"byteOffset": 96, "byteLength": 72})" +
                   views + "], \"buffers\": [" + buffers + "]" + root + "}",
               data);
  }
};

}  // namespace rotatebook::meshes::testing
