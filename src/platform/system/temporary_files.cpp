#include "system/temporary_files.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <optional>
#include <regex>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include <fmt/core.h>

#include "base/checksum.h"
#include "system/file_descriptor.h"
#include "system/read_file.h"

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kInfix = ".rotatebook-";
constexpr std::size_t kHostDigits = 8, kBootDigits = 12;

/// The process that writes a temporary file, as its name tells.
struct Writer {
  std::string host, boot;  ///< Empty of a lock, which any machine may hold.
  pid_t process = 0;
};

std::string hostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// Returns the digits of this machine. Neither of its names alone tells all machines apart: copies
/// of one installation share the one, and machines at home the other.
const std::string& ownHost() {
  static const std::string digits =
      checksumOf(hostName() + '\n' + readFileOrEmpty("/etc/machine-id")).substr(0, kHostDigits);
  return digits;
}

/// Returns the digits of this machine's present start and of the PID namespace: a number of a
/// process means something within both alone.
const std::string& ownBoot() {
  static const std::string digits = [] {
    std::error_code unknown;
    return checksumOf(readFileOrEmpty("/proc/sys/kernel/random/boot_id") +
                      fs::read_symlink("/proc/self/ns/pid", unknown).string())
        .substr(0, kBootDigits);
  }();
  return digits;
}

fs::path besideAs(const fs::path& path, const std::string& ending) {
  return path.parent_path() / fmt::format(".{}{}{}", path.filename().string(), kInfix, ending);
}

/// Returns the writer that the temporary name `name` tells; nothing if it is another name.
std::optional<Writer> writerOf(const std::string& name) {
  static const std::regex kEnding("(?:([0-9a-f]{8})-([0-9a-f]{12})-([1-9][0-9]{0,8})|0)");
  const std::size_t infix = name.rfind(kInfix);
  if (!name.starts_with('.') || infix == std::string::npos) return std::nullopt;
  const std::string ending = name.substr(infix + kInfix.size());
  std::smatch match;
  if (!std::regex_match(ending, match, kEnding)) return std::nullopt;
  return Writer{match[1], match[2], match[3].matched ? std::stoi(match[3]) : 0};
}

/// Returns whether `file` was last changed before this machine started.
bool isOlderThanThisStart(const FileDescriptor& file) {
  struct stat status {};
  timespec now{}, sinceStart{};
  if (fstat(file.number(), &status) != 0 || clock_gettime(CLOCK_REALTIME, &now) != 0 ||
      clock_gettime(CLOCK_BOOTTIME, &sinceStart) != 0) {
    return false;
  }
  return status.st_mtim.tv_sec < now.tv_sec - sinceStart.tv_sec - 1;
}

/// Returns whether `writer` doesn't live any more. Locks alone don't tell: some network file
/// systems grant a machine locks that another one holds.
bool isDead(const Writer& writer, const FileDescriptor& file) {
  if (writer.process == 0) return true;  // Who gets a lock's file locked is the only one.
  if (writer.boot == ownBoot()) {
    return writer.process != getpid() && kill(writer.process, 0) != 0 && errno == ESRCH;
  }
  return writer.host == ownHost() && isOlderThanThisStart(file);
}

}  // namespace

std::string processName() {
  return fmt::format("{}-{}-{}", ownHost(), ownBoot(), getpid());
}

fs::path temporaryNameFor(const fs::path& path) {
  return besideAs(path, processName());
}

fs::path lockNameFor(const fs::path& path) {
  return besideAs(path, "0");
}

bool isTemporaryName(const std::string& name) {
  return writerOf(name).has_value();
}

void removeStaleTemporaries(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const auto writer = writerOf(entry.path().filename().string());
    if (!writer) continue;
    const FileDescriptor file(
        open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (!file.isOpen() || tryLock(file, Lock::Exclusive) != Locking::Held) continue;
    if (isDead(*writer, file)) fs::remove(entry.path(), ignored);
  }
}

}  // namespace rotatebook::system
