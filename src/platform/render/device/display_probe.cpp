#include "render/device/display_probe.h"

#include "render/device/egl_displays.h"
#include "render/device/open_context.h"

namespace rotatebook::render {

struct DisplayProbe::Candidates : EglDisplays {};

DisplayProbe::DisplayProbe()
    : candidates_(std::make_unique<Candidates>(Candidates{listDisplays()})) {}
DisplayProbe::~DisplayProbe() = default;

const DisplayCandidates& DisplayProbe::list() const {
  return candidates_->list;
}

std::optional<ContextInfo> DisplayProbe::open(std::size_t index, CallFailure& failure) const {
  const auto context = OpenContext::open(candidates_->openers[index], failure);
  if (context == nullptr) return {};
  return context->info();
}

}  // namespace rotatebook::render
