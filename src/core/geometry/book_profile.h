// The cross-section of the book's case: boards and spine. Inside the room only.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "base/elementary.h"

namespace rotatebook::geometry {

/// Dimensions of the book that the mesh models, in the proportions of body::Cuboid's default. x
/// runs from the spine to the fore edge, y from foot to head, z from back to front. [mm]
struct BookDimensions {
  float width = 187.8F, height = 290.85F, thickness = 50;
  float board = 3;                            ///< Thickness of boards and spine.
  float edgeRadius = 0.8F;                    ///< Radius of the rounding where sides meet.
  float hinge = 7.6F;                         ///< Distance of the groove's middle from the spine.
  float foreEdgeInset = 3.5F, headInset = 4;  ///< Overlap of boards over leaves.
};

/// The number of pieces that the cross-section's parts are divided into.
struct ProfileSteps {
  int hinge = 8;
  int arc = 3;  ///< The fore edge's rounding, and the shoulder.
  int spine = 10;
  int board = 5;
};

/// A point of the cross-section, as x and z. [mm]
struct ProfilePoint {
  Eigen::Vector2f outside{0, 0};  ///< On the cover's outer side.
  Eigen::Vector2f inside{0, 0};   ///< Opposite it on the inner side.
  Eigen::Vector2f normal{0, 0};   ///< Outward, of unit length.
  float skyVisibility = 1;  ///< Share of the surroundings visible from the outer side. [0 to 1]
  bool sharp = false;       ///< True where the outer and inner side meet unrounded.
};

/// Return the sine and the cosine. [rad]
inline float sineOf(float angle) {
  return static_cast<float>(sine(angle));
}
inline float cosineOf(float angle) {
  return static_cast<float>(cosine(angle));
}

/// Returns the outer side from the front board's fore edge over the hinge to where the spine
/// begins.
std::vector<ProfilePoint> frontProfile(const BookDimensions& book, const ProfileSteps& steps = {});
/// Returns the rounded spine, from the front to the back.
std::vector<ProfilePoint> spineProfile(const BookDimensions& book, const ProfileSteps& steps = {});
/// Returns frontProfile() mirrored, from the spine to the back board's fore edge.
std::vector<ProfilePoint> backProfile(const BookDimensions& book, const ProfileSteps& steps = {});

}  // namespace rotatebook::geometry
