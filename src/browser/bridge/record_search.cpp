#include "bridge/record_search.h"

#include <algorithm>
#include <array>

#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/text.h"
#include "bridge/bridge.h"

namespace rotatebook::bridge {
namespace {

constexpr std::array kMp4Levels{
    RecordLevel{"moov"}, RecordLevel{"udta"},    RecordLevel{"meta", 4},   // A version.
    RecordLevel{"ilst"}, RecordLevel{"\251cmt"}, RecordLevel{"data", 8}};  // Type and locale.
// Segment, Tags, Tag, SimpleTag, TagString.
constexpr std::array kWebmLevels{RecordLevel{kWebmSegment}, RecordLevel{"1254c367"},
                                 RecordLevel{"7373"}, RecordLevel{"67c8"}, RecordLevel{"4487"}};
constexpr std::string_view kTagName = "45a3", kComment = "comment";
constexpr std::size_t kMaxNeeded = kMaxHead + kComment.size();  // At once. [bytes]

const std::string kCutOff = "The clip is cut off: the file ends within it.";

[[noreturn]] void throwDamaged(const std::string& problem) {
  throw InputError("The clip’s record is damaged: " + problem);
}

[[noreturn]] void throwTwice() {
  throwDamaged("it is there twice.");  // Players differ in which they take.
}

/// Returns `count` of `bytes` from `begin` on, or as many as there are.
std::string_view cut(std::string_view bytes, std::uint64_t begin, std::uint64_t count) {
  const auto most = [&](std::uint64_t number) {
    return static_cast<std::size_t>(std::min<std::uint64_t>(number, bytes.size()));
  };
  return bytes.substr(most(begin), most(count));
}

/// Returns the text of a record of `size` bytes, which begin with `bytes`.
std::string textOf(std::string_view bytes, std::uint64_t size) {
  if (!bytes.starts_with("# Made by rotatebook ")) {
    throw InputError(
        "This clip was made by another program: its comment isn’t a record of rotatebook.");
  }
  if (size > document::kLongestToml)
    throwDamaged("it is longer than 32 KiB, the limit for a scene.");
  std::string text = validUtf8(bytes);
  if (text != bytes) throwDamaged("it isn’t UTF-8.");
  return text;
}

}  // namespace

std::string RecordSearch::take(std::string_view piece) {
  if (piece.size() < std::min<std::uint64_t>(kRecordPiece, size_ - at_)) throw InputError(kCutOff);
  const std::uint64_t first = at_;
  if (first == 0) begin(piece);
  if (!isWalked_) walk(piece);
  if (!isWalked_ || at_ < first) return "";
  const std::uint64_t size = record_->end - record_->content;
  const std::string_view bytes = cut(piece, at_ - first, size);
  return bytes.size() < std::min<std::uint64_t>(size, document::kLongestToml) ? ""
                                                                              : textOf(bytes, size);
}

void RecordSearch::begin(std::string_view bytes) {
  isMp4_ = beginsAsMp4(bytes);
  if (bytes.size() < 12) throw InputError("The file is too short to be a clip.");
  if (!isMp4_ && !beginsAsWebm(bytes)) throw InputError("This file is neither an MP4 nor a WebM.");
  levels_ = isMp4_ ? std::span<const RecordLevel>(kMp4Levels) : kWebmLevels;
}

/// Walks on through the parts whose heads are in `piece`.
void RecordSearch::walk(std::string_view piece) {
  const std::uint64_t first = at_, end = at_ + piece.size();
  while (at_ < size_) {
    if (end < size_ && at_ + kMaxNeeded > end) return;
    step(cut(piece, at_ - first, piece.size()));
  }
  endTag();
  if (isMp4_ && (entered_ == 0 || !hasPictures_)) throw InputError(kCutOff);
  if (!record_) {
    throw InputError("This clip has no record of rotatebook, so there is nothing to compare with.");
  }
  at_ = record_->content;
  isWalked_ = true;
}

/// Goes into the part that `bytes` begin with, or beyond it.
void RecordSearch::step(std::string_view bytes) {
  while (at_ == open_.back()) open_.pop_back();
  bytes = cut(bytes, 0, open_.back() - at_);
  Part part = partAt(bytes);
  // Parts in an endless one come as if beside it: it ends where one comes that can't be in it.
  const bool isEndless = part.end == kUnknownEnd;
  if (isEndless) part.end = open_.back();
  if (part.end > open_.back()) throw InputError(kCutOff);
  at_ = isEndless ? part.content : part.end;
  const auto levels = levels_.first(open_.size());
  const auto found = std::ranges::find(levels, part.id, &RecordLevel::id);
  if (found != levels.end()) return enter(static_cast<std::size_t>(found - levels.begin()), part);
  hasPictures_ = hasPictures_ || part.id == "mdat";
  if (part.id == kTagName && levels.size() == levels_.size()) {
    const auto name = cut(bytes, part.content - part.start, part.end - part.content);
    isComment_ = lowerCase(name) == kComment;
  }
}

Part RecordSearch::partAt(std::string_view bytes) {
  constexpr int kMaxParts = 10'000;  // Clips have a few hundred.
  if (++parts_ > kMaxParts) {
    throw InputError("The clip’s record can’t be reached: the file has more than " +
                     std::to_string(kMaxParts) + " parts.");
  }
  const auto part = (isMp4_ ? mp4Box : webmElement)(bytes, at_, open_.back());
  if (part) return *part;
  if (bytes.size() < kMaxHead) throw InputError(kCutOff);
  throw InputError("The clip is damaged: a part of it has no size.");
}

/// Goes into a part that is of `level`, from 0; of the last, notes the text in it.
void RecordSearch::enter(std::size_t level, const Part& part) {
  if (isMp4_ && level < entered_) throwTwice();
  entered_ = std::max(entered_, level + 1);
  const std::uint64_t content = part.content + levels_[level].before;
  if (content > part.end) throw InputError(kCutOff);
  if (level + 1 == levels_.size()) {
    if (text_) throwTwice();
    text_ = {part.id, part.start, content, part.end};
    return;
  }
  at_ = content;
  open_.resize(level + 1);
  open_.push_back(part.end);
  if (level + 2 == levels_.size()) {
    endTag();
    isComment_ = isMp4_;
  }
}

void RecordSearch::endTag() {
  if (isComment_ && text_ && record_) throwTwice();
  if (isComment_ && text_) record_ = text_;
  text_.reset();
}

}  // namespace rotatebook::bridge
