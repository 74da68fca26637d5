// Measurement of how fast this machine renders a scene.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "picture/device_choice.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// Wall-clock time, and processor time of all cores together; of one frame unless stated otherwise.
/// [ms]
struct WorkTime {
  double wall = 0;
  double processor = 0;

  WorkTime& operator+=(const WorkTime& other) {
    wall += other.wall;
    processor += other.processor;
    return *this;
  }
};

/// The times that each stage takes for a frame while nothing else runs.
struct StageTimes {
  WorkTime simulate;
  WorkTime book;     ///< Drawing of the books by OpenGL.
  WorkTime compose;  ///< Composing: antialiased edges, background and overlays.
  WorkTime png;
  WorkTime video;  ///< Conversion of colours, and encoding.

  double processorSum() const {
    return simulate.processor + book.processor + compose.processor + png.processor +
           video.processor;
  }
};

/// The results of measureSpeed().
struct Speed {
  std::int64_t frames = 0;
  int cores = 1;         ///< Processors that this process may use.
  double startUp = 0;    ///< From the simulated motion to the first frame's start. [s]
  WorkTime whole;        ///< A render to PNGs and MP4, after its start-up.
  WorkTime drawing;      ///< A render that keeps nothing: drawing and composing, in parallel.
  std::string renderer;  ///< render::Renderer::description()
  std::string encoder;   ///< For example "libx264".
  StageTimes stages;

  double framesPerSecond() const { return 1000 / whole.wall; }
};

/// Options of measureSpeed().
struct SpeedOptions {
  std::int64_t frames = 120;  ///< From the scene's start, >= 1; fewer if the motion diverges.
  /// Set by the caller to stop after the current frame. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called with the number of frames done; the total counts each frame three times.
  std::function<void(std::int64_t done, std::int64_t total)> progress{};
  picture::DeviceChoice device{};
  /// The scene's picture::TextureFiles, as far as they were read already.
  std::map<std::string, std::string> textures{};
};

/// Renders the first frames of `scene` three times in a temporary folder, which is removed
/// afterwards: stage by stage, without keeping anything, and to PNGs and MP4 as a render does it.
/// Returns nothing if it was stopped. Throws as simulateScene(), FrameDrawer and renderClip() do,
/// and MachineError without a temporary folder.
std::optional<Speed> measureSpeed(const scene::Scene& scene, const SpeedOptions& options);

}  // namespace rotatebook::pipeline
