#include "render/device/display_probe.h"

#include "render/device/egl_ways.h"
#include "render/device/open_context.h"

namespace rotatebook::render {

struct DisplayProbe::Ways : EglWays {};

DisplayProbe::DisplayProbe() : ways_(std::make_unique<Ways>(Ways{listWays()})) {}
DisplayProbe::~DisplayProbe() = default;

const WayList& DisplayProbe::list() const {
  return ways_->list;
}

std::optional<ContextInfo> DisplayProbe::open(std::size_t index, CallFailure& failure) const {
  const auto context = OpenContext::open(ways_->openers[index], failure);
  if (context == nullptr) return {};
  return context->info();
}

}  // namespace rotatebook::render
