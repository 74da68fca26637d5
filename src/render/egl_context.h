// An OpenGL context without a window or a display.
#pragma once

#include <string>

namespace rotatebook::render {

/// A core OpenGL 3.3+ context through EGL, current on the thread that made it until it is destroyed
/// there; other threads may have others. Tries every EGL device, then Mesa's surfaceless platform,
/// then the default display.
class EglContext {
 public:
  /// Throws MachineError with what each way said and what to install.
  EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext();

  /// What draws, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5, EGL device 0".
  const std::string& description() const { return description_; }

 private:
  // EGLDisplay and EGLContext are pointers; their header stays out of this one.
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::string description_;
};

}  // namespace rotatebook::render
