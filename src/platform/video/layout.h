// Layouts of containers: the boxes or elements that the program's own muxers write. Inside the room
// only.
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/clip_parts.h"

namespace rotatebook::video {

inline constexpr int kAnyNumber = std::numeric_limits<int>::max();

/// A row of a layout, a table of all parts that a file may have, each below the one that it is in.
/// Where rows of one level have the same id, each is for the parts that those before it leave over.
struct LayoutRow {
  int level = 0;                  ///< 0 of the file, 1 in the last row of level 0, and so on.
  std::string_view id;            ///< As in Part.
  int min = 1;                    ///< The fewest that the muxer writes.
  int max = 1;                    ///< The most.
  std::string_view content = "";  ///< Its content, before the parts in it: see LayoutValues.
  std::string_view name = "";     ///< For messages; if empty, the id.
};

/// The values that layouts name. A row's content is a list of words, each for the bytes that
/// follow:
///   "00ff"     these bytes, or with "00/80" one of several of the same length
///   "matrix"   one of the texts of that name, of the same length
///   "width:2"  a number of two bytes, most significant first, within the bounds of that name
///   "width"    a number of all bytes that are left
///   "any:4"    any bytes, "zero:4" zeros; "any" and "zero" are for all bytes that are left
///   "payload"  any bytes that are left, as many as the number of that name
///   "*"        the words since "(" again, as often as there are bytes
struct LayoutValues {
  /// Bounds of a number, both included.
  struct Range {
    std::uint64_t min = 0, max = 0;
  };
  std::map<std::string_view, Range> numbers{};
  std::map<std::string_view, std::vector<std::string>> texts{};
};

/// The order of parts: that of their rows, or any. Players of MP4s may read a box by what they
/// know from those before it; elements of a WebM have no order.
enum class PartOrder { AsRows, Any };

/// Reads `count` bytes at offset `at`, fewer where the file ends; takes as much memory.
std::string bytesAt(std::istream& file, std::uint64_t at, std::uint64_t count);
/// Returns the part at offset `at` of one that ends at offset `end`; nothing if there is none.
std::optional<Part> partAt(std::istream& file, PartReader reader, std::uint64_t at,
                           std::uint64_t end);
/// Returns `number` as `count` bytes, at most eight, the most significant first.
std::string bigEndianBytes(std::uint64_t number, int count);
/// Returns the size of `file`. [bytes]
std::uint64_t sizeOf(std::istream& file);

/// Returns the first difference of `file` from the layout `rows`: "moov/trak/tkhd differs", "moov
/// holds one trak too many", "moov has its udta before its trak"; empty if there is
/// none. `file` may be anything.
std::string differenceFrom(std::span<const LayoutRow> rows, const LayoutValues& values,
                           std::istream& file, PartReader reader, PartOrder order);

}  // namespace rotatebook::video
