#include "diagnose/graphics_check.h"

#include <chrono>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"
#include "diagnose/test_frame.h"
#include "render/device/display_probe.h"
#include "system/trial.h"

namespace rotatebook::diagnose {
namespace {

/// Making a context and drawing a small picture takes a second on slow machines.
constexpr std::chrono::seconds kLongestTrial{60};

render::DeviceChoice choiceOf(const render::Way& way) {
  switch (way.kind) {
    case render::Way::Kind::Surfaceless:
      return {.kind = render::DeviceChoice::Kind::Surfaceless};
    case render::Way::Kind::Default:
      return {.kind = render::DeviceChoice::Kind::Default};
    case render::Way::Kind::Device:
      break;
  }
  return {.kind = render::DeviceChoice::Kind::Index, .number = way.index};
}

/// What `error` says to one who asks the doctor already.
std::string failureText(const Error& error) {
  std::string text = error.what();
  if (text.ends_with(render::kAskDoctor))
    text.resize(text.size() - std::strlen(render::kAskDoctor));
  return text;
}

FrameCheck checkFrame(const WayCheck& check, const render::BookTextures& textures) {
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

WayCheck checkWay(const render::DisplayProbe& probe, std::size_t index,
                  const render::BookTextures& textures) {
  const render::Way& way = probe.list().ways[index];
  WayCheck check{.way = way};
  render::CallFailure failure;
  const auto info = probe.open(index, failure);
  if (!info) {
    check.failure = failure;
    return check;
  }
  check.vendor = info->vendor;
  check.renderer = info->renderer;
  check.version = info->version;
  check.samples = info->samples;
  check.software = way.software || render::isSoftwareRenderer(check.renderer);
  check.frame = checkFrame(check, textures);
  return check;
}

/// How checking each way ends the process, or empty.
std::vector<std::string> tryAll(const render::DisplayProbe& probe,
                                const render::BookTextures& textures) {
  std::vector<std::string> ends;
  for (std::size_t i = 0; i < probe.list().ways.size(); ++i) {
    const auto check = [&] { checkWay(probe, i, textures); };
    ends.push_back(system::endOfTrial(check, kLongestTrial));
  }
  return ends;
}

std::optional<std::size_t> defaultOf(const render::WayList& list,
                                     const std::vector<WayCheck>& checks) {
  try {
    return render::chooseWay(list, {},
                             [&](std::size_t i) -> render::Attempt {
                               if (checks[i].ends)
                                 throw MachineError("a render would end there, too");
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
  check.library = render::missingLibrary();
  if (check.library) return check;
  const render::DisplayProbe probe;
  check.devices = probe.list().failure;
  const render::BookTextures textures{render::builtinFront(), render::builtinSpine(),
                                      render::builtinBack()};
  const std::vector<std::string> ends = tryAll(probe, textures);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const render::Way& way = probe.list().ways[i];
    check.ways.push_back(ends[i].empty()
                             ? checkWay(probe, i, textures)
                             : WayCheck{.way = way,
                                        .failure = render::CallFailure{"its driver", ends[i]},
                                        .ends = true});
  }
  check.byDefault = defaultOf(probe.list(), check.ways);
  return check;
}

}  // namespace rotatebook::diagnose
