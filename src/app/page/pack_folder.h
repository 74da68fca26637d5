// The folder of a page for the web, which knows its own files. Inside the room only.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "page/pack_mark.h"
#include "system/atomic_file.h"

namespace rotatebook::page {

/// A folder that --pack writes. Files of others may lie in it; none is replaced or removed.
class PackFolder {
 public:
  /// Takes a folder and the names of the files that will be written. Creates it if it isn't there,
  /// and writes its mark. Throws InputError, with nothing changed, if it holds files and no mark,
  /// or in the place of one of `names` what no pack left: another file, a changed one or a link.
  PackFolder(std::filesystem::path folder, const std::vector<std::string>& names);

  /// Throws as the constructor does, and changes nothing.
  static void requireUsable(const std::filesystem::path& folder,
                            const std::vector<std::string>& names);

  /// Returns whether the file `name` is there, whole, and was made from `source`.
  bool has(const std::string& name, const std::string& source) const;
  /// Writes a file, all of it or nothing, by `make`. `source` is a checksum of what it is made
  /// from; empty if it is made again each time. Throws MachineError.
  void write(const std::string& name, const std::string& source,
             const std::function<void(system::AtomicFile&)>& make);
  /// Writes a text, all of it or nothing. Throws MachineError.
  void write(const std::string& name, std::string_view text);

  /// Has the mark list the files as they are now. Throws MachineError.
  void finish() const { writeMark(); }

  const std::filesystem::path& folder() const { return folder_; }
  /// Removes all files that a pack left here, and the folder if that empties it. Throws
  /// MachineError.
  void remove();

 private:
  void writeMark() const;

  std::filesystem::path folder_;
  PackFiles files_;
};

}  // namespace rotatebook::page
