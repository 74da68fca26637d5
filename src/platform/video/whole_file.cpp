#include "video/whole_file.h"

#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include "base/error.h"
#include "video/mp4_layout.h"
#include "video/webm_layout.h"

namespace rotatebook::video {
namespace {

constexpr std::string_view kWebmHead = "\x1a\x45\xdf\xa3";
constexpr std::string_view kSegment = "\x18\x53\x80\x67";
constexpr int kMaxFileBoxes = 1000;  // Limit on the outer boxes of an MP4; there are four.

[[noreturn]] void throwTruncated(const std::string& name, const std::string& problem) {
  throw InputError(fmt::format("{} ends early, or is damaged: {}{}", name, problem, kCopyRemedy));
}

void requireSize(std::uint64_t size, std::uint64_t stated, const std::string& name) {
  if (size >= stated) return;
  throwTruncated(name, fmt::format("it has {} of at least {} bytes", size, stated));
}

/// Reads on; returns whether `file` continues with `bytes`.
bool continuesWith(std::istream& file, std::string_view bytes) {
  for (const char byte : bytes) {
    if (file.get() != static_cast<unsigned char>(byte)) return false;
  }
  return true;
}

/// Returns whether `file` begins with kWebmHead, and leaves it after that.
bool beginsAsWebm(std::istream& file) {
  file.clear();
  file.seekg(0);
  return continuesWith(file, kWebmHead);
}

bool beginsAsMp4(std::istream& file) {
  file.clear();
  file.seekg(4);
  return continuesWith(file, "ftyp");
}

void requireWholeMp4(std::istream& file, std::uint64_t size, const std::string& name) {
  bool header = false, pictures = false;
  std::uint64_t at = 0;
  // Whatever follows both does no harm.
  for (int i = 0; !header || !pictures; ++i) {
    const auto box = i < kMaxFileBoxes ? mp4BoxAt(file, at, size) : std::nullopt;
    if (!box) throwTruncated(name, header ? "it has no pictures" : "it has no header");
    requireSize(size, box->end, name);
    header = header || box->id == "moov";
    pictures = pictures || box->id == "mdat";
    at = box->end;
  }
}

/// Verifies the rest of a file that begins with kWebmHead.
void requireWholeWebm(std::istream& file, std::uint64_t size, const std::string& name) {
  const auto head = webmLengthIn(file);
  if (!head || *head > size) throwTruncated(name, "it has no header");
  file.seekg(static_cast<std::streamoff>(*head), std::ios::cur);
  if (!continuesWith(file, kSegment)) throwTruncated(name, "it has no pictures");
  const auto length = webmLengthIn(file);
  if (!file) throwTruncated(name, "it has no pictures");
  if (length) requireSize(size, static_cast<std::uint64_t>(file.tellg()) + *length, name);
}

}  // namespace

void requireWholeFile(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return;
  std::ifstream file(path, std::ios::binary);
  if (file) requireWholeFile(file, path.string());
}

void requireWholeFile(std::istream& file, const std::string& name) {
  file.clear();
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(file.tellg());
  if (beginsAsWebm(file)) return requireWholeWebm(file, size, name);
  if (beginsAsMp4(file)) requireWholeMp4(file, size, name);
}

bool beginsAsClip(std::istream& file) {
  return beginsAsWebm(file) || beginsAsMp4(file);
}

}  // namespace rotatebook::video
