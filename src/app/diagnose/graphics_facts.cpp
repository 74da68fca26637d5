#include "diagnose/graphics_facts.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <grp.h>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "base/json.h"
#include "base/text.h"
#include "system/portable_folder.h"
#include "system/read_file.h"
#include "system/resource_limits.h"

namespace rotatebook::diagnose {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVendorFiles = "__EGL_VENDOR_LIBRARY_FILENAMES";
constexpr const char* kVendorFolders = "__EGL_VENDOR_LIBRARY_DIRS";
constexpr const char* kSystemFolders = "/etc/glvnd/egl_vendor.d:/usr/share/glvnd/egl_vendor.d";

std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

/// Returns whether the program itself has set a variable to this value: NAME=VALUE.
bool isOwn(std::string_view text) {
  static const std::vector<system::Variable> kOwn = system::portableVariables();
  return std::ranges::any_of(kOwn, [&](const system::Variable& own) { return own.text() == text; });
}

/// Lists the environment variables that Mesa reads, with their values, sorted.
std::vector<std::string> mesaVariables() {
  constexpr std::array<std::string_view, 5> kBeginnings{"MESA_", "GALLIUM_", "LIBGL_", "LP_",
                                                        "EGL_"};
  std::vector<std::string> found;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const auto begins = [&](std::string_view name) { return text.starts_with(name); };
    if (std::ranges::any_of(kBeginnings, begins) && !isOwn(text)) found.emplace_back(text);
  }
  std::ranges::sort(found);
  return found;
}

std::vector<std::string> partsOf(const std::string& paths) {
  std::vector<std::string> parts = itemsOf(paths, ':');
  std::erase(parts, "");
  return parts;
}

/// Lists the files of a folder whose names begin and end so, sorted.
std::vector<std::string> filesIn(const std::string& folder, const std::string& beginning,
                                 const std::string& ending) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name.starts_with(beginning) && name.ends_with(ending)) files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

std::string loadFailure(const std::string& library) {
  return dlopen(library.c_str(), RTLD_LAZY) != nullptr ? "" : dlerror();
}

VendorFile readVendorFile(const std::string& path) {
  const std::string text = system::readFileOrEmpty(path);
  if (text.empty())
    return {path, "", access(path.c_str(), F_OK) == 0 ? "can't be read" : "isn't there"};
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  const Json::json_pointer library("/ICD/library_path");
  if (!json.contains(library) || !json[library].is_string()) return {path, "", "names no library"};
  const std::string name = json[library];
  return {path, name, loadFailure(name)};
}

std::vector<std::string> vendorPaths() {
  if (const auto files = variable(kVendorFiles)) return partsOf(*files);
  std::vector<std::string> paths;
  for (const std::string& folder : partsOf(variable(kVendorFolders).value_or(kSystemFolders))) {
    const auto files = filesIn(folder, "", ".json");
    paths.insert(paths.end(), files.begin(), files.end());
  }
  return paths;
}

std::string groupOf(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return "";
  const group* entry = getgrgid(status.st_gid);
  return entry != nullptr ? entry->gr_name : std::to_string(status.st_gid);
}

DeviceNode readNode(const std::string& path) {
  return {path, groupOf(path), access(path.c_str(), R_OK | W_OK) == 0};
}

bool inContainer() {
  return access("/.dockerenv", F_OK) == 0 || access("/run/.containerenv", F_OK) == 0 ||
         variable("container") || variable("KUBERNETES_SERVICE_HOST") ||
         variable("NVIDIA_VISIBLE_DEVICES");
}

}  // namespace

bool GraphicsFacts::hasNvidiaCard() const {
  return std::ranges::any_of(
      nodes, [](const DeviceNode& node) { return node.path.starts_with("/dev/nvidia"); });
}

GraphicsFacts readGraphicsFacts() {
  GraphicsFacts facts;
  for (const char* name : {kVendorFolders, kVendorFiles}) {
    const auto value = variable(name);
    if (!value) continue;
    const std::string text = name + ("=" + *value);
    facts.vendorVariable = isOwn(text) ? "" : text;
  }
  facts.mesaVariables = mesaVariables();
  facts.memoryLimits = system::memoryLimits();
  for (const std::string& path : vendorPaths()) {
    facts.vendorFiles.push_back(readVendorFile(path));
  }
  for (const std::string& path : filesIn("/dev/dri", "renderD", "")) {
    facts.nodes.push_back(readNode(path));
  }
  // Only nodes with a number are cards: nvidiactl exists on machines without one, too.
  for (const std::string& path : filesIn("/dev", "nvidia", "")) {
    if (std::isdigit(static_cast<unsigned char>(path.back())) != 0) {
      facts.nodes.push_back(readNode(path));
    }
  }
  facts.nvidiaLibrary = loadFailure("libEGL_nvidia.so.0").empty();
  facts.container = inContainer();
  facts.nvidiaCapabilities = variable("NVIDIA_DRIVER_CAPABILITIES");
  return facts;
}

}  // namespace rotatebook::diagnose
