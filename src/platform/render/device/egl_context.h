// An OpenGL context without a window. Inside the room only.
#pragma once

#include <memory>
#include <string>

#include "render/device/device.h"

namespace rotatebook::render {

class OpenContext;

/// A core OpenGL 3.3+ context through EGL, current on the thread that created it; destroy it there.
/// Other threads may have other contexts. Tries every EGL device, then Mesa's surfaceless platform,
/// then the default display, as far as the choice allows.
class EglContext {
 public:
  /// Throws what chooseDisplay() throws, and MachineError if EGL or OpenGL isn't installed.
  explicit EglContext(const DeviceChoice& choice = {});
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext();

  /// Describes what draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5, EGL device 0".
  const std::string& description() const { return description_; }

 private:
  std::unique_ptr<OpenContext> open_;  // Behind a pointer, to keep EGL's header out of this one.
  std::string description_;
};

}  // namespace rotatebook::render
