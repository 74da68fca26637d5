#include "diagnose/remedies.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "base/text.h"

namespace rotatebook::diagnose {
namespace {

constexpr const char* kNvidiaLibrary = "libEGL_nvidia";
constexpr const char* kMesaLibrary = "libEGL_mesa";

constexpr const char* kInstallNvidia =
    "install the EGL library of NVIDIA's driver, of the kernel driver's version (Debian: apt-get "
    "install libegl-nvidia0; Ubuntu: libnvidia-gl-VERSION)";
constexpr const char* kGraphicsCapability =
    "start the container with NVIDIA_DRIVER_CAPABILITIES=all (or with graphics among them), so "
    "that it gets NVIDIA's EGL library";
constexpr const char* kAddVendorFile =
    "make, as root, the file by which EGL finds NVIDIA's library:\n"
    "  echo '{\"file_format_version\": \"1.0.0\", \"ICD\": {\"library_path\": "
    "\"libEGL_nvidia.so.0\"}}' > /usr/share/glvnd/egl_vendor.d/10_nvidia.json";
constexpr const char* kInstallMesaDrivers =
    "install Mesa's drivers (Debian, Ubuntu: apt-get install libegl-mesa0 libgl1-mesa-dri)";

bool isOf(const VendorFile& file, const char* library) {
  return file.library.find(library) != std::string::npos;
}

bool anyDraws(const GraphicsCheck& check, bool hardware) {
  return std::ranges::any_of(check.candidates, [&](const DisplayCheck& candidate) {
    return candidate.draws() && (!hardware || !candidate.software);
  });
}

/// Returns whether this container wasn't given NVIDIA's EGL library.
bool lacksGraphicsCapability(const GraphicsFacts& facts) {
  if (facts.nvidiaLibrary || !facts.container) return false;
  const std::string listed = facts.nvidiaCapabilities.value_or("");
  return listed.find("all") == std::string::npos && listed.find("graphics") == std::string::npos;
}

std::string permissionRemedy(const DeviceNode& node) {
  if (node.group.empty() || node.group == "root") {
    return "let this user read and write " + node.path;
  }
  return fmt::format(
      "join the group {0} (sudo usermod -aG {0} $USER, then log in again; for a container: "
      "--group-add {0})",
      node.group);
}

/// Returns the problem of a device node that this process may not open.
Problem permissionProblem(const std::string& what, const DeviceNode& node) {
  return {fmt::format("{}: no permission on {}", what, node.path), permissionRemedy(node)};
}

/// Returns a node that this process may not open: the one at `path` or, if that is empty, any that
/// is NVIDIA's or, without `nvidia`, isn't. Null if there is none.
const DeviceNode* forbiddenNode(const GraphicsFacts& facts, const std::string& path, bool nvidia) {
  const auto found = std::ranges::find_if(facts.nodes, [&](const DeviceNode& node) {
    const bool fits =
        path.empty() ? nvidia == node.path.starts_with("/dev/nvidia") : node.path == path;
    return fits && !node.permitted;
  });
  return found == facts.nodes.end() ? nullptr : &*found;
}

/// Returns the candidate's own render node, if EGL reports it, or else any node of its maker, if
/// this process may not open it; else null.
const DeviceNode* forbiddenNode(const GraphicsFacts& facts,
                                const render::DisplayCandidate& candidate) {
  const DeviceNode* own = candidate.renderNode.empty() && candidate.nvidia
                              ? nullptr
                              : forbiddenNode(facts, candidate.renderNode, false);
  return own == nullptr && candidate.nvidia ? forbiddenNode(facts, "", true) : own;
}

/// Returns the remedy for a driver that draws wrongly, or ends the process.
std::string updateRemedy(bool software) {
  return software ? "update Mesa (Debian, Ubuntu: apt-get install libgl1-mesa-dri)"
                  : "update the card's driver; until then --device software";
}

std::string first(const std::string& attempt, const std::string& remedy) {
  return fmt::format("{}; if that doesn't help: {}", attempt, remedy);
}

/// Returns "raise ulimit -d (it is 100000 kB); if that doesn't help: `remedy`"; `remedy` alone if
/// there are no limits.
std::string raisingFirst(const std::vector<std::string>& limits, const std::string& remedy) {
  return limits.empty() ? remedy : first("raise " + joined(limits), remedy);
}

/// Returns "unset GALLIUM_NOOP (it is 1), LP_X (it is 2); if that doesn't help: `remedy`"; `remedy`
/// alone if there are no variables.
std::string unsettingFirst(const std::vector<std::string>& variables, const std::string& remedy) {
  const std::string names = joinedOf(variables, [](const std::string& variable) {
    const std::size_t end = variable.find('=');
    return fmt::format("{} (it is {})", variable.substr(0, end), variable.substr(end + 1));
  });
  return names.empty() ? remedy : first("unset " + names, remedy);
}

class Diagnosis {
 public:
  Diagnosis(const GraphicsCheck& check, const GraphicsFacts& facts)
      : check_(check), facts_(facts) {}

  std::vector<Problem> take() {
    if (check_.library) {
      add(check_.library->text(), missingLibraryRemedy());
      return problems_;
    }
    addVendorFiles();
    addUnlistedNvidia();
    addDeviceList();
    for (std::size_t i = 0; i < check_.candidates.size(); ++i) {
      const DisplayCheck& candidate = check_.candidates[i];
      if (candidate.candidate.kind != render::DisplayCandidate::Kind::Device &&
          check_.byDefault != i)
        continue;
      addFailedDevice(candidate);
      addWrongPicture(candidate);
    }
    addForbiddenCard();
    if (problems_.empty() && !check_.draws()) {
      add("no EGL display gives an OpenGL 3.3 core context" + failuresOfDisplays(),
          unsettingFirst(facts_.mesaVariables, render::kInstallMesa));
    }
    return problems_;
  }

  /// `check`: one with a failure.
  Problem failureProblem(const DisplayCheck& check) const {
    const std::string what = fmt::format("{}: {}", check.candidate.text(), check.failure->text());
    const DeviceNode* node =
        check.candidate.software ? nullptr : forbiddenNode(facts_, check.candidate);
    if (node != nullptr) return permissionProblem(what, *node);
    return {what, unsettingFirst(variablesOf(check), deviceRemedy(check))};
  }

 private:
  void add(std::string what, std::string remedy) {
    problems_.push_back({std::move(what), std::move(remedy)});
  }

  std::string missingLibraryRemedy() const {
    const bool egl = check_.library->error.find("libEGL") != std::string::npos;
    return egl ? "install EGL (Debian, Ubuntu: apt-get install libegl1 libegl-mesa0 "
                 "libgl1-mesa-dri libopengl0)"
               : "install OpenGL's library (Debian, Ubuntu: apt-get install libopengl0)";
  }

  void addVendorFiles() {
    const bool usable = std::ranges::any_of(
        facts_.vendorFiles, [](const VendorFile& file) { return file.failure.empty(); });
    if (!usable && !facts_.vendorVariable.empty()) {
      const std::string name = facts_.vendorVariable.substr(0, facts_.vendorVariable.find('='));
      return add(facts_.vendorVariable + " names no EGL driver that can be loaded",
                 fmt::format("unset {}, so that the system's drivers are found", name));
    }
    if (facts_.vendorFiles.empty()) {
      // Without glvnd there are no such files, and EGL may draw all the same.
      if (check_.draws()) return;
      return add(
          "no EGL driver is installed: /usr/share/glvnd/egl_vendor.d has no file",
          facts_.hasNvidiaCard() && facts_.nvidiaLibrary ? kAddVendorFile : kInstallMesaDrivers);
    }
    for (const VendorFile& file : facts_.vendorFiles) {
      if (!file.failure.empty()) add(file.path + ": " + file.failure, vendorRemedy(file));
    }
  }

  std::string vendorRemedy(const VendorFile& file) const {
    if (isOf(file, kMesaLibrary)) return kInstallMesaDrivers;
    if (!isOf(file, kNvidiaLibrary)) return "install " + file.library + ", or remove " + file.path;
    if (!facts_.hasNvidiaCard()) return "there is no NVIDIA card: remove " + file.path;
    return lacksGraphicsCapability(facts_) ? kGraphicsCapability : kInstallNvidia;
  }

  /// Adds the problem of an NVIDIA card that EGL doesn't list.
  void addUnlistedNvidia() {
    const bool listed = std::ranges::any_of(check_.candidates, [](const DisplayCheck& candidate) {
      return candidate.candidate.nvidia;
    });
    // A problem of the library, or of the variable, was added before.
    const bool named = std::ranges::any_of(facts_.vendorFiles, [](const VendorFile& file) {
      return isOf(file, kNvidiaLibrary) && !file.failure.empty();
    });
    if (!facts_.hasNvidiaCard() || listed || named || !problems_.empty()) return;
    const std::string what = "NVIDIA's card is there, but EGL doesn't list it";
    if (const DeviceNode* node = forbiddenNode(facts_, "", true)) {
      problems_.push_back(permissionProblem(what, *node));
    } else if (lacksGraphicsCapability(facts_)) {
      const std::string listedText = facts_.nvidiaCapabilities.value_or("not set");
      add(what + ": NVIDIA_DRIVER_CAPABILITIES is " + listedText, kGraphicsCapability);
    } else if (!facts_.nvidiaLibrary) {
      add(what + ": libEGL_nvidia.so.0 can't be loaded", kInstallNvidia);
    } else if (isNvidiaNamed()) {
      add(what + ", though its library is there", kInstallNvidia);
    } else {
      add(what + ": no vendor file names libEGL_nvidia.so.0", kAddVendorFile);
    }
  }

  bool isNvidiaNamed() const {
    return std::ranges::any_of(facts_.vendorFiles,
                               [](const VendorFile& file) { return isOf(file, kNvidiaLibrary); });
  }

  void addDeviceList() {
    if (!check_.devices || !problems_.empty()) return;
    if (isNvidiaNamed() && !facts_.hasNvidiaCard()) {
      add(check_.devices->text() + ", as where NVIDIA's EGL library is installed without its card",
          facts_.container ? "start the container with the card (docker run --gpus all)"
                           : "remove NVIDIA's driver, or its 10_nvidia.json, if the card is gone");
    } else if (!check_.draws()) {
      add(check_.devices->text(), unsettingFirst(facts_.mesaVariables, kInstallMesaDrivers));
    }
  }

  void addFailedDevice(const DisplayCheck& check) {
    if (check.failure) problems_.push_back(failureProblem(check));
  }

  /// Returns the variables that may be why it fails: Mesa's, unless the driver is NVIDIA's.
  std::vector<std::string> variablesOf(const DisplayCheck& check) const {
    return check.candidate.nvidia ? std::vector<std::string>{} : facts_.mesaVariables;
  }

  std::string deviceRemedy(const DisplayCheck& check) const {
    const bool old =
        check.failure->call.starts_with("eglCreateContext") || check.failure->error == "missing";
    if (check.ends)
      return raisingFirst(facts_.memoryLimits, updateRemedy(check.candidate.software));
    if (check.candidate.software) return kInstallMesaDrivers;
    if (check.candidate.nvidia && lacksGraphicsCapability(facts_)) return kGraphicsCapability;
    if (check.candidate.nvidia) return kInstallNvidia;
    return old ? "update the card's driver to one with OpenGL 3.3 core; until then --device "
                 "software"
               : kInstallMesaDrivers;
  }

  void addWrongPicture(const DisplayCheck& check) {
    if (check.failure || check.reference.passed()) return;
    const std::string why = check.reference.failure.empty()
                                ? "the reference picture isn't drawn as it should be"
                                : "the reference picture failed: " + check.reference.failure;
    add(fmt::format("{}, {}: {}", check.candidate.text(), check.renderer, why),
        unsettingFirst(variablesOf(check), updateRemedy(check.software)));
  }

  /// Adds the problem of a card that EGL doesn't list, and that this process may not open.
  void addForbiddenCard() {
    if (!problems_.empty() || anyDraws(check_, true)) return;
    if (const DeviceNode* node = forbiddenNode(facts_, "", false)) {
      problems_.push_back(permissionProblem("a graphics card isn't used", *node));
    }
  }

  std::string failuresOfDisplays() const {
    std::string text;
    for (const DisplayCheck& candidate : check_.candidates) {
      if (candidate.failure)
        text += fmt::format("; {}: {}", candidate.candidate.text(), candidate.failure->text());
    }
    return text;
  }

  const GraphicsCheck& check_;
  const GraphicsFacts& facts_;
  std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> diagnose(const GraphicsCheck& check, const GraphicsFacts& facts) {
  return Diagnosis(check, facts).take();
}

std::optional<Problem> diagnoseCrash(const GraphicsCheck& check, const GraphicsFacts& facts,
                                     const render::DeviceChoice& choice) {
  const std::optional<std::size_t> last = lastTried(check.candidates, choice);
  if (!last || !check.candidates[*last].ends) return std::nullopt;
  return Diagnosis(check, facts).failureProblem(check.candidates[*last]);
}

}  // namespace rotatebook::diagnose
