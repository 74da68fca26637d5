#include "render/device/device.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::render {
namespace {

/// Whether `choice` allows to try `candidate`. Only a device tells beforehand that it is software.
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

std::string wordsOf(const DeviceChoice& choice) {
  const std::string number = std::to_string(choice.number);
  switch (choice.kind) {
    case DeviceChoice::Kind::Index:
      return "EGL device " + number;
    case DeviceChoice::Kind::Cuda:
      return "EGL device with the CUDA id " + number;
    case DeviceChoice::Kind::Software:
      return "software renderer";
    default:
      return "EGL display";
  }
}

std::string devicesText(const DisplayCandidates& list) {
  std::string text = "\nThere ";
  text += list.hasDevices() ? "are:" : "is no EGL device";
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
  const std::string message = "can't draw: there is no " + wordsOf(choice);
  if (list.hasDevices()) throw InputError(message + devicesText(list));
  throw MachineError(message + ":" + devicesFailure(list) + kAskDoctor);
}

/// `said` is a line for each candidate that was tried.
[[noreturn]] void refuseAll(const DisplayCandidates& list, const DeviceChoice& choice,
                            const std::string& said) {
  std::string message = "can't draw: no " + wordsOf(choice);
  if (choice.requireHardware)
    message += " is hardware that draws, which is required:";
  else
    message += " gives an OpenGL 3.3 core context:";
  if (choice.kind == DeviceChoice::Kind::Any) message += devicesFailure(list);
  message += said;
  const bool one =
      choice.kind == DeviceChoice::Kind::Index || choice.kind == DeviceChoice::Kind::Cuda;
  if (one)
    message += devicesText(list);
  else if (!choice.requireHardware)
    message += std::string("\n") + kInstallMesa;
  throw MachineError(message + kAskDoctor);
}

std::string fallWarning(const std::string& renderer, const DisplayCandidates& list,
                        const std::string& hardwareFailure) {
  std::string reason = hardwareFailure;
  if (reason.empty() && !list.unlistedCard.empty())
    reason = "EGL doesn't list " + list.unlistedCard;
  if (reason.empty()) return "";
  return "software draws (" + renderer + ") in place of hardware: " + reason +
         "; 'rotatebook doctor' tells what to do";
}

/// Tries one candidate after the other and keeps what they said.
class DisplaySelection {
 public:
  DisplaySelection(const DisplayCandidates& list, const DeviceChoice& choice)
      : list_(list), choice_(choice) {}

  /// Whether `candidate` will do.
  bool takes(const DisplayCandidate& candidate, const std::function<Attempt()>& attempt) {
    if (choice_.requireHardware && candidate.software) return say(candidate, "software");
    const Attempt tried = attempt();
    if (tried.failure) {
      if (candidate.isHardware() && failed_.empty())
        failed_ = candidate.text() + ": " + tried.failure->text();
      return say(candidate, tried.failure->text());
    }
    const bool software = candidate.software || isSoftwareRenderer(tried.renderer);
    if (choice_.requireHardware && software) return say(candidate, tried.renderer + ", software");
    if (choice_.kind == DeviceChoice::Kind::Software && !software) {
      return say(candidate, tried.renderer + ", hardware");
    }
    if (software && choice_.kind == DeviceChoice::Kind::Any) {
      warning_ = fallWarning(tried.renderer, list_, failed_);
    }
    return true;
  }

  const std::string& said() const { return said_; }
  const std::string& warning() const { return warning_; }

 private:
  bool say(const DisplayCandidate& candidate, const std::string& what) {
    said_ += "\n  " + candidate.text() + ": " + what;
    return false;
  }

  const DisplayCandidates& list_;
  const DeviceChoice& choice_;
  std::string said_, failed_, warning_;
};

}  // namespace

const char* const kInstallMesa =
    "Install Mesa's software rasteriser (Debian, Ubuntu: apt-get install libegl1 libegl-mesa0 "
    "libgl1-mesa-dri libopengl0), or for a graphics card its driver's EGL library, and see that "
    "you may read "
    "/dev/dri/renderD*.";
const char* const kAskDoctor = "\nRun 'rotatebook doctor' for the cause and what to do.";

std::string DisplayCandidate::name() const {
  if (kind == Kind::Device) return "EGL device " + std::to_string(index);
  return kind == Kind::Surfaceless ? "surfaceless EGL" : "default EGL display";
}

std::string DisplayCandidate::text() const {
  const std::string facts =
      joined({renderNode.empty() ? drmNode : renderNode,
              cudaId ? "cuda:" + std::to_string(*cudaId) : "", software ? "software" : ""});
  return name() + (facts.empty() ? "" : " (" + facts + ")");
}

bool DisplayCandidates::hasDevices() const {
  return std::ranges::count(candidates, DisplayCandidate::Kind::Device, &DisplayCandidate::kind) >
         0;
}

ChosenDisplay chooseDisplay(const DisplayCandidates& list, const DeviceChoice& choice,
                            const std::function<Attempt(std::size_t candidate)>& attempt) {
  DisplaySelection trial(list, choice);
  bool any = false;
  for (std::size_t i = 0; i < list.candidates.size(); ++i) {
    if (!isAllowed(list.candidates[i], choice)) continue;
    any = true;
    if (trial.takes(list.candidates[i], [&] { return attempt(i); })) return {i, trial.warning()};
  }
  if (!any) refuseMissing(list, choice);
  refuseAll(list, choice, trial.said());
}

bool isSoftwareRenderer(std::string_view renderer) {
  constexpr std::array<std::string_view, 5> kNames{"llvmpipe", "softpipe", "swrast",
                                                   "software rasterizer", "swiftshader"};
  std::string lower(renderer);
  std::ranges::transform(lower, lower.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return std::ranges::any_of(
      kNames, [&](std::string_view name) { return lower.find(name) != std::string::npos; });
}

}  // namespace rotatebook::render
