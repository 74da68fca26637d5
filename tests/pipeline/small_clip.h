// A clip that is quickly rendered, and a folder for it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/image.h"
#include "physics/trajectory.h"
#include "pipeline/render_clip.h"
#include "pipeline/simulate_scene.h"
#include "pipeline/textures.h"
#include "scene/scene.h"
#include "scene/scene_file.h"

namespace rotatebook::pipeline::testing {

inline constexpr std::int64_t kFrames = 12;

/// Twelve frames of 64x36, named "small"; `overrides` as --set takes them.
inline scene::Scene smallScene(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "title = \"Small · clip\"\n"
      "[initial]\nangular_velocity = [5, 3, 1]\n"
      "[clip]\nsize = [64, 36]\nfps = 24\nduration = 0.5\n",
      "small.toml", overrides);
}

/// A scene whose motion blows up at frame 5 of 12. measured: diverges at 0.2083 s
inline scene::Scene divergingScene() {
  return smallScene({"simulation.model=particles", "simulation.substeps=1",
                     "simulation.normalize=false", "simulation.damping=0"});
}

inline physics::Trajectory motionOf(const scene::Scene& scene) {
  return physics::simulate(scene.motion(), scene.clip.frameCount());
}

/// An empty folder for the running test alone.
inline std::filesystem::path emptyFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(ROTATEBOOK_TEST_OUTPUT) / "pipeline" /
                      (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// The file's bytes.
inline std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Names of all that lies in `folder`, hidden or not, ascending.
inline std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Renders `scene` into `options.folder`.
inline RenderResult render(const scene::Scene& scene, const RenderOptions& options) {
  return renderClip(scene, simulateScene(scene), options, {});
}

/// Stops a render after `frames` frames.
inline RenderResult stoppedAfter(std::int64_t frames, const scene::Scene& scene,
                                 RenderOptions options) {
  std::atomic<bool> stop = frames == 0;
  options.stop = &stop;
  const RenderListener listener{{},
                                [&](RenderProgress progress) { stop = progress.done >= frames; }};
  return renderClip(scene, simulateScene(scene), options, listener);
}

/// What `action` says when it throws an `Expected`; "no error" if it doesn't throw.
template <typename Expected, typename Action>
std::string messageOf(const Action& action) {
  try {
    action();
    return "no error";
  } catch (const Expected& error) {
    return error.what();
  }
}

}  // namespace rotatebook::pipeline::testing
