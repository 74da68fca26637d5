// ZIP archives: owners of what libzip gives, and archives that are made in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

// libzip's own.
struct zip;
struct zip_file;
struct zip_source;

namespace rotatebook::system {

/// Ends what libzip gave; what was changed in an archive is discarded.
struct ZipDeleter {
  void operator()(zip* archive) const;
  void operator()(zip_file* file) const;
  void operator()(zip_source* source) const;
};

/// An archive that is open.
using ZipArchive = std::unique_ptr<zip, ZipDeleter>;
/// A file in an archive, open for reading.
using ZippedFile = std::unique_ptr<zip_file, ZipDeleter>;

/// A new archive of files that aren't compressed and have no times, so that the same files make the
/// same bytes. In memory: libzip doesn't flush files of its own, and a kill would leave them.
class MemoryZip {
 public:
  /// Begins an archive; `failure` begins what is thrown: "can't make an archive".
  explicit MemoryZip(std::string failure);

  /// Adds the file at `path`, whose bytes are read by finish(). Throws MachineError.
  void addFile(const std::string& path, const std::string& name);
  /// Adds a file of `bytes`, which must live until finish(), with an extra field in its head.
  /// Throws MachineError.
  void addBytes(std::string_view bytes, const std::string& name, std::uint16_t extraId,
                std::string_view extra);
  /// Passes the archive's bytes to `take`, piece by piece. Nothing can be added then. Throws
  /// MachineError.
  void finish(const std::function<void(std::string_view)>& take);

 private:
  [[noreturn]] void fail(const char* cause) const;
  std::uint64_t add(zip_source* source, const std::string& name);

  std::string failure_;
  std::unique_ptr<zip_source, ZipDeleter> buffer_;
  ZipArchive archive_;
};

}  // namespace rotatebook::system
