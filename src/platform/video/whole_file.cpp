#include "video/whole_file.h"

#include <cstdint>
#include <fstream>

#include <fmt/core.h>

#include "base/clip_parts.h"
#include "base/error.h"
#include "video/layout.h"

namespace rotatebook::video {
namespace {

constexpr int kMaxFileBoxes = 1000;  // Limit on the outer boxes of an MP4; there are four.

[[noreturn]] void throwTruncated(const std::string& name, const std::string& problem) {
  throw InputError(fmt::format("{} ends early, or is damaged: {}{}", name, problem, kCopyRemedy));
}

void requireSize(std::uint64_t size, std::uint64_t stated, const std::string& name) {
  if (size >= stated) return;
  throwTruncated(name, fmt::format("it has {} of at least {} bytes", size, stated));
}

void requireWholeMp4(std::istream& file, std::uint64_t size, const std::string& name) {
  bool header = false, pictures = false;
  std::uint64_t at = 0;
  // Whatever follows both does no harm.
  for (int i = 0; !header || !pictures; ++i) {
    const auto box = i < kMaxFileBoxes ? partAt(file, mp4Box, at, size) : std::nullopt;
    if (!box) throwTruncated(name, header ? "it has no pictures" : "it has no header");
    requireSize(size, box->end, name);
    header = header || box->id == "moov";
    pictures = pictures || box->id == "mdat";
    at = box->end;
  }
}

void requireWholeWebm(std::istream& file, std::uint64_t size, const std::string& name) {
  const auto head = partAt(file, webmElement, 0, size);
  if (!head || head->end > size) throwTruncated(name, "it has no header");
  const auto segment = partAt(file, webmElement, head->end, size);
  if (!segment || segment->id != kWebmSegment) throwTruncated(name, "it has no pictures");
  if (segment->end != kUnknownEnd) requireSize(size, segment->end, name);
}

}  // namespace

void requireWholeFile(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return;
  std::ifstream file(path, std::ios::binary);
  if (file) requireWholeFile(file, path.string());
}

void requireWholeFile(std::istream& file, const std::string& name) {
  const std::string head = bytesAt(file, 0, kMaxHead);
  const std::uint64_t size = sizeOf(file);
  if (beginsAsWebm(head)) return requireWholeWebm(file, size, name);
  if (beginsAsMp4(head)) requireWholeMp4(file, size, name);
}

}  // namespace rotatebook::video
