// The record of a clip in its file: the comment of an MP4 or a WebM. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/clip_parts.h"

namespace rotatebook::bridge {

/// A level of parts on the way to a record.
struct RecordLevel {
  std::string_view id;       ///< Part::id
  std::uint64_t before = 0;  ///< From its content to the parts in it. [bytes]
};

/// A search for the record in a file that is read in pieces, from its beginning to its end, but for
/// parts that can't hold it, and then where the record is. The file may be anything.
class RecordSearch {
 public:
  /// Begins in a file of `size` bytes.
  explicit RecordSearch(std::uint64_t size) : size_(size), open_{size} {}

  /// Returns the offset of the next piece. [bytes]
  std::uint64_t next() const { return at_; }
  /// Takes the next piece: kRecordPiece bytes, or all that are left. Returns the record's text once
  /// it is there; empty before. Throws InputError for a clip that is damaged, or hasn't one record.
  std::string take(std::string_view piece);

 private:
  void begin(std::string_view bytes);
  void walk(std::string_view piece);
  void step(std::string_view bytes);
  Part partAt(std::string_view bytes);
  void enter(std::size_t level, const Part& part);
  void endTag();

  std::uint64_t size_, at_ = 0;
  bool isMp4_ = false, isWalked_ = false;
  std::span<const RecordLevel> levels_{};
  std::vector<std::uint64_t> open_;  ///< The ends of the file, and of each level that at_ is in.
  std::size_t entered_ = 0;          ///< The deepest level that was entered, from 1.
  int parts_ = 0;
  bool hasPictures_ = false;      ///< Of an MP4.
  bool isComment_ = false;        ///< Of the tag that was entered last.
  std::optional<Part> text_{};    ///< Of that tag.
  std::optional<Part> record_{};  ///< Of the comment before it.
};

}  // namespace rotatebook::bridge
