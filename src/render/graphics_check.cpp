#include "render/graphics_check.h"

#include <chrono>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/trial.h"
#include "render/egl_ways.h"
#include "render/open_context.h"
#include "render/test_frame.h"

namespace rotatebook::render {
namespace {

/// Making a context and drawing a small picture takes a second on slow machines.
constexpr std::chrono::seconds kLongestTrial{60};

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

/// What `error` says to one who asks the doctor already.
std::string failureText(const Error& error) {
  std::string text = error.what();
  if (text.ends_with(kAskDoctor)) text.resize(text.size() - std::strlen(kAskDoctor));
  return text;
}

FrameCheck checkFrame(const WayCheck& check, const BookTextures& textures) {
  FrameCheck frame;
  frame.tolerance = check.software ? kSoftwareTolerance : kHardwareTolerance;
  try {
    const image::Image picture = drawTestFrame(textures, choiceOf(check.way));
    frame.comparison = compare(storedTestFrame().view(), picture.view(), frame.tolerance);
  } catch (const Error& error) {
    frame.failure = failureText(error);
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

/// How checking each way ends the process, or empty.
std::vector<std::string> tryAll(const EglWays& ways, const BookTextures& textures) {
  std::vector<std::string> ends;
  for (std::size_t i = 0; i < ways.openers.size(); ++i) {
    const auto check = [&] { checkWay(ways.list.ways[i], ways.openers[i], textures); };
    ends.push_back(endOfTrial(check, kLongestTrial));
  }
  return ends;
}

std::optional<std::size_t> defaultOf(const WayList& list, const std::vector<WayCheck>& checks) {
  try {
    return chooseWay(list, {},
                     [&](std::size_t i) -> Attempt {
                       if (checks[i].ends) throw MachineError("a render would end there, too");
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
  const std::vector<std::string> ends = tryAll(ways, textures);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Way& way = ways.list.ways[i];
    check.ways.push_back(
        ends[i].empty()
            ? checkWay(way, ways.openers[i], textures)
            : WayCheck{.way = way, .failure = CallFailure{"its driver", ends[i]}, .ends = true});
  }
  check.byDefault = defaultOf(ways.list, check.ways);
  return check;
}

}  // namespace rotatebook::render
