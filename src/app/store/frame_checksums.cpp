#include "store/frame_checksums.h"

#include <fcntl.h>
#include <ranges>
#include <sstream>
#include <utility>

#include "base/checksum.h"
#include "base/error.h"
#include "image/png_file.h"
#include "system/atomic_file.h"
#include "system/read_file.h"

namespace rotatebook::store {
namespace {

constexpr std::size_t kDigits = 32;
constexpr std::string_view kSeparator = "  ";
constexpr off_t kMaxFileBytes = 256'000'000;  // Four times the longest clip's. [bytes]

std::string lineOf(std::int64_t index, const std::string& sum) {
  return sum + std::string(kSeparator) + frameName(index) + '\n';
}

[[noreturn]] void failMissing(const std::filesystem::path& folder, std::int64_t frame) {
  throw MachineError((folder / frameName(frame)).string() +
                     " is gone: it was removed while the clip was rendered");
}

}  // namespace

FrameChecksums::FrameChecksums(std::filesystem::path folder)
    : folder_(std::move(folder)),
      path_(folder_ / kFrameChecksumsName),
      checksums_(parse(system::readFileOrEmpty(path_, kMaxFileBytes))) {}

FrameChecksums::Checksums FrameChecksums::parse(const std::string& text) {
  Checksums checksums;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < kDigits + kSeparator.size()) continue;
    const auto index = frameIndex(line.substr(kDigits + kSeparator.size()));
    if (index) checksums[*index] = line.substr(0, kDigits);
  }
  return checksums;
}

std::optional<std::string> FrameChecksums::intact(std::int64_t index) const {
  const auto known = checksums_.find(index);
  if (known == checksums_.end()) return std::nullopt;
  std::string bytes = system::readFileOrEmpty(folder_ / frameName(index), image::kLargestFile);
  if (bytes.empty() || checksumOf(bytes) != known->second) return std::nullopt;
  return bytes;
}

std::vector<std::int64_t> FrameChecksums::indices() const {
  const auto indices = std::views::keys(checksums_);
  return {indices.begin(), indices.end()};
}

void FrameChecksums::add(std::int64_t index, std::string_view bytes) {
  const std::string line = lineOf(index, checksumOf(bytes));
  const std::lock_guard lock(mutex_);
  if (!file_.isOpen()) openFile();
  system::writeAll(file_, line, path_);
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

void FrameChecksums::requireFiles(FrameRange frames) const {
  for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
    if (!std::filesystem::exists(folder_ / frameName(frame))) failMissing(folder_, frame);
  }
}

void FrameChecksums::sort(FrameRange frames) {
  // Read the lines that any process added
  if (file_.isOpen()) checksums_ = parse(system::readAll(file_, path_));

  for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
    if (!checksums_.contains(frame)) failMissing(folder_, frame);
  }

  // Write one line a frame
  std::string text;
  for (const auto& [index, sum] : checksums_) text += lineOf(index, sum);
  system::writeFileAtomically(path_, text);
  file_ = {};
}

}  // namespace rotatebook::store
