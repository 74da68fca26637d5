#include "video/webm_header.h"

#include <algorithm>
#include <bit>

#include "base/error.h"

namespace rotatebook::video {
namespace {

// Elements' identifiers (RFC 9559), the marker of their length included.
constexpr std::uint64_t kSegmentId = 0x18538067, kTracksId = 0x1654AE6B;
constexpr std::uint64_t kTrackId = 0xAE, kVideoId = 0xE0;
constexpr std::uint64_t kCropBottomId = 0x54AA, kCropTopId = 0x54BB, kCropLeftId = 0x54CC,
                        kCropRightId = 0x54DD;
constexpr std::uint64_t kInterlacedId = 0x9A;
constexpr int kMaxElements = 10'000;  // Limit of a search; the tracks are among the first ten.
constexpr int kMaxNumber = 8;         // Of a number. [bytes]

/// An element; `end` may lie beyond the file's.
struct Element {
  std::uint64_t id = 0;
  std::uint64_t content = 0;  ///< Offset of its content. [bytes]
  std::uint64_t end = 0;      ///< Offset of its end. [bytes]
};

/// Reads the unsigned number of `count` bytes; 0 beyond the end.
std::uint64_t numberIn(std::istream& file, std::uint64_t count) {
  std::uint64_t value = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const int byte = file.get();
    if (byte < 0) return 0;
    value = value << 8 | static_cast<std::uint64_t>(byte);
  }
  return value;
}

/// Returns the element at offset `at` of one that ends at `end`; nothing if there is none.
std::optional<Element> elementAt(std::istream& file, std::uint64_t at, std::uint64_t end) {
  if (at >= end) return std::nullopt;
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  const int first = file.peek();
  if (first <= 0) return std::nullopt;
  const int length = std::countl_zero(static_cast<std::uint8_t>(first)) + 1;
  const std::uint64_t id = numberIn(file, static_cast<std::uint64_t>(length));
  const auto size = webmLengthIn(file);
  if (!file) return std::nullopt;
  const auto content = static_cast<std::uint64_t>(file.tellg());
  return Element{id, content, size ? std::min(content + *size, end) : end};
}

/// Calls `action` with each element in `outer`, up to the first for which it returns true, and
/// returns that. Throws InputError if there are too many: an instruction could hide behind them.
template <typename Action>
std::optional<Element> firstIn(std::istream& file, const Element& outer, const Action& action) {
  std::optional<Element> element = elementAt(file, outer.content, outer.end);
  for (int i = 0; element; ++i) {
    if (i == kMaxElements) throw InputError("too many elements");
    if (action(*element)) return element;
    element = elementAt(file, element->end, outer.end);
  }
  return std::nullopt;
}

std::optional<Element> find(std::istream& file, const Element& outer, std::uint64_t id) {
  return firstIn(file, outer, [&](const Element& element) { return element.id == id; });
}

std::string sideOf(std::uint64_t id) {
  switch (id) {
    case kCropLeftId:
      return "left";
    case kCropRightId:
      return "right";
    case kCropTopId:
      return "top";
    case kCropBottomId:
      return "bottom";
    default:
      return "";
  }
}

/// Calls `action` with each element in `outer` whose identifier is `id`.
template <typename Action>
void forEach(std::istream& file, const Element& outer, std::uint64_t id, const Action& action) {
  firstIn(file, outer, [&](const Element& element) {
    if (element.id == id) action(element);
    return false;
  });
}

/// Adds the instruction of `element`, of a track's video, if it is one.
void addTo(WebmHeader& header, std::istream& file, const Element& element) {
  const std::string side = sideOf(element.id);
  const std::uint64_t count = element.end - element.content;
  if ((side.empty() && element.id != kInterlacedId) || count > kMaxNumber) return;
  file.clear();
  file.seekg(static_cast<std::streamoff>(element.content));
  const std::uint64_t number = numberIn(file, count);
  if (element.id == kInterlacedId) {
    header.interlaced = header.interlaced || number == 1;
  } else if (number > 0) {
    const std::string before = header.crop == "none" ? "" : header.crop + ", ";
    header.crop = before + std::to_string(number) + " pixels at the " + side;
  }
}

}  // namespace

std::optional<std::uint64_t> webmLengthIn(std::istream& file) {
  const int first = file.get();
  if (first <= 0) return std::nullopt;
  const int more = std::countl_zero(static_cast<std::uint8_t>(first));
  const auto mask = static_cast<std::uint64_t>(0x7f >> more);
  std::uint64_t length = static_cast<std::uint64_t>(first) & mask;
  bool unknown = length == mask;
  for (int i = 0; i < more; ++i) {
    const int byte = file.get();
    if (byte < 0) return std::nullopt;
    length = length << 8 | static_cast<std::uint64_t>(byte);
    unknown = unknown && byte == 0xff;
  }
  return unknown ? std::nullopt : std::optional(length);
}

WebmHeader readWebmHeader(std::istream& file) try {
  WebmHeader header;
  file.clear();
  file.seekg(0, std::ios::end);
  const Element whole{0, 0, static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0))};
  const auto segment = find(file, whole, kSegmentId);
  const auto tracks = segment ? find(file, *segment, kTracksId) : std::nullopt;
  if (!tracks) return header;
  header.crop = "none";
  forEach(file, *tracks, kTrackId, [&](const Element& track) {
    forEach(file, track, kVideoId, [&](const Element& video) {
      firstIn(file, video, [&](const Element& element) {
        addTo(header, file, element);
        return false;
      });
    });
  });
  return header;
} catch (const InputError&) {
  return {};
}

}  // namespace rotatebook::video
