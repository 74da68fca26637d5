#include "store/frame_checksums.h"

#include <algorithm>
#include <fcntl.h>
#include <ranges>
#include <sys/stat.h>
#include <utility>

#include <fmt/core.h>

#include "base/checksum.h"
#include "base/clip_limits.h"
#include "base/error.h"
#include "base/text.h"
#include "system/atomic_file.h"
#include "system/file_checksum.h"
#include "system/read_file.h"
#include "system/temporary_files.h"

namespace rotatebook::store {
namespace {

constexpr std::size_t kDigits = 32;
constexpr std::string_view kSeparator = "  ";
constexpr off_t kMaxFileBytes = 256'000'000;  // Four times the longest clip's. [bytes]

std::string lineOf(std::int64_t index, const std::string& sum) {
  return fmt::format("{}{}{}\n", sum, kSeparator, frameName(index));
}

/// Returns the text of `file`; empty if it isn't there or can't be one of ours. Throws MachineError
/// if the disk fails.
std::string contentOf(const std::filesystem::path& file) {
  try {
    return system::readFile(file, kMaxFileBytes);
  } catch (const InputError&) {
    return {};
  }
}

[[noreturn]] void failMissing(const std::filesystem::path& folder, std::int64_t frame) {
  throw MachineError((folder / frameName(frame)).string() +
                     " is gone: it was removed while the clip was rendered");
}

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FrameChecksums::FrameChecksums(std::filesystem::path folder, File file)
    : folder_(std::move(folder)),
      path_(folder_ / (file == File::Own ? partChecksumsName(system::processName())
                                         : std::string(kFrameChecksumsName))),
      checksums_(parse(contentOf(folder_ / kFrameChecksumsName))) {
  readParts(folder_, checksums_);
}

void FrameChecksums::readParts(const std::filesystem::path& folder, Checksums& checksums) {
  for (const std::string& name : partChecksumsIn(folder)) {
    for (const auto& [index, sum] : parse(contentOf(folder / name))) checksums[index] = sum;
  }
}

FrameChecksums::Checksums FrameChecksums::parse(const std::string& text) {
  Checksums checksums;
  for (const std::string& line : itemsOf(text, '\n')) {
    if (line.size() < kDigits + kSeparator.size()) continue;
    const auto index = frameIndex(line.substr(kDigits + kSeparator.size()));
    if (index) checksums[*index] = line.substr(0, kDigits);
  }
  return checksums;
}

std::string FrameChecksums::textOf(const Checksums& checksums) {
  std::string text;
  for (const auto& [index, sum] : checksums) text += lineOf(index, sum);
  return text;
}

std::optional<std::string> FrameChecksums::intact(std::int64_t index) const {
  const auto known = checksums_.find(index);
  if (known == checksums_.end()) return std::nullopt;
  const std::filesystem::path file = folder_ / frameName(index);
  const Stamp stamp = stampOf(file);
  std::string bytes = system::readFileOrEmpty(file, kMaxPictureBytes);
  if (bytes.empty() || checksumOf(bytes) != known->second) return std::nullopt;
  const std::lock_guard lock(mutex_);
  keepStamp(index, stamp);
  return bytes;
}

std::vector<std::int64_t> FrameChecksums::indices() const {
  const auto indices = std::views::keys(checksums_);
  return {indices.begin(), indices.end()};
}

std::vector<std::int64_t> FrameChecksums::foreignFrames(bool changed) const {
  // A file's change time can't be set, and is later if another file was moved to its name
  const std::int64_t listed = stampOf(folder_ / kFrameChecksumsName).modified;
  std::vector<std::int64_t> foreign;
  for (const std::int64_t index : framesIn(folder_)) {
    const bool mayDiffer = changed && stampOf(folder_ / frameName(index)).changed >= listed;
    if (!contains(index) || (mayDiffer && !intact(index))) foreign.push_back(index);
  }
  return foreign;
}

void FrameChecksums::add(std::int64_t index, std::string_view bytes) {
  const std::string sum = checksumOf(bytes);
  const Stamp stamp = stampOf(folder_ / frameName(index));
  const std::lock_guard lock(mutex_);
  // A file that isn't these bytes any more is read at the end
  const bool same = stamp.size == static_cast<std::int64_t>(bytes.size());
  keepStamp(index, same ? stamp : Stamp{});
  const auto known = checksums_.find(index);
  if (known != checksums_.end() && known->second == sum) return;
  if (!file_.isOpen()) openFile();
  system::writeAll(file_, lineOf(index, sum), path_);
}

void FrameChecksums::openFile() {
  system::requireReplaceable(path_);
  file_ = system::FileDescriptor(
      open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (!file_.isOpen()) system::throwLastError(path_, "write");
  const off_t size = lseek(file_.number(), 0, SEEK_END);
  // Empty a file that is too long to be one of ours
  const bool foreign = size > kMaxFileBytes && ftruncate(file_.number(), 0) == 0;
  // End a line that was cut off, so that it doesn't spoil the next one
  if (size > 0 && !foreign) system::writeAll(file_, "\n", path_);
}

FrameChecksums::Stamp FrameChecksums::stampOf(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return {};
  return {status.st_ino, status.st_size, nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

void FrameChecksums::keepStamp(std::int64_t index, const Stamp& stamp) const {
  const auto place = static_cast<std::size_t>(index);
  if (stamps_.size() <= place) stamps_.resize(place + 1);
  stamps_[place] = stamp;
}

FrameChecksums::Checksums FrameChecksums::present() const {
  Checksums all = checksums_;
  readParts(folder_, all);
  if (!file_.isOpen()) return all;
  for (const auto& [index, sum] : parse(system::readAll(file_, path_))) all[index] = sum;
  return all;
}

void FrameChecksums::requireUnchanged(FrameRange frames) const {
  std::optional<Checksums> sums;
  for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
    const std::filesystem::path file = folder_ / frameName(frame);
    const Stamp now = stampOf(file);
    if (now == Stamp{}) failMissing(folder_, frame);

    // Read the file only if somebody may have written to it
    const auto place = static_cast<std::size_t>(frame);
    if (place < stamps_.size() && stamps_[place] == now) continue;
    if (!sums) sums = present();
    const auto sum = sums->find(frame);
    if (sum == sums->end() || system::checksumOfFile(file) == sum->second) continue;
    throw MachineError(file.string() +
                       " isn't the picture that was drawn: it was changed while the clip was "
                       "rendered");
  }
}

void FrameChecksums::sort(FrameRange frames) {
  // Read the lines that any process added
  const std::vector<std::string> joined = partChecksumsIn(folder_);
  checksums_ = present();

  for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
    if (!checksums_.contains(frame)) failMissing(folder_, frame);
  }

  // Write one line a frame, then remove the files whose lines these are
  system::writeFileAtomically(folder_ / kFrameChecksumsName, textOf(checksums_));
  for (const std::string& name : joined) system::removeFile(folder_ / name);
  file_ = {};
}

void FrameChecksums::finishOwn() {
  if (!file_.isOpen() || path_ == folder_ / kFrameChecksumsName) return;
  const Checksums own = parse(system::readAll(file_, path_));
  file_ = {};
  const Checksums joined = parse(contentOf(folder_ / kFrameChecksumsName));
  const bool areJoined = std::ranges::includes(joined, own);  // Both ascend.
  areJoined ? system::removeFile(path_) : system::writeFileAtomically(path_, textOf(own));
}

bool FrameChecksums::existIn(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / kFrameChecksumsName) || !partChecksumsIn(folder).empty();
}

void FrameChecksums::removeFrom(const std::filesystem::path& folder) {
  system::removeFile(folder / kFrameChecksumsName);
  for (const std::string& name : partChecksumsIn(folder)) system::removeFile(folder / name);
}

std::filesystem::path FrameChecksums::filesIn(const std::filesystem::path& folder) {
  return folder / (partChecksumsIn(folder).empty() ? kFrameChecksumsName : "frames*.xxh128");
}

}  // namespace rotatebook::store
