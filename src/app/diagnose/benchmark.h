// How fast this machine renders a scene, measured.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "render/device/device.h"
#include "scene/scene.h"

namespace rotatebook::diagnose {

/// Time that passed, and time that all processors together spent on it. A frame, unless it says
/// otherwise. [ms]
struct WorkTime {
  double wall = 0;
  double processor = 0;

  WorkTime& operator+=(const WorkTime& other) {
    wall += other.wall;
    processor += other.processor;
    return *this;
  }
};

/// What each stage takes for a frame while nothing else runs.
struct StageTimes {
  WorkTime simulate;
  WorkTime book;    ///< OpenGL's part of the books.
  WorkTime finish;  ///< Their edges, the background, and what is drawn over.
  WorkTime png;
  WorkTime video;  ///< Conversion of the colours and encoding.

  double processorSum() const {
    return simulate.processor + book.processor + finish.processor + png.processor + video.processor;
  }
};

/// What measureSpeed() found.
struct Speed {
  std::int64_t frames = 0;
  int cores = 1;         ///< Processors that this process may use.
  double startUp = 0;    ///< From the simulated motion to the first frame's start. [s]
  WorkTime whole;        ///< Of a render that writes PNGs and MP4, after its start-up.
  WorkTime drawing;      ///< The same of one that keeps nothing: a frame drawn beside the next.
  std::string renderer;  ///< render::Renderer::description()
  std::string encoder;   ///< For example "libx264".
  StageTimes stages;

  double framesPerSecond() const { return 1000 / whole.wall; }
};

/// How measureSpeed() measures.
struct SpeedOptions {
  std::int64_t frames = 120;  ///< From the scene's start, >= 1; fewer if the motion diverges.
  /// Set from outside to stop after the frame in hand. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Told how many of how many frames are done; each is drawn three times.
  std::function<void(std::int64_t done, std::int64_t total)> progress{};
  render::DeviceChoice device{};
};

/// Renders the first frames of `scene` to PNGs and MP4 in a temporary folder, which is gone
/// afterwards: once stage by stage, once as a render does it, and once into nothing. Nothing if it
/// was stopped. Throws as simulateScene(), FrameDrawer and renderClip() do, and MachineError
/// without a temporary folder.
std::optional<Speed> measureSpeed(const scene::Scene& scene, const SpeedOptions& options);

}  // namespace rotatebook::diagnose
