// A candidate's display and an OpenGL context on it. Inside the room only.
#pragma once

#include <memory>
#include <string>

#include <epoxy/egl.h>

#include "render/device/context_info.h"
#include "render/device/egl_displays.h"

namespace rotatebook::render {

/// A core OpenGL 3.3+ context, current on the thread that made it until it is destroyed there.
class OpenContext {
 public:
  /// Null, and why in `failure`, if there is none.
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
