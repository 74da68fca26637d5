// The facts of a machine that decide whether EGL finds its renderers: files, libraries,
// permissions. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rotatebook::diagnose {

/// One of the files by which libEGL (glvnd) finds its drivers.
struct VendorFile {
  std::string path;
  std::string library;    ///< The library that it names, "libEGL_mesa.so.0"; empty if none.
  std::string failure{};  ///< Why the file can't be read or its library loaded, or empty.
};

/// A graphics card's file in /dev.
struct DeviceNode {
  std::string path;
  std::string group;      ///< Its group's name, or its number if the group has no name.
  bool permitted = true;  ///< This process may read and write it.
};

/// The results of readGraphicsFacts().
struct GraphicsFacts {
  std::vector<VendorFile> vendorFiles{};
  /// The user's variable that replaces the system's vendor files, with its value, or empty:
  /// "__EGL_VENDOR_LIBRARY_FILENAMES=/x.json"
  std::string vendorVariable{};
  /// Variables that the user has set and that change what Mesa and its EGL do, sorted:
  /// "MESA_GL_VERSION_OVERRIDE=2.1"
  std::vector<std::string> mesaVariables{};
  std::vector<std::string> memoryLimits{};  ///< system::memoryLimits()
  std::vector<DeviceNode> nodes{};          ///< /dev/dri/renderD* and /dev/nvidia*
  bool nvidiaLibrary = false;               ///< libEGL_nvidia.so.0 can be loaded.
  bool container = false;
  std::optional<std::string> nvidiaCapabilities{};  ///< NVIDIA_DRIVER_CAPABILITIES

  /// Returns whether there is a device node of NVIDIA's kernel driver.
  bool hasNvidiaCard() const;
};

/// Reads the facts. Doesn't throw: what can't be read is taken to be missing.
GraphicsFacts readGraphicsFacts();

}  // namespace rotatebook::diagnose
