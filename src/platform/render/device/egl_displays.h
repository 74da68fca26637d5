// The candidates to a display that EGL offers. Inside the room only.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <epoxy/egl.h>

#include "render/device/device.h"

namespace rotatebook::render {

/// How a candidate is opened.
struct Opener {
  const char* call;  ///< The function of EGL's that does it, for messages.
  std::function<EGLDisplay()> open;
};

struct EglDisplays {
  DisplayCandidates list;
  std::vector<Opener> openers;  ///< One for each of the list's candidates.
};

/// Every EGL device, then Mesa's surfaceless platform, then the default display.
EglDisplays listDisplays();

}  // namespace rotatebook::render
