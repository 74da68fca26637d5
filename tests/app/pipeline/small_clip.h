// A clip that is quickly rendered, and a folder for it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/image.h"
#include "picture/looks.h"
#include "pipeline/render_clip.h"
#include "scene/scene.h"
#include "scene/small_scene.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::pipeline::testing {

using scene::testing::divergingScene;
using scene::testing::kFrames;
using scene::testing::messageOf;
using scene::testing::motionOf;

/// That of scene::testing, with a book of plain cloth, so that no pictures have to be read.
inline scene::Scene smallScene(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), "book.color=\"#2b5d8a\"");
  return scene::testing::smallScene(overrides);
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

/// PNG frames and an MP4 in `folder`.
inline RenderOptions pngAndMp4(const std::filesystem::path& folder,
                               const store::EarlierFrames& earlier = {},
                               std::optional<store::FrameRange> frames = {}) {
  return {.folder = folder,
          .outputs = outputsOf(true, {video::VideoFormat::Mp4}),
          .frames = frames,
          .earlier = earlier};
}

/// Renders `scene` into `options.folder`.
inline RenderResult render(const scene::Scene& scene, const RenderOptions& options) {
  return renderClip(scene, timeline::simulateScene(scene), options, {});
}

/// Stops a render after `frames` frames.
inline RenderResult stoppedAfter(std::int64_t frames, const scene::Scene& scene,
                                 RenderOptions options) {
  std::atomic<bool> stop = frames == 0;
  options.stop = &stop;
  const RenderListener listener{{},
                                [&](RenderProgress progress) { stop = progress.done >= frames; }};
  return renderClip(scene, timeline::simulateScene(scene), options, listener);
}

}  // namespace rotatebook::pipeline::testing
