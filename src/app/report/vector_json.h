// Vectors as JSON. Inside the room only.
#pragma once

#include <array>
#include <string>

#include <Eigen/Core>

#include "base/json.h"
#include "base/number_text.h"

namespace rotatebook::report {

/// Returns "[x, y, z]", whose numbers read back as what they are.
inline std::string vectorJson(const Eigen::Vector3d& vector) {
  return jsonArrayOf(std::array{vector.x(), vector.y(), vector.z()}, shortestText);
}

}  // namespace rotatebook::report
