#include "render/graphics_check.h"

#include "base/error.h"
#include "render/egl_ways.h"
#include "render/open_context.h"
#include "render/test_frame.h"

namespace rotatebook::render {
namespace {

DeviceChoice choiceOf(const Way& way) {
  switch (way.kind) {
    case Way::Kind::Surfaceless:
      return {.kind = DeviceChoice::Kind::Surfaceless};
    case Way::Kind::Default:
      return {.kind = DeviceChoice::Kind::Default};
    case Way::Kind::Device:
      break;
  }
  return {.kind = DeviceChoice::Kind::Index, .number = way.index};
}

FrameCheck checkFrame(const WayCheck& check, const BookTextures& textures) {
  FrameCheck frame;
  frame.tolerance = check.software ? kSoftwareTolerance : kHardwareTolerance;
  try {
    const image::Image picture = drawTestFrame(textures, choiceOf(check.way));
    frame.comparison = compare(storedTestFrame().view(), picture.view(), frame.tolerance);
  } catch (const Error& error) {
    frame.failure = error.what();
  }
  return frame;
}

WayCheck checkWay(const Way& way, const Opener& opener, const BookTextures& textures) {
  WayCheck check{.way = way};
  {
    CallFailure failure;
    const auto context = OpenContext::open(opener, failure);
    if (context == nullptr) {
      check.failure = failure;
      return check;
    }
    const ContextInfo& info = context->info();
    check.vendor = info.vendor;
    check.renderer = info.renderer;
    check.version = info.version;
    check.samples = info.samples;
  }
  check.software = way.software || isSoftwareRenderer(check.renderer);
  check.frame = checkFrame(check, textures);
  return check;
}

std::optional<std::size_t> defaultOf(const WayList& list, const std::vector<WayCheck>& checks) {
  try {
    return chooseWay(list, {},
                     [&](std::size_t i) -> Attempt {
                       return {checks[i].renderer, checks[i].failure};
                     })
        .way;
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

GraphicsCheck checkGraphics() {
  GraphicsCheck check;
  check.library = missingLibrary();
  if (check.library) return check;
  const EglWays ways = listWays();
  check.devices = ways.list.failure;
  const BookTextures textures{builtinFront(), builtinSpine(), builtinBack()};
  for (std::size_t i = 0; i < ways.openers.size(); ++i) {
    check.ways.push_back(checkWay(ways.list.ways[i], ways.openers[i], textures));
  }
  check.byDefault = defaultOf(ways.list, check.ways);
  return check;
}

}  // namespace rotatebook::render
