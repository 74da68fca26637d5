// Numbers of what is drawn to say why a body turns over.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "physics/sample.h"
#include "scene/reference_frame.h"
#include "scene/scene.h"

namespace rotatebook::timeline {

/// Returns the moments of inertia of a motion's model, about its principal axes. [kg m^2]
Eigen::Vector3d momentsOf(const scene::Panel& panel);

/// Returns the place of a sample on the ladder of energies, and the ladder: the numbers that
/// rb_ladder() of bridge.h describes.
std::vector<double> ladderNumbers(const scene::Panel& panel, const physics::Sample& sample);

/// Returns Poinsot's construction at the sample `index`, seen in `frame`, with the paths of its
/// contact in up to `trail` samples before: the numbers that rb_poinsot() of bridge.h describes;
/// none if there is no plane that the body rolls on.
std::vector<double> poinsotNumbers(const scene::Panel& panel,
                                   const std::vector<physics::Sample>& samples, std::size_t index,
                                   const scene::MotionFrame& frame, std::size_t trail);

}  // namespace rotatebook::timeline
