// The parts of clips' files: the boxes of an MP4, the elements of a WebM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook {

/// A box of an MP4 or an element of a WebM.
struct Part {
  std::string id;             ///< "tkhd", or an element's number in hexadecimal digits.
  std::uint64_t start = 0;    ///< Offset of its head. [bytes]
  std::uint64_t content = 0;  ///< Offset of its content. [bytes]
  std::uint64_t end = 0;      ///< Offset of its end, which may lie beyond the file's. [bytes]
};

/// The end of an element whose length isn't stated.
inline constexpr std::uint64_t kUnknownEnd = std::numeric_limits<std::uint64_t>::max();

/// The longest head of a part. [bytes]
inline constexpr std::size_t kMaxHead = 16;

/// The segment of a WebM, in which all but its header is.
inline constexpr std::string_view kWebmSegment = "18538067";

/// Return whether a file of those first bytes is an MP4, a WebM.
bool beginsAsMp4(std::string_view bytes);
bool beginsAsWebm(std::string_view bytes);

/// Returns the box whose head `bytes` begin with; nothing if there is none. They may be anything;
/// in the file they are at offset `at` of a box or file that ends at offset `end`.
std::optional<Part> mp4Box(std::string_view bytes, std::uint64_t at, std::uint64_t end);
/// Likewise the element of a WebM.
std::optional<Part> webmElement(std::string_view bytes, std::uint64_t at, std::uint64_t end);
using PartReader = decltype(&mp4Box);

/// Returns the unsigned number of big-endian `bytes`, at most eight.
std::uint64_t bigEndian(std::string_view bytes);
/// Returns an element's number, of at most eight bytes, as Part::id has it.
std::string webmId(std::string_view bytes);

}  // namespace rotatebook
