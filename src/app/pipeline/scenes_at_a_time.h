// The number of scenes that a machine can render at the same time.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace rotatebook::pipeline {

/// Returns how many of `scenes` to render at a time, at least 1: one for every three of `cores`,
/// but two for as few as two, as many as fit in a quarter of `memory`. [bytes]
int scenesAtATime(const std::vector<scene::Scene>& scenes, int cores, double memory);

}  // namespace rotatebook::pipeline
