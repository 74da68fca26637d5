// Chooses which of a machine's renderers draws. Knows no EGL.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::render {

/// A call that failed, and the library's name or message for the failure.
struct CallFailure {
  std::string call;   ///< "eglInitialize"
  std::string error;  ///< "EGL_NOT_INITIALIZED"

  std::string text() const { return call + ": " + error; }
};

/// A candidate for the display, with what EGL reports about it before it is opened.
struct DisplayCandidate {
  enum class Kind { Device, Surfaceless, Default };

  Kind kind = Kind::Device;
  int index = 0;             ///< Of a device: EGL's number, which isn't CUDA's.
  bool software = false;     ///< True for a device with EGL_MESA_device_software.
  bool nvidia = false;       ///< True for a device with EGL_NV_device_cuda.
  std::string drmNode{};     ///< Such as "/dev/dri/card0"; empty if EGL reports none.
  std::string renderNode{};  ///< Such as "/dev/dri/renderD128"; empty if EGL reports none.
  std::optional<int> cudaId{};

  bool isHardware() const { return kind == Kind::Device && !software; }
  /// Returns "EGL device 0", "surfaceless EGL" or "default EGL display".
  std::string name() const;
  /// Returns the name with facts, such as "EGL device 0 (/dev/dri/renderD128, cuda:1)".
  std::string text() const;
};

/// All candidates, in the order in which a render tries them.
struct DisplayCandidates {
  std::vector<DisplayCandidate> candidates;
  std::optional<CallFailure> failure{};  ///< Why devices aren't listed.
  /// A card that isn't among the devices, such as "NVIDIA's card (/dev/nvidia0)", or empty.
  std::string unlistedCard{};

  bool hasDevices() const;
};

/// The user's choice of what draws.
struct DeviceChoice {
  enum class Kind {
    Any,          ///< The first candidate that draws.
    Index,        ///< The EGL device of this number, and no other.
    Cuda,         ///< The EGL device whose CUDA id this is, and no other.
    Software,     ///< The first candidate that is software.
    Surfaceless,  ///< DisplayCandidate::Kind::Surfaceless alone.
    Default,      ///< DisplayCandidate::Kind::Default alone.
  };

  Kind kind = Kind::Any;
  int number = 0;                ///< For Index and Cuda.
  bool requireHardware = false;  ///< Refuse software.
  /// Called with one line if software draws where hardware failed; on the thread that draws.
  std::function<void(const std::string& line)> warn{};
};

/// The result of trying a candidate: a renderer, or a failure.
struct Attempt {
  std::string renderer{};  ///< OpenGL's name for it.
  std::optional<CallFailure> failure{};
};

/// The result of chooseDisplay().
struct ChosenDisplay {
  std::size_t candidate = 0;  ///< Index in DisplayCandidates::candidates.
  std::string warning{};      ///< For DeviceChoice::warn, or empty.
};

/// Tries the candidates that `choice` allows, in order, and takes the first that satisfies it.
/// Calls `attempt` once for each candidate that it tries, last for the one that it takes. Throws
/// InputError, listing the devices, if the chosen device doesn't exist, and MachineError, with each
/// candidate's failure, if no candidate satisfies the choice.
ChosenDisplay chooseDisplay(const DisplayCandidates& list, const DeviceChoice& choice,
                            const std::function<Attempt(std::size_t candidate)>& attempt);

/// Returns whether OpenGL's name for a renderer is that of one that draws on the processor.
bool isSoftwareRenderer(std::string_view renderer);

/// Advice on what to install if nothing draws.
extern const char* const kInstallMesa;
/// A line that refers the user to `rotatebook doctor`; starts with a line feed.
extern const char* const kDoctorHint;

/// Returns the failure to load EGL's or OpenGL's library, if one is missing. Call it before any
/// other function: libepoxy ends the process if it finds no library.
std::optional<CallFailure> missingLibrary();

}  // namespace rotatebook::render
