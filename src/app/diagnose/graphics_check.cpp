#include "diagnose/graphics_check.h"

#include <chrono>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"
#include "diagnose/reference_picture.h"
#include "render/device/display_probe.h"
#include "system/isolated_run.h"

namespace rotatebook::diagnose {
namespace {

/// Making a context and drawing a small picture takes a second on slow machines.
constexpr std::chrono::seconds kTimeLimit{60};

render::DeviceChoice choiceOf(const render::DisplayCandidate& candidate) {
  switch (candidate.kind) {
    case render::DisplayCandidate::Kind::Surfaceless:
      return {.kind = render::DeviceChoice::Kind::Surfaceless};
    case render::DisplayCandidate::Kind::Default:
      return {.kind = render::DeviceChoice::Kind::Default};
    case render::DisplayCandidate::Kind::Device:
      break;
  }
  return {.kind = render::DeviceChoice::Kind::Index, .number = candidate.index};
}

/// Returns the message of `error` without its advice to run the doctor.
std::string failureText(const Error& error) {
  std::string text = error.what();
  if (text.ends_with(render::kDoctorHint))
    text.resize(text.size() - std::strlen(render::kDoctorHint));
  return text;
}

ReferenceCheck checkReference(const DisplayCheck& check, const render::BookTextures& textures) {
  ReferenceCheck reference;
  reference.tolerance = check.software ? kSoftwareTolerance : kHardwareTolerance;
  try {
    const image::Image picture = drawReferencePicture(textures, choiceOf(check.candidate));
    reference.comparison =
        compare(storedReferencePicture().view(), picture.view(), reference.tolerance);
  } catch (const Error& error) {
    reference.failure = failureText(error);
  }
  return reference;
}

DisplayCheck checkDisplay(const render::DisplayProbe& probe, std::size_t index,
                          const render::BookTextures& textures) {
  const render::DisplayCandidate& candidate = probe.list().candidates[index];
  DisplayCheck check{.candidate = candidate};
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
  check.software = candidate.software || render::isSoftwareRenderer(check.renderer);
  check.reference = checkReference(check, textures);
  return check;
}

/// Checks each display in a copy of this process; returns how each copy failed, or empty.
std::vector<std::string> tryAll(const render::DisplayProbe& probe,
                                const render::BookTextures& textures) {
  std::vector<std::string> ends;
  for (std::size_t i = 0; i < probe.list().candidates.size(); ++i) {
    const auto check = [&] { checkDisplay(probe, i, textures); };
    ends.push_back(system::runIsolated(check, kTimeLimit));
  }
  return ends;
}

}  // namespace

std::optional<std::size_t> lastTried(const std::vector<DisplayCheck>& checks,
                                     const render::DeviceChoice& choice) {
  render::DisplayCandidates list;
  for (const DisplayCheck& check : checks) list.candidates.push_back(check.candidate);
  std::optional<std::size_t> last;
  const auto attempt = [&](std::size_t i) -> render::Attempt {
    if (!checks[i].ends) return {checks[i].renderer, checks[i].failure};
    last = i;
    throw MachineError("a render would end there, too");
  };
  try {
    last = render::chooseDisplay(list, choice, attempt).candidate;
  } catch (const Error&) {
    // It refuses them all, or ended at `last`.
  }
  return last;
}

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
    const render::DisplayCandidate& candidate = probe.list().candidates[i];
    check.candidates.push_back(
        ends[i].empty() ? checkDisplay(probe, i, textures)
                        : DisplayCheck{.candidate = candidate,
                                       .failure = render::CallFailure{"its driver", ends[i]},
                                       .ends = true});
  }
  const std::optional<std::size_t> last = lastTried(check.candidates, {});
  if (last && !check.candidates[*last].ends) check.byDefault = last;
  return check;
}

}  // namespace rotatebook::diagnose
