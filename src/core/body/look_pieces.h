// Surfaces and materials of which the shapes' looks are made. Inside the room only.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "body/surface.h"

namespace rotatebook::body {

/// Returns a material from its colour as sRGB, 0xrrggbb.
Material materialOfColour(std::uint32_t colour, float metalness, float roughness,
                          const Grain& grain = {});
/// Return metals that are brushed along a body axis. (0, 1, 2: x, y, z)
Material aluminium(int axis);
Material brass(int axis);
/// Returns wood with its fibres along a body axis.
Material wood(std::uint32_t colour, int axis);

/// Returns a rectangle in the plane x y with round corners, counter-clockwise, for bevels(). [m]
std::vector<Eigen::Vector2d> roundRectangle(const Eigen::Vector2d& size, double corner);

/// A ring of a solid in layers: a height, and how far the outline has moved inward there. [m]
struct Layer {
  double z, inset;
};
/// Returns the layers of a plate around z = 0 whose edges are rounded. [m]
std::vector<Layer> roundedLayers(double height, double radius);
/// Returns a part of a plate, whose outlines are roundRectangle()s: the sides between the layers,
/// from below, and, if asked, the faces at both ends. `corner` >= every inset. [m]
TriangleMesh plateOf(const Eigen::Vector2d& size, double corner, std::span<const Layer> layers,
                     bool bottom, bool top);

/// Returns a cylinder around z with edges that are rounded by `most`, if it is long enough. [m]
TriangleMesh roundedCylinder(double radius, double height, double most);

/// Returns a surface of one material.
Surface surfaceOf(TriangleMesh mesh, const Material& material);
/// Returns a mesh moved by `place`. [m]
TriangleMesh movedBy(TriangleMesh mesh, const Eigen::Vector3d& place);

}  // namespace rotatebook::body
