// The surroundings that the book's parts hide from each other. Inside the room only.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "geometry/book_profile.h"

namespace rotatebook::geometry {

/// The surroundings as a point sees them.
struct Outlook {
  float skyVisibility = 1;  ///< Share of them that lights it. [0 to 1]
  /// Toward what it sees, away from what hides the rest; its length: the rest's share, less where
  /// it is hidden from two sides.
  Eigen::Vector3f away{0, 0, 0};
};

/// Hides what is below a long edge from a point. `toEdge` points to the edge, `toward` along the
/// surface at right angles to it, of unit length: 1/2 of the surroundings is hidden where the edge
/// is upright above the point.
inline void hideBelow(const Eigen::Vector3f& toEdge, const Eigen::Vector3f& toward,
                      Outlook& outlook) {
  const float hidden = 0.5F * (1 - toEdge.dot(toward) / toEdge.norm());
  outlook.skyVisibility *= 1 - hidden;
  outlook.away -= hidden * toward;
}

/// Returns what a point of the leaves' ends at the foot or the head sees between boards and spine.
/// [mm]
inline Outlook outlookOfLeafEnds(const BookDimensions& book, float x, float z) {
  const Eigen::Vector3f up(0, book.headInset, 0), across(1, 0, 0), front(0, 0, 1);
  Outlook outlook;
  hideBelow(up + (book.thickness - book.board - z) * front, front, outlook);
  hideBelow(up - (z - book.board) * front, -front, outlook);
  hideBelow(up - (x - book.board) * across, -across, outlook);
  return outlook;
}

/// Returns what a point of the fore edge sees between the boards. [mm]
inline Outlook outlookOfForeEdge(const BookDimensions& book, float x, float z,
                                 const Eigen::Vector3f& normal) {
  const Eigen::Vector3f front(-normal.z(), 0, normal.x());  // Along the surface.
  Outlook outlook;
  hideBelow({book.width - x, 0, book.thickness - book.board - z}, front, outlook);
  hideBelow({book.width - x, 0, book.board - z}, -front, outlook);
  return outlook;
}

/// Returns what a point of the case's inner side sees beside the leaves, which are thick. [mm]
inline Outlook outlookBesideLeaves(const BookDimensions& book, float x, float y) {
  const float beyondFore = x - (book.width - book.foreEdgeInset);
  const bool foot = y < book.height / 2;
  const float beyondEnd = book.headInset - (foot ? y : book.height - y);
  const Eigen::Vector3f fore(1, 0, 0), end(0, foot ? -1.0F : 1.0F, 0);
  const float r = book.edgeRadius;
  if (beyondFore > r && beyondEnd > r) return {0.75F, 0.25F * (fore + end).normalized()};
  return {0.5F, 0.5F * (beyondFore > beyondEnd ? fore : end)};
}

}  // namespace rotatebook::geometry
