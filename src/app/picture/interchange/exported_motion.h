// A motion as other programs take it, whatever the format. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "picture/interchange/motion_file.h"
#include "picture/interchange/turning.h"
#include "picture/interchange/world_camera.h"
#include "scene/scene.h"

namespace rotatebook::interchange {

/// A place on a camera's way.
struct CameraKey {
  double time = 0;  ///< Of the video. [s]
  CameraPlace place;
};

/// A motion, and what its file says of it.
struct ExportedMotion {
  scene::Scene scene;                 ///< Has the motion alone.
  std::string text, panel, checksum;  ///< Of the whole scene, and of the clip's motions.
  Turning turning;
  double aspect = 1;                  ///< Of the picture, width by height.
  double fieldOfView = 0;             ///< Of the camera, from below to above. [rad]
  double nearest = 0;                 ///< Distance at which the camera begins to see. [m]
  std::vector<CameraKey> cameraKeys;  ///< One a frame if it moves, or else one.
  std::vector<std::string> notes;
};

/// Simulates the motion with this index. Throws as motionGlb() does.
ExportedMotion exportedMotion(const scene::Scene& scene, std::size_t motion,
                              const KeyOptions& options);

/// Returns the file with these bytes.
MotionFile motionFile(std::string bytes, const ExportedMotion& motion);

/// The beginning of what says which program made a file.
inline constexpr const char* kMaker = "rotatebook ";

}  // namespace rotatebook::interchange
