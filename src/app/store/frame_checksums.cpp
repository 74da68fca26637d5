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
constexpr std::string_view kBetween = "  ";
constexpr off_t kLargestSums = 256'000'000;  // Four times those of the longest clip. [bytes]

std::string lineOf(std::int64_t index, const std::string& sum) {
  return sum + std::string(kBetween) + frameName(index) + '\n';
}

[[noreturn]] void failMissing(const std::filesystem::path& folder, std::int64_t frame) {
  throw MachineError((folder / frameName(frame)).string() +
                     " is gone: it was removed while the clip was rendered");
}

}  // namespace

FrameChecksums::FrameChecksums(std::filesystem::path folder)
    : folder_(std::move(folder)),
      path_(folder_ / kFrameSumsName),
      sums_(parse(system::readFileOrEmpty(path_, kLargestSums))) {}

FrameChecksums::Sums FrameChecksums::parse(const std::string& text) {
  Sums sums;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < kDigits + kBetween.size()) continue;
    const auto index = frameIndex(line.substr(kDigits + kBetween.size()));
    if (index) sums[*index] = line.substr(0, kDigits);
  }
  return sums;
}

std::optional<std::string> FrameChecksums::intact(std::int64_t index) const {
  const auto known = sums_.find(index);
  if (known == sums_.end()) return std::nullopt;
  std::string bytes = system::readFileOrEmpty(folder_ / frameName(index), image::kLargestFile);
  if (bytes.empty() || checksumOf(bytes) != known->second) return std::nullopt;
  return bytes;
}

std::vector<std::int64_t> FrameChecksums::known() const {
  const auto indices = std::views::keys(sums_);
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
  const bool foreign = size > kLargestSums && ftruncate(file_.number(), 0) == 0;
  // A line that was cut off mustn't take the next one with it.
  if (size > 0 && !foreign) system::writeAll(file_, "\n", path_);
}

void FrameChecksums::requireFiles(FrameRange frames) const {
  for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
    if (!std::filesystem::exists(folder_ / frameName(frame))) failMissing(folder_, frame);
  }
}

void FrameChecksums::sort(FrameRange frames) {
  if (file_.isOpen()) sums_ = parse(system::readAll(file_, path_));
  for (std::int64_t frame = frames.first; frame < frames.end; ++frame) {
    if (!sums_.contains(frame)) failMissing(folder_, frame);
  }
  std::string text;
  for (const auto& [index, sum] : sums_) text += lineOf(index, sum);
  system::writeFileAtomically(path_, text);
  file_ = {};
}

}  // namespace rotatebook::store
