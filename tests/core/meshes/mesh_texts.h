// Meshes as OBJ, STL and PLY, for tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "body/triangle_mesh.h"

namespace rotatebook::meshes::testing {

template <typename Number>
void appendBytes(std::string& bytes, Number number, bool isBigEndian = false) {
  char all[sizeof(Number)];
  std::memcpy(all, &number, sizeof(Number));
  if (isBigEndian) std::reverse(all, all + sizeof(Number));
  bytes.append(all, sizeof(Number));
}

inline std::string numberText(double number) {
  return std::to_string(number) + ' ';
}

inline std::string objOf(const body::TriangleMesh& mesh) {
  std::string obj = "# a comment\r\no body\n";
  for (const auto& p : mesh.points)
    obj += "v " + numberText(p.x()) + numberText(p.y()) + numberText(p.z()) + '\n';
  for (const auto& [a, b, c] : mesh.triangles) {
    obj += "f " + std::to_string(a + 1) + "/1/1 " + std::to_string(b + 1) + "//2\t" +
           std::to_string(c + 1) + '\n';
  }
  return obj;
}

inline std::string textStlOf(const body::TriangleMesh& mesh) {
  std::string stl = "solid a name\n";
  for (const auto& triangle : mesh.triangles) {
    stl += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::uint32_t point : triangle) {
      const auto& p = mesh.points[point];
      stl += "      vertex " + numberText(p.x()) + numberText(p.y()) + numberText(p.z()) + '\n';
    }
    stl += "    endloop\n  endfacet\n";
  }
  return stl + "endsolid a name\n";
}

inline std::string binaryStlOf(const body::TriangleMesh& mesh,
                               const std::string& comment = "solid, it says") {
  std::string stl = comment;
  stl.resize(80, ' ');
  appendBytes(stl, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) appendBytes(stl, 0.0F);
    for (const std::uint32_t point : triangle)
      for (const double number : mesh.points[point]) appendBytes(stl, static_cast<float>(number));
    appendBytes(stl, std::uint16_t{0});
  }
  return stl;
}

inline std::string plyHeader(const body::TriangleMesh& mesh, const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment none\nelement vertex " +
         std::to_string(mesh.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
         "element face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string textPlyOf(const body::TriangleMesh& mesh) {
  std::string ply = plyHeader(mesh, "ascii");
  for (const auto& p : mesh.points)
    ply += numberText(p.x()) + numberText(p.y()) + numberText(p.z()) + "255\n";
  for (const auto& [a, b, c] : mesh.triangles)
    ply += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  return ply;
}

inline std::string binaryPlyOf(const body::TriangleMesh& mesh, bool isBigEndian) {
  std::string ply = plyHeader(mesh, isBigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const auto& point : mesh.points) {
    for (const double number : point) appendBytes(ply, number, isBigEndian);
    appendBytes(ply, std::uint8_t{255});
  }
  for (const auto& triangle : mesh.triangles) {
    appendBytes(ply, std::uint8_t{3});
    for (const std::uint32_t point : triangle)
      appendBytes(ply, static_cast<std::int32_t>(point), isBigEndian);
  }
  return ply;
}

/// Returns the text with another in place of each `from`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace rotatebook::meshes::testing
