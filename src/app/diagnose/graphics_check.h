// A check of each display candidate: context, renderer and a picture. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "image/comparison.h"
#include "render/device/device.h"

namespace rotatebook::diagnose {

/// The reference picture as a renderer drew it.
struct ReferenceCheck {
  image::Comparison comparison{};  ///< With the stored picture.
  image::Tolerance tolerance{};
  std::string failure{};  ///< Why there is no picture to compare, or empty.

  bool passed() const { return failure.empty() && comparison.same; }
};

/// The result of trying a display candidate: a failure, or a context with the fields after `ends`.
struct DisplayCheck {
  render::DisplayCandidate candidate{};
  std::optional<render::CallFailure> failure{};
  bool ends = false;  ///< The driver ends the process, or never returns.
  std::string vendor{}, renderer{};
  std::string version{};  ///< OpenGL's, for example "4.5".
  int samples = 0;        ///< GL_MAX_SAMPLES
  bool software = false;  ///< The device or the renderer says so.
  ReferenceCheck reference{};

  bool draws() const { return !failure && reference.passed(); }
};

/// The results of checkGraphics().
struct GraphicsCheck {
  /// EGL's or OpenGL's library is missing; no candidate was tried.
  std::optional<render::CallFailure> library{};
  std::optional<render::CallFailure> devices{};  ///< DisplayCandidates::failure
  std::vector<DisplayCheck> candidates{};        ///< In the order in which a render tries them.
  /// Index in `candidates` of the one that a render uses by default.
  std::optional<std::size_t> byDefault{};

  /// Returns whether a render with the default device draws correctly.
  bool draws() const { return byDefault && candidates[*byDefault].draws(); }
};

/// Returns the index of the last candidate that a render with `choice` tries: the one that it draws
/// with, or whose driver ends it. Returns nothing if each fails, or the choice allows none.
std::optional<std::size_t> lastTried(const std::vector<DisplayCheck>& checks,
                                     const render::DeviceChoice& choice);

/// Makes a context on each display candidate and draws the reference picture with it, in a copy of
/// this process first, because a driver may end the process. So call it while there are no other
/// threads. Reports a renderer's errors in the result, and doesn't throw them.
GraphicsCheck checkGraphics();

}  // namespace rotatebook::diagnose
