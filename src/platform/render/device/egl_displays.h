// Lists the display candidates that EGL offers. Inside the room only.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <epoxy/egl.h>

#include "render/device/device.h"

namespace rotatebook::render {

/// A function that opens a candidate.
struct Opener {
  const char* call;  ///< EGL's function that it calls, for messages.
  std::function<EGLDisplay()> open;
};

/// The candidates, with the means to open them.
struct EglDisplays {
  DisplayCandidates list;
  std::vector<Opener> openers;  ///< One per candidate of the list.
};

/// Lists every EGL device, then Mesa's surfaceless platform, then the default display.
EglDisplays listDisplays();

}  // namespace rotatebook::render
