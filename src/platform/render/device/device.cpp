#include "render/device/device.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::render {
namespace {

/// Returns whether `choice` allows trying `candidate`. Only a device reports in advance that it is
/// software.
bool isAllowed(const DisplayCandidate& candidate, const DeviceChoice& choice) {
  switch (choice.kind) {
    case DeviceChoice::Kind::Index:
      return candidate.kind == DisplayCandidate::Kind::Device && candidate.index == choice.number;
    case DeviceChoice::Kind::Cuda:
      return candidate.cudaId == choice.number;
    case DeviceChoice::Kind::Software:
      return !candidate.isHardware();
    case DeviceChoice::Kind::Surfaceless:
      return candidate.kind == DisplayCandidate::Kind::Surfaceless;
    case DeviceChoice::Kind::Default:
      return candidate.kind == DisplayCandidate::Kind::Default;
    case DeviceChoice::Kind::Any:
      break;
  }
  return true;
}

std::string textOf(const DeviceChoice& choice) {
  switch (choice.kind) {
    case DeviceChoice::Kind::Index:
      return fmt::format("EGL device {}", choice.number);
    case DeviceChoice::Kind::Cuda:
      return fmt::format("EGL device with the CUDA id {}", choice.number);
    case DeviceChoice::Kind::Software:
      return "software renderer";
    default:
      return "EGL display";
  }
}

std::string devicesText(const DisplayCandidates& list) {
  std::string text = list.hasDevices() ? "\n  There are:" : "\n  There is no EGL device";
  for (const DisplayCandidate& candidate : list.candidates) {
    if (candidate.kind == DisplayCandidate::Kind::Device) text += "\n  " + candidate.text();
  }
  return text;
}

std::string devicesFailure(const DisplayCandidates& list) {
  if (list.failure) return "\n  EGL devices: " + list.failure->text();
  return list.hasDevices() ? "" : "\n  EGL devices: none";
}

[[noreturn]] void refuseMissing(const DisplayCandidates& list, const DeviceChoice& choice) {
  const std::string message = "can't draw: there is no " + textOf(choice);
  if (list.hasDevices()) throw InputError(message + devicesText(list));
  throw MachineError(message + ":" + devicesFailure(list) + kDoctorHint, ErrorKind::Transient);
}

/// `rejections`: a line for each candidate that was tried.
[[noreturn]] void refuseAll(const DisplayCandidates& list, const DeviceChoice& choice,
                            const std::string& rejections) {
  std::string message = fmt::format("can't draw: no {} {}:", textOf(choice),
                                    choice.requireHardware ? "draws in hardware, which is required"
                                                           : "gives an OpenGL 3.3 core context");
  if (choice.kind == DeviceChoice::Kind::Any) message += devicesFailure(list);
  message += rejections;
  const bool isOneDevice =
      choice.kind == DeviceChoice::Kind::Index || choice.kind == DeviceChoice::Kind::Cuda;
  if (isOneDevice)
    message += devicesText(list);
  else if (!choice.requireHardware)
    message += std::string(kNextLine) + kInstallMesa;
  throw MachineError(message + kDoctorHint, ErrorKind::Transient);
}

std::string fallbackWarning(const std::string& renderer, const DisplayCandidates& list,
                            const std::string& hardwareFailure) {
  std::string reason = hardwareFailure;
  if (reason.empty() && !list.unlistedCard.empty())
    reason = "EGL doesn't list " + list.unlistedCard;
  if (reason.empty()) return "";
  return fmt::format(
      "software draws ({}) in place of hardware: {}; run 'rotatebook doctor' for the remedy",
      renderer, reason);
}

/// Tries candidates one after the other and keeps the reasons why they were rejected.
class DisplaySelection {
 public:
  DisplaySelection(const DisplayCandidates& list, const DeviceChoice& choice)
      : list_(list), choice_(choice) {}

  /// Tries `candidate` with attempt() and returns whether it satisfies the choice.
  bool accepts(const DisplayCandidate& candidate, const std::function<Attempt()>& attempt) {
    if (choice_.requireHardware && candidate.software) return reject(candidate, "software");
    const Attempt tried = attempt();
    if (tried.failure) {
      if (candidate.isHardware() && hardwareFailure_.empty())
        hardwareFailure_ = fmt::format("{}: {}", candidate.text(), tried.failure->text());
      return reject(candidate, tried.failure->text());
    }
    const bool software = candidate.software || isSoftwareRenderer(tried.renderer);
    if (choice_.requireHardware && software)
      return reject(candidate, tried.renderer + ", software");
    if (choice_.kind == DeviceChoice::Kind::Software && !software) {
      return reject(candidate, tried.renderer + ", hardware");
    }
    if (software && choice_.kind == DeviceChoice::Kind::Any) {
      warning_ = fallbackWarning(tried.renderer, list_, hardwareFailure_);
    }
    return true;
  }

  const std::string& rejections() const { return rejections_; }
  const std::string& warning() const { return warning_; }

 private:
  bool reject(const DisplayCandidate& candidate, const std::string& reason) {
    rejections_ += fmt::format("\n  {}: {}", candidate.text(), reason);
    return false;
  }

  const DisplayCandidates& list_;
  const DeviceChoice& choice_;
  std::string rejections_, hardwareFailure_, warning_;
};

}  // namespace

const char* const kInstallMesa =
    "Install Mesa's software rasteriser (Debian, Ubuntu: apt-get install libegl1 libegl-mesa0 "
    "libgl1-mesa-dri libopengl0), or for a graphics card its driver's EGL library, and make "
    "sure that you may read /dev/dri/renderD*.";
const char* const kDoctorHint = "\n  Run 'rotatebook doctor' for the cause and the remedy.";

std::string DisplayCandidate::name() const {
  if (kind == Kind::Device) return fmt::format("EGL device {}", index);
  return kind == Kind::Surfaceless ? "surfaceless EGL" : "default EGL display";
}

std::string DisplayCandidate::text() const {
  const std::string facts =
      joined({renderNode.empty() ? drmNode : renderNode,
              cudaId ? fmt::format("cuda:{}", *cudaId) : "", software ? "software" : ""});
  return facts.empty() ? name() : fmt::format("{} ({})", name(), facts);
}

bool DisplayCandidates::hasDevices() const {
  return std::ranges::count(candidates, DisplayCandidate::Kind::Device, &DisplayCandidate::kind) >
         0;
}

ChosenDisplay chooseDisplay(const DisplayCandidates& list, const DeviceChoice& choice,
                            const std::function<Attempt(std::size_t candidate)>& attempt) {
  DisplaySelection selection(list, choice);
  bool anyAllowed = false;
  for (std::size_t i = 0; i < list.candidates.size(); ++i) {
    if (!isAllowed(list.candidates[i], choice)) continue;
    anyAllowed = true;
    if (selection.accepts(list.candidates[i], [&] { return attempt(i); })) {
      return {i, selection.warning()};
    }
  }
  if (!anyAllowed) refuseMissing(list, choice);
  refuseAll(list, choice, selection.rejections());
}

bool isSoftwareRenderer(std::string_view renderer) {
  constexpr std::array<std::string_view, 5> kNames{"llvmpipe", "softpipe", "swrast",
                                                   "software rasterizer", "swiftshader"};
  const std::string lower = lowerCase(renderer);
  return std::ranges::any_of(
      kNames, [&](std::string_view name) { return lower.find(name) != std::string::npos; });
}

}  // namespace rotatebook::render
