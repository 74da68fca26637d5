// Numbers of what is drawn to say why a body turns over, see bridge.h. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/json.h"
#include "bridge/played_scene.h"
#include "scene/body_forces.h"

namespace rotatebook::bridge {

/// The forces on a motion's masses, and the largest so far, to which all are drawn.
class PlayedForces {
 public:
  PlayedForces(const PlayedScene& played, std::size_t motion);

  /// Returns the numbers of rb_forces().
  std::vector<double> at(const PlayedScene& played, std::int64_t frame);

 private:
  std::size_t motion_;
  scene::BodyForces forces_;
  std::size_t seen_ = 0;            ///< Samples that `largest_` is of.
  double largest_ = 0, limit_ = 0;  ///< [N/kg]
};

/// Returns the numbers of rb_ladder().
std::vector<double> ladderNumbers(const PlayedScene& played, std::size_t motion,
                                  std::int64_t frame);
/// Returns the numbers of rb_poinsot().
std::vector<double> poinsotNumbers(const PlayedScene& played, std::size_t motion,
                                   std::int64_t frame, std::int64_t trail);
/// Returns the JSON of rb_spin().
Json spinJson(const scene::Motion& motion);

}  // namespace rotatebook::bridge
