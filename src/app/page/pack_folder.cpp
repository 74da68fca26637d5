#include "page/pack_folder.h"

#include <system_error>
#include <utility>

#include "base/error.h"
#include "system/file_checksum.h"
#include "system/read_file.h"
#include "system/removal.h"
#include "system/temporary_files.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

/// Returns whether a folder holds nothing, or only what a killed process was writing.
bool isUnused(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!system::isTemporaryName(entry.path().filename().string())) return false;
  }
  return !error;
}

/// Returns whether `folder` is one itself, and no link to one, also if its name ends in a slash.
bool isPlainFolder(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(
      fs::symlink_status(folder.has_filename() ? folder : folder.parent_path(), ignored));
}

/// Returns the files that the mark in `folder` lists. Throws InputError if there is none, and the
/// folder isn't unused.
PackFiles filesMarkedIn(const fs::path& folder) {
  const fs::path mark = folder / kPackMark;
  if (!system::isOccupied(folder)) return {};
  if (!isPlainFolder(folder))
    throw InputError("--pack " + folder.string() + " is no folder, or a link to one; name another");
  const auto files =
      system::isPlainFile(mark) ? parsePackMark(system::readFileOrEmpty(mark)) : std::nullopt;
  if (files) return *files;
  if (isUnused(folder)) return {};
  throw InputError("--pack: " + folder.string() +
                   " isn't empty, and no page that --pack made is in it; name another folder");
}

/// Returns whether `name` isn't there, or as a pack left it.
bool isAsPacked(const PackFiles& files, const fs::path& folder, const std::string& name) {
  const fs::path path = folder / name;
  if (!system::isOccupied(path)) return true;
  const auto known = files.find(name);
  return system::isPlainFile(path) && known != files.end() &&
         known->second.contains(system::checksumOfFile(path));
}

}  // namespace

void PackFolder::requireUsable(const fs::path& folder, const std::vector<std::string>& names) {
  const PackFiles files = filesMarkedIn(folder);
  for (const std::string& name : names) {
    if (isAsPacked(files, folder, name)) continue;
    throw InputError("--pack: " + (folder / name).string() +
                     " isn't as --pack left it, and would be replaced; move it away, or name "
                     "another folder");
  }
}

PackFolder::PackFolder(fs::path folder, const std::vector<std::string>& names)
    : folder_(std::move(folder)) {
  requireUsable(folder_, names);
  files_ = filesMarkedIn(folder_);
  system::createFolders(folder_);
  writeMark();
}

void PackFolder::writeMark() const {
  system::writeFileAtomically(folder_ / kPackMark, packMarkText(files_));
}

bool PackFolder::has(const std::string& name, const std::string& source) const {
  const auto known = files_.find(name);
  if (known == files_.end() || !system::isPlainFile(folder_ / name)) return false;
  const auto state = known->second.find(system::checksumOfFile(folder_ / name));
  return state != known->second.end() && state->second == source;
}

void PackFolder::write(const std::string& name, const std::string& source,
                       const std::function<void(system::AtomicFile&)>& make) {
  system::AtomicFile file(folder_ / name);
  make(file);
  // The mark knows the file before it is there, and still its earlier state, if that stays
  const std::string checksum = system::checksumOfFile(file.temporaryPath());
  files_[name][checksum] = source;
  writeMark();
  file.commit();
  files_[name] = {{checksum, source}};
}

void PackFolder::write(const std::string& name, std::string_view text) {
  write(name, "", [&](system::AtomicFile& file) { file.write(text); });
}

void PackFolder::remove() {
  for (const auto& [name, states] : files_) {
    if (isAsPacked(files_, folder_, name)) system::removeFile(folder_ / name);
  }
  system::removeFile(folder_ / kPackMark);
  std::error_code notEmpty;
  fs::remove(folder_, notEmpty);
}

}  // namespace rotatebook::page
