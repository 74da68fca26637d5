#include "system/portable_folder.h"

#include <cstdlib>
#include <system_error>

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarker = "share/rotatebook/portable";
constexpr const char* kVendorFiles = "__EGL_VENDOR_LIBRARY_FILENAMES";
constexpr const char* kVendorFolders = "__EGL_VENDOR_LIBRARY_DIRS";
constexpr const char* kVendors = "glvnd/egl_vendor.d";

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

/// Returns the files of the drivers that libEGL may choose from, in its order, separated by colons.
///
/// The host's Mesa isn't among them: it wants the host's libraries, and gets the folder's.
std::string vendorFiles(const fs::path& folder, const fs::path& host) {
  std::string files;
  for (const char* root : {"etc", "usr/share"}) {
    const fs::path nvidia = host / root / kVendors / "10_nvidia.json";
    if (!files.empty() || !isThere(nvidia)) continue;
    files = nvidia.string() + ':';
  }
  return files + (folder / "share" / kVendors / "50_mesa.json").string();
}

}  // namespace

std::vector<Variable> portableVariables(const fs::path& program, const fs::path& host) {
  const fs::path folder = program.parent_path().parent_path();
  if (folder.empty() || !isThere(folder / kMarker)) return {};
  std::vector<Variable> variables{{"LIBGL_DRIVERS_PATH", folder / "lib/dri"},
                                  {kVendorFiles, vendorFiles(folder, host)}};
  if (!isThere(host / "etc/fonts/fonts.conf")) {
    variables.push_back({"FONTCONFIG_FILE", folder / "etc/fonts/fonts.conf"});
  }
  return variables;
}

std::vector<Variable> portableVariables() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? std::vector<Variable>{} : portableVariables(program);
}

void usePortableFolder() {
  constexpr int kKeep = 0;  // The user's own value.
  for (const Variable& variable : portableVariables()) {
    // Set, it would override the folders that the user names.
    if (variable.name == kVendorFiles && std::getenv(kVendorFolders) != nullptr) continue;
    setenv(variable.name.c_str(), variable.value.c_str(), kKeep);
  }
}

}  // namespace rotatebook::system
