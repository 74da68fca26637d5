// An OpenGL context without a window or a display. Inside the room only.
#pragma once

#include <memory>
#include <string>

#include "render/device/device.h"

namespace rotatebook::render {

class OpenContext;

/// A core OpenGL 3.3+ context through EGL, current on the thread that made it until it is destroyed
/// there; other threads may have others. Tries every EGL device, then Mesa's surfaceless platform,
/// then the default display, as far as the choice allows.
class EglContext {
 public:
  /// Throws as chooseDisplay() does, and MachineError where EGL or OpenGL isn't installed.
  explicit EglContext(const DeviceChoice& choice = {});
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext();

  /// What draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5, EGL device 0".
  const std::string& description() const { return description_; }

 private:
  std::unique_ptr<OpenContext> open_;  // EGL's header stays out of this one.
  std::string description_;
};

}  // namespace rotatebook::render
