// EGL's error codes by name. Inside the room only.
#pragma once

#include <string>

namespace rotatebook::render {

/// Name of the last EGL error of this thread, e.g. "EGL_NOT_INITIALIZED"; clears it.
std::string takeEglError();

}  // namespace rotatebook::render
