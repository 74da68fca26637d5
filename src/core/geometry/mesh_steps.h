// Numbers of parts that the book's mesh is divided into. Inside the room only.
#pragma once

#include <vector>

#include "geometry/book_profile.h"

namespace rotatebook::geometry {

/// The number of pieces that the book's parts are divided into.
struct MeshSteps {
  ProfileSteps profile{};
  int rounding = 3;  ///< Of the sides at foot and head.
  int flat = 4;      ///< Of the sides from foot to head.
  /// Grid lines across the page block, as shares of its thickness; the boards hide light from it.
  std::vector<float> acrossLeaves{0.0F, 0.04F, 0.12F, 0.3F, 0.5F, 0.7F, 0.88F, 0.96F, 1.0F};
  std::vector<float> alongForeEdge{0.0F, 0.25F, 0.5F, 0.75F, 1.0F};
  std::vector<float> alongEnds{0.0F, 0.012F, 0.05F, 0.35F, 0.7F, 1.0F};
};

/// Returns steps with which a book some fifty pixels high looks the same.
inline MeshSteps stepsOfSmallBook() {
  return {.profile = {.hinge = 2, .arc = 1, .spine = 4, .board = 2},
          .rounding = 1,
          .flat = 2,
          .acrossLeaves = {0.0F, 0.08F, 0.5F, 0.92F, 1.0F},
          .alongForeEdge = {0.0F, 0.5F, 1.0F},
          .alongEnds = {0.0F, 0.05F, 1.0F}};
}

}  // namespace rotatebook::geometry
