// A body's surface as it looks.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// The most triangles of a surface that is drawn.
inline constexpr std::size_t kMaxDrawnTriangles = 200'000;

/// No picture.
inline constexpr int kNoImage = -1;

/// Streaks, fibres or grains that vary a surface's colour and height.
struct Grain {
  Eigen::Vector3d size{0, 0, 0};  ///< Along the body's axes, > 0. [m]
  float contrast = 0;             ///< Of the colour, from grain to grain; 0 for no grain. [0 to 1]
  float relief = 0;               ///< Of the height. [m]
  friend bool operator==(const Grain&, const Grain&) = default;
};

/// Returns the number of grains along each edge of a box of that size [m]; 0 of no grain.
Eigen::Vector3d grainsAcross(const Grain& grain, const Eigen::Vector3d& size);

/// Continuation of a picture beyond its edges, along one axis.
enum class Wrap { Repeat, Mirror, Clamp };

/// Ways to read a picture beyond its edges and between its pixels.
struct Sampling {
  Wrap across = Wrap::Repeat;
  Wrap down = Wrap::Repeat;
  bool hasSquares = false;  ///< Enlarged, its pixels are squares, and aren't mixed.
  auto operator<=>(const Sampling&) const = default;
};

/// A material of the metallic-roughness model of glTF 2.0.
struct Material {
  Eigen::Vector3f baseColour{0.55F, 0.55F, 0.55F};  ///< Linear. [0 to 1]
  float metalness = 0;                              ///< [0 to 1]
  float roughness = 0.5F;                           ///< [0 to 1]
  int baseColourImage = kNoImage;      ///< Index of Surface::images; it multiplies baseColour.
  int metalRoughnessImage = kNoImage;  ///< Likewise; green multiplies roughness, blue metalness.
  Grain grain{};
  friend bool operator==(const Material&, const Material&) = default;
};

/// A surface with its materials.
struct Surface {
  TriangleMesh mesh;                        ///< [m], or the unit of its file.
  std::vector<Material> materials{{}};      ///< One or more.
  std::vector<std::uint32_t> materialOf{};  ///< By triangle; empty if all have the first material.
  /// By triangle and corner, v down as in glTF; empty if no material has a picture.
  std::vector<std::array<Eigen::Vector2f, 3>> texCoords{};
  std::vector<std::string> images{};  ///< The bytes of PNG, JPEG or WebP files.
  std::vector<Sampling> samplings{};  ///< One for each of `images`.
};

/// Adds the triangles of another surface, with its materials. No surface has pictures.
void addSurface(const Surface& added, Surface& into);

}  // namespace rotatebook::body
