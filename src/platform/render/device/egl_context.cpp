#include "render/device/egl_context.h"

#include "base/error.h"
#include "render/device/egl_ways.h"
#include "render/device/open_context.h"

namespace rotatebook::render {

EglContext::EglContext(const DeviceChoice& choice) {
  if (const auto missing = missingLibrary()) {
    throw MachineError("can't draw: EGL or OpenGL is not installed: " + missing->error + "\n" +
                       kInstallMesa);
  }
  const EglWays ways = listWays();
  const ChosenWay chosen = chooseWay(ways.list, choice, [&](std::size_t way) -> Attempt {
    open_.reset();
    CallFailure failure;
    open_ = OpenContext::open(ways.openers[way], failure);
    if (open_ == nullptr) return {.failure = failure};
    return {.renderer = open_->info().renderer};
  });
  const ContextInfo& info = open_->info();
  description_ =
      info.renderer + ", OpenGL " + info.version + ", " + ways.list.ways[chosen.way].name();
  if (choice.warn && !chosen.warning.empty()) choice.warn(chosen.warning);
}

EglContext::~EglContext() = default;

}  // namespace rotatebook::render
