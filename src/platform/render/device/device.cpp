#include "render/device/device.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::render {
namespace {

/// Whether `choice` allows to try `way`. Only a device tells beforehand that it is software.
bool isAllowed(const Way& way, const DeviceChoice& choice) {
  switch (choice.kind) {
    case DeviceChoice::Kind::Index:
      return way.kind == Way::Kind::Device && way.index == choice.number;
    case DeviceChoice::Kind::Cuda:
      return way.cudaId == choice.number;
    case DeviceChoice::Kind::Software:
      return !way.isHardware();
    case DeviceChoice::Kind::Surfaceless:
      return way.kind == Way::Kind::Surfaceless;
    case DeviceChoice::Kind::Default:
      return way.kind == Way::Kind::Default;
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

std::string devicesText(const WayList& list) {
  std::string text = "\nThere ";
  text += list.hasDevices() ? "are:" : "is no EGL device";
  for (const Way& way : list.ways) {
    if (way.kind == Way::Kind::Device) text += "\n  " + way.text();
  }
  return text;
}

std::string devicesFailure(const WayList& list) {
  if (list.failure) return "\n  EGL devices: " + list.failure->text();
  return list.hasDevices() ? "" : "\n  EGL devices: none";
}

[[noreturn]] void refuseMissing(const WayList& list, const DeviceChoice& choice) {
  const std::string message = "can't draw: there is no " + wordsOf(choice);
  if (list.hasDevices()) throw InputError(message + devicesText(list));
  throw MachineError(message + ":" + devicesFailure(list) + kAskDoctor);
}

/// `said` is a line for each way that was tried.
[[noreturn]] void refuseAll(const WayList& list, const DeviceChoice& choice,
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

std::string fallWarning(const std::string& renderer, const WayList& list,
                        const std::string& hardwareFailure) {
  std::string reason = hardwareFailure;
  if (reason.empty() && !list.unlistedCard.empty())
    reason = "EGL doesn't list " + list.unlistedCard;
  if (reason.empty()) return "";
  return "software draws (" + renderer + ") in place of hardware: " + reason +
         "; 'rotatebook doctor' tells what to do";
}

/// Tries one way after the other and keeps what they said.
class Trial {
 public:
  Trial(const WayList& list, const DeviceChoice& choice) : list_(list), choice_(choice) {}

  /// Whether `way` will do.
  bool takes(const Way& way, const std::function<Attempt()>& attempt) {
    if (choice_.requireHardware && way.software) return say(way, "software");
    const Attempt tried = attempt();
    if (tried.failure) {
      if (way.isHardware() && failed_.empty()) failed_ = way.text() + ": " + tried.failure->text();
      return say(way, tried.failure->text());
    }
    const bool software = way.software || isSoftwareRenderer(tried.renderer);
    if (choice_.requireHardware && software) return say(way, tried.renderer + ", software");
    if (choice_.kind == DeviceChoice::Kind::Software && !software) {
      return say(way, tried.renderer + ", hardware");
    }
    if (software && choice_.kind == DeviceChoice::Kind::Any) {
      warning_ = fallWarning(tried.renderer, list_, failed_);
    }
    return true;
  }

  const std::string& said() const { return said_; }
  const std::string& warning() const { return warning_; }

 private:
  bool say(const Way& way, const std::string& what) {
    said_ += "\n  " + way.text() + ": " + what;
    return false;
  }

  const WayList& list_;
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

std::string Way::name() const {
  if (kind == Kind::Device) return "EGL device " + std::to_string(index);
  return kind == Kind::Surfaceless ? "surfaceless EGL" : "default EGL display";
}

std::string Way::text() const {
  const std::string facts =
      joined({renderNode.empty() ? drmNode : renderNode,
              cudaId ? "cuda:" + std::to_string(*cudaId) : "", software ? "software" : ""});
  return name() + (facts.empty() ? "" : " (" + facts + ")");
}

bool WayList::hasDevices() const {
  return std::ranges::count(ways, Way::Kind::Device, &Way::kind) > 0;
}

ChosenWay chooseWay(const WayList& list, const DeviceChoice& choice,
                    const std::function<Attempt(std::size_t way)>& attempt) {
  Trial trial(list, choice);
  bool any = false;
  for (std::size_t i = 0; i < list.ways.size(); ++i) {
    if (!isAllowed(list.ways[i], choice)) continue;
    any = true;
    if (trial.takes(list.ways[i], [&] { return attempt(i); })) return {i, trial.warning()};
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
