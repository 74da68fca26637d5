// Opens a candidate's display and creates an OpenGL context on it. Inside the room only.
#pragma once

#include <memory>
#include <string>

#include <epoxy/egl.h>

#include "render/device/context_info.h"
#include "render/device/egl_displays.h"

namespace rotatebook::render {

/// A core OpenGL 3.3+ context, current on the thread that created it; destroy it there.
class OpenContext {
 public:
  /// Opens a candidate. Returns null, and the reason in `failure`, if that fails.
  static std::unique_ptr<OpenContext> open(const Opener& opener, CallFailure& failure);
  OpenContext(const OpenContext&) = delete;
  OpenContext& operator=(const OpenContext&) = delete;
  ~OpenContext();

  const ContextInfo& info() const { return info_; }

 private:
  OpenContext(EGLDisplay display, EGLContext context);

  EGLDisplay display_;
  EGLContext context_;
  ContextInfo info_;
};

}  // namespace rotatebook::render
