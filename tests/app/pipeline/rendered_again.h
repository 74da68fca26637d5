// A clip that is rendered again and again into one folder.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/same_bytes.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline::testing {

inline constexpr store::EarlierFrames kResume{.resume = true};
inline constexpr store::EarlierFrames kOverwrite{.overwrite = true};
inline constexpr store::EarlierFrames kResumeOrOverwrite{.resume = true, .overwrite = true};

inline scene::Scene otherScene() {
  return smallScene({"body.mass=2"});
}

/// Expects the same files with the same bytes below both.
inline void expectSame(const std::filesystem::path& a, const std::filesystem::path& b) {
  ASSERT_EQ(namesIn(a), namesIn(b));
  for (const std::string& name : namesIn(a)) {
    if (std::filesystem::is_directory(a / name)) {
      expectSame(a / name, b / name);
    } else {
      EXPECT_TRUE(rotatebook::testing::sameBytes(bytesOf(a / name), bytesOf(b / name)))
          << (b / name).string();
    }
  }
}

class RenderedAgain : public ::testing::Test {
 protected:
  RenderResult render(const store::EarlierFrames& earlier,
                      const scene::Scene& scene = smallScene()) {
    return testing::render(scene, pngAndMp4(folder_, earlier));
  }
  RenderResult stop(std::int64_t frames, const store::EarlierFrames& earlier = {},
                    const scene::Scene& scene = smallScene()) {
    return stoppedAfter(frames, scene, pngAndMp4(folder_, earlier));
  }
  /// Renders a video alone.
  RenderResult renderVideo(video::VideoFormat format, const store::EarlierFrames& earlier,
                           const scene::Scene& scene) {
    return testing::render(
        scene, {.folder = folder_, .outputs = outputsOf(false, {format}), .earlier = earlier});
  }
  std::string failureOf(const store::EarlierFrames& earlier,
                        const scene::Scene& scene = smallScene()) {
    return messageOf<InputError>([&] { render(earlier, scene); });
  }
  /// Expects the files that an uninterrupted render leaves.
  void expectAsUninterrupted(RenderOptions options = pngAndMp4({}),
                             const scene::Scene& scene = smallScene()) {
    options.folder = whole_;
    testing::render(scene, options);
    expectSame(whole_, folder_);
  }

  const std::filesystem::path folder_ = emptyFolder() / "resumed";
  const std::filesystem::path whole_ = folder_.parent_path() / "whole";
};

}  // namespace rotatebook::pipeline::testing
