#include "pipeline/frame_sums.h"

#include <fcntl.h>
#include <sstream>
#include <utility>

#include "base/atomic_file.h"
#include "base/read_file.h"
#include "pipeline/checksum.h"
#include "pipeline/clip_files.h"

namespace rotatebook::pipeline {
namespace {

constexpr std::size_t kDigits = 32;
constexpr std::string_view kBetween = "  ";

std::string lineOf(std::int64_t index, const std::string& sum) {
  return sum + std::string(kBetween) + frameName(index) + '\n';
}

}  // namespace

FrameSums::FrameSums(std::filesystem::path folder)
    : folder_(std::move(folder)), path_(folder_ / kFrameSumsName), sums_(read(path_)) {}

FrameSums::Sums FrameSums::read(const std::filesystem::path& path) {
  Sums sums;
  std::istringstream text(readFileOrEmpty(path));
  for (std::string line; std::getline(text, line);) {
    if (line.size() < kDigits + kBetween.size()) continue;
    const auto index = frameIndex(line.substr(kDigits + kBetween.size()));
    if (index) sums[*index] = line.substr(0, kDigits);
  }
  return sums;
}

std::optional<std::string> FrameSums::intact(std::int64_t index) const {
  const auto known = sums_.find(index);
  if (known == sums_.end()) return std::nullopt;
  std::string bytes = readFileOrEmpty(folder_ / frameName(index));
  if (bytes.empty() || checksumOf(bytes) != known->second) return std::nullopt;
  return bytes;
}

void FrameSums::add(std::int64_t index, std::string_view bytes) {
  const std::string line = lineOf(index, checksumOf(bytes));
  const std::lock_guard lock(mutex_);
  if (!file_.isOpen()) {
    file_ = FileDescriptor(open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (!file_.isOpen()) throwLastError(path_, "write");
    // A line that was cut off mustn't take this one with it.
    if (!sums_.empty()) writeAll(file_, "\n", path_);
  }
  writeAll(file_, line, path_);
}

void FrameSums::sort() {
  sums_ = read(path_);
  std::string text;
  for (const auto& [index, sum] : sums_) text += lineOf(index, sum);
  writeFileAtomically(path_, text);
  file_ = {};
}

}  // namespace rotatebook::pipeline
