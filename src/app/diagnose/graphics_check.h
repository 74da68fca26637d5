// What each way to a renderer gives, tried one by one. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "image/comparison.h"
#include "render/device/device.h"

namespace rotatebook::diagnose {

/// The test frame as a renderer drew it.
struct ReferenceCheck {
  image::Comparison comparison{};  ///< With the stored one.
  image::Tolerance tolerance{};
  std::string failure{};  ///< Why there is no frame to compare, or empty.

  bool passed() const { return failure.empty() && comparison.same; }
};

/// What trying a way gave: a context or a failure, and of a context the rest.
struct DisplayCheck {
  render::DisplayCandidate candidate{};
  std::optional<render::CallFailure> failure{};
  bool ends = false;  ///< The failure ends the process, or never comes back.
  std::string vendor{}, renderer{};
  std::string version{};  ///< Of OpenGL: "4.5"
  int samples = 0;        ///< GL_MAX_SAMPLES
  bool software = false;  ///< The device or the renderer says so.
  ReferenceCheck reference{};

  bool draws() const { return !failure && reference.passed(); }
};

struct GraphicsCheck {
  std::optional<render::CallFailure>
      library{};  ///< EGL's or OpenGL's is missing; no way was tried.
  std::optional<render::CallFailure> devices{};  ///< DisplayCandidates::failure
  std::vector<DisplayCheck> candidates{};        ///< In the order in which a render tries them.
  /// In `candidates`: what a render takes unless it is told otherwise.
  std::optional<std::size_t> byDefault{};

  /// Whether a render that isn't told otherwise draws as it should.
  bool draws() const { return byDefault && candidates[*byDefault].draws(); }
};

/// Makes a context on each way and draws the test frame with it, in a copy of this process first: a
/// driver may end it. So call it while there are no other threads. Throws nothing that a renderer
/// does.
GraphicsCheck checkGraphics();

}  // namespace rotatebook::diagnose
