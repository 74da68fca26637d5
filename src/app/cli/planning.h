// Plans of scenes, and how long their work takes. Inside the room only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "farm/chunks.h"
#include "farm/plan.h"
#include "picture/device_choice.h"
#include "scene/scene.h"
#include "video/video_format.h"

namespace rotatebook::cli {

/// A scene, and its file.
struct SceneOfFile {
  std::filesystem::path file;
  scene::Scene scene;
};

/// The wishes about a plan, beside its scenes; see Plan.
struct PlanWishes {
  farm::Work work = farm::Work::Render;
  std::filesystem::path folder{};
  int cores = 1;
  std::vector<std::string> arguments{};
  std::vector<std::string> joinArguments{};
  std::vector<video::VideoFormat> formats{};  ///< Of clips; those in `joinArguments`.
};

/// Returns a plan that isn't divided yet: each scene is one part. Throws InputError for a scene
/// that can't be simulated, or has no map.
farm::Plan planOf(const std::vector<SceneOfFile>& scenes, const PlanWishes& wishes);

/// Measures the work of the plan's scenes: a few frames or tiles of each, in about a
/// second; of many clips, a few. Throws
/// as FrameDrawer does if this machine can't draw.
std::vector<farm::Effort> measureEfforts(const farm::Plan& plan,
                                         const std::vector<SceneOfFile>& scenes,
                                         const picture::DeviceChoice& device);
/// Returns them without measuring, for parts of a given number of frames or tiles.
std::vector<farm::Effort> unmeasuredEfforts(const farm::Plan& plan);

}  // namespace rotatebook::cli
