// Which of a machine's renderers draws: what there is to choose from, and the choice. Knows no EGL.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::render {

/// A call that failed, and what the library called the failure.
struct CallFailure {
  std::string call;   ///< "eglInitialize"
  std::string error;  ///< "EGL_NOT_INITIALIZED"

  std::string text() const { return call + ": " + error; }
};

/// One candidate to a display, and what EGL tells of it before it is opened.
struct DisplayCandidate {
  enum class Kind { Device, Surfaceless, Default };

  Kind kind = Kind::Device;
  int index = 0;             ///< Of a device: EGL's number, which is not CUDA's.
  bool software = false;     ///< Of a device: it says EGL_MESA_device_software.
  bool nvidia = false;       ///< Of a device: it says EGL_NV_device_cuda.
  std::string drmNode{};     ///< Such as "/dev/dri/card0"; empty where EGL tells none.
  std::string renderNode{};  ///< Such as "/dev/dri/renderD128"; likewise.
  std::optional<int> cudaId{};

  bool isHardware() const { return kind == Kind::Device && !software; }
  /// "EGL device 0", "surfaceless EGL", "default EGL display"
  std::string name() const;
  /// "EGL device 0 (/dev/dri/renderD128, cuda:1)"
  std::string text() const;
};

/// All candidates, in the order in which they are tried.
struct DisplayCandidates {
  std::vector<DisplayCandidate> candidates;
  std::optional<CallFailure> failure{};  ///< Why devices aren't listed.
  /// A card that none of the devices is, such as "NVIDIA's card (/dev/nvidia0)", or empty.
  std::string unlistedCard{};

  bool hasDevices() const;
};

/// What the user asks for.
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
  int number = 0;                ///< Of Index and Cuda.
  bool requireHardware = false;  ///< Refuse software.
  /// Told in one line if software draws where hardware failed; on the thread that draws.
  std::function<void(const std::string& line)> warn{};
};

/// What trying a candidate gave: a renderer, or a failure.
struct Attempt {
  std::string renderer{};  ///< OpenGL's own name of it.
  std::optional<CallFailure> failure{};
};

struct ChosenDisplay {
  std::size_t candidate = 0;  ///< In DisplayCandidates::candidates.
  std::string warning{};      ///< For DeviceChoice::warn, or empty.
};

/// Tries the candidates that `choice` allows, in their order, and takes the first that gives what
/// it asks for. `attempt` is called once with each candidate that it tries, last with the one that
/// is taken. Throws InputError, naming what there is, for a device that isn't there, MachineError,
/// saying what each candidate said, where none will do.
ChosenDisplay chooseDisplay(const DisplayCandidates& list, const DeviceChoice& choice,
                            const std::function<Attempt(std::size_t candidate)>& attempt);

/// Whether OpenGL's name of a renderer is that of one that draws on the processor.
bool isSoftwareRenderer(std::string_view renderer);

/// What to install where nothing draws.
extern const char* const kInstallMesa;
/// A line that sends whoever can't draw to the doctor; begins with the end of the line before.
extern const char* const kAskDoctor;

/// The library that is missing, EGL's or OpenGL's. libepoxy ends the process where it finds none,
/// so ask before anything else.
std::optional<CallFailure> missingLibrary();

}  // namespace rotatebook::render
