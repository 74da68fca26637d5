// What of a machine decides whether EGL finds its renderers: files, libraries, permissions. Inside
// the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rotatebook::diagnose {

/// One of the files by which libEGL (glvnd) knows its drivers.
struct VendorFile {
  std::string path;
  std::string library;    ///< As the file names it, "libEGL_mesa.so.0"; empty if it names none.
  std::string failure{};  ///< Why the file can't be read or the library be loaded, or empty.
};

/// A card's file in /dev.
struct DeviceNode {
  std::string path;
  std::string group;      ///< Its group's name, or number where that has none.
  bool permitted = true;  ///< This process may read and write it.
};

struct GraphicsFacts {
  std::vector<VendorFile> vendorFiles{};
  /// The variable that names other vendor files than the system's, with its value, or empty:
  /// "__EGL_VENDOR_LIBRARY_FILENAMES=/x.json"
  std::string vendorVariable{};
  /// Set variables that change what Mesa and its EGL do, sorted: "MESA_GL_VERSION_OVERRIDE=2.1"
  std::vector<std::string> mesaVariables{};
  std::vector<DeviceNode> nodes{};  ///< /dev/dri/renderD* and /dev/nvidia*
  bool nvidiaLibrary = false;       ///< libEGL_nvidia.so.0 can be loaded.
  bool container = false;
  std::optional<std::string> nvidiaCapabilities{};  ///< NVIDIA_DRIVER_CAPABILITIES

  /// Whether there is a file of NVIDIA's kernel driver.
  bool hasNvidiaCard() const;
};

/// Reads them. Throws nothing: what can't be read isn't there.
GraphicsFacts readGraphicsFacts();

}  // namespace rotatebook::diagnose
