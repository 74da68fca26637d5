#include "render/device/egl_context.h"

#include <fmt/core.h>

#include "base/error.h"
#include "render/device/egl_displays.h"
#include "render/device/open_context.h"

namespace rotatebook::render {

EglContext::EglContext(const DeviceChoice& choice) {
  if (const auto missing = missingLibrary()) {
    throw MachineError(fmt::format("can't draw: EGL or OpenGL is not installed: {}\n  {}",
                                   missing->error, kInstallMesa));
  }
  const EglDisplays candidates = listDisplays();
  const ChosenDisplay chosen =
      chooseDisplay(candidates.list, choice, [&](std::size_t candidate) -> Attempt {
        open_.reset();
        CallFailure failure;
        open_ = OpenContext::open(candidates.openers[candidate], failure);
        if (open_ == nullptr) return {.failure = failure};
        return {.renderer = open_->info().renderer};
      });
  const ContextInfo& info = open_->info();
  description_ = fmt::format("{}, OpenGL {}, {}", info.renderer, info.version,
                             candidates.list.candidates[chosen.candidate].name());
  if (choice.warn && !chosen.warning.empty()) choice.warn(chosen.warning);
}

EglContext::~EglContext() = default;

}  // namespace rotatebook::render
