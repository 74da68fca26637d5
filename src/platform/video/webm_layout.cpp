#include "video/webm_layout.h"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/clip_parts.h"
#include "video/ffmpeg.h"
#include "video/layout.h"

namespace rotatebook::video {
namespace {

// Identifiers of elements (RFC 9559), the marker of their length included.
constexpr std::string_view kCluster = "1f43b675", kBlock = "a3", kGroup = "a0", kAlphaMode = "53c0",
                           kSeekHead = "114d9b74", kSeek = "4dbb", kSeekId = "53ab",
                           kSeekAt = "53ac", kCues = "1c53bb6b", kCueTime = "b3",
                           kCuePositions = "b7", kCueAt = "f1", kCueInner = "f0", kTime = "e7",
                           kGroupBlock = "a1", kReference = "fb", kChapters = "1043a770",
                           kEdition = "45b9", kAtom = "b6", kDisplay = "80";
constexpr std::uint64_t kMaxNumber = 8;  // Of a number. [bytes]

/// All elements. Measured on libavformat 59.27 and 62.19, the times of pictures on 59.27.
constexpr std::array kWebmRows{
    LayoutRow{0, "1a45dfa3", 1, 1, "", "EBML"},
    LayoutRow{1, "4286", 1, 1, "01", "EBMLVersion"},
    LayoutRow{1, "42f7", 1, 1, "01", "EBMLReadVersion"},
    LayoutRow{1, "42f2", 1, 1, "04", "EBMLMaxIDLength"},
    LayoutRow{1, "42f3", 1, 1, "08", "EBMLMaxSizeLength"},
    LayoutRow{1, "4282", 1, 1, "7765626d", "DocType"},
    LayoutRow{1, "4287", 1, 1, "02/04", "DocTypeVersion"},
    LayoutRow{1, "4285", 1, 1, "02", "DocTypeReadVersion"},
    LayoutRow{0, kWebmSegment, 1, 1, "", "Segment"},
    LayoutRow{1, kSeekHead, 0, 1, "", "SeekHead"},
    LayoutRow{2, kSeek, 1, 5, "", "Seek"},
    LayoutRow{3, kSeekId, 1, 1, "1549a966/1654ae6b/1254c367/1c53bb6b/1043a770", "SeekID"},
    LayoutRow{3, kSeekAt, 1, 1, "any", "SeekPosition"},
    LayoutRow{1, "ec", 0, 1, "zero", "Void"},
    LayoutRow{1, "1549a966", 1, 1, "", "Info"},
    LayoutRow{2, "2ad7b1", 1, 1, "0f4240", "TimestampScale"},
    LayoutRow{2, "7ba9", 0, 1, "title", "Title"},
    LayoutRow{2, "4d80", 1, 1, "4c617666", "MuxingApp"},
    LayoutRow{2, "5741", 1, 1, "4c617666", "WritingApp"},
    LayoutRow{2, "4489", 1, 1, "length", "Duration"},
    LayoutRow{1, "1654ae6b", 1, 1, "", "Tracks"},
    LayoutRow{2, "ae", 1, 1, "", "TrackEntry"},
    LayoutRow{3, "d7", 1, 1, "01", "TrackNumber"},
    LayoutRow{3, "73c5", 1, 1, "0000000000000001", "TrackUID"},
    LayoutRow{3, "9c", 1, 1, "00", "FlagLacing"},
    LayoutRow{3, "22b59c", 1, 1, "756e64", "Language"},
    LayoutRow{3, "88", 1, 1, "00", "FlagDefault"},
    LayoutRow{3, "86", 1, 1, "565f565039", "CodecID"},
    LayoutRow{3, "83", 1, 1, "01", "TrackType"},
    LayoutRow{3, "23e383", 0, 1, "frame_time", "DefaultDuration"},
    LayoutRow{3, "55ee", 0, 1, "00/01", "MaxBlockAdditionID"},
    LayoutRow{3, "ec", 0, 1, "zero", "Void"},
    LayoutRow{3, "e0", 1, 1, "", "Video"},
    LayoutRow{4, "b0", 1, 1, "width", "PixelWidth"},
    LayoutRow{4, "ba", 1, 1, "height", "PixelHeight"},
    LayoutRow{4, kAlphaMode, 1, 1, "01", "AlphaMode"},
    LayoutRow{4, "55b0", 1, 1, "", "Colour"},
    LayoutRow{5, "55ba", 1, 1, "01", "TransferCharacteristics"},
    LayoutRow{5, "55b1", 1, 1, "01", "MatrixCoefficients"},
    LayoutRow{5, "55bb", 1, 1, "01", "Primaries"},
    LayoutRow{5, "55b9", 1, 1, "01", "Range"},
    LayoutRow{5, "55b7", 1, 1, "01", "ChromaSitingHorz"},
    LayoutRow{5, "55b8", 1, 1, "02", "ChromaSitingVert"},
    LayoutRow{1, "1254c367", 1, 1, "", "Tags"},
    LayoutRow{2, "7373", 1, 1, "", "Tag"},
    LayoutRow{3, "63c0", 1, 1, "", "Targets"},
    LayoutRow{3, "67c8", 1, 1, "", "SimpleTag"},
    LayoutRow{4, "45a3", 1, 1, "434f4d4d454e54", "TagName"},
    LayoutRow{4, "4487", 1, 1, "comment", "TagString"},
    LayoutRow{2, "7373", 1, 1, "", "Tag"},
    LayoutRow{3, "63c0", 1, 1, "", "Targets"},
    LayoutRow{4, "63c5", 1, 1, "0000000000000001", "TagTrackUID"},
    LayoutRow{3, "67c8", 1, 1, "", "SimpleTag"},
    LayoutRow{4, "45a3", 1, 1, "4455524154494f4e", "TagName"},
    LayoutRow{4, "4487", 1, 1, "duration zero", "TagString"},
    LayoutRow{1, kCluster, 1, kAnyNumber, "", "Cluster"},
    LayoutRow{2, kTime, 1, 1, "any", "Timestamp"},
    LayoutRow{2, kBlock, 0, kAnyNumber, "81 any:2 00/80 any", "SimpleBlock"},
    LayoutRow{2, kGroup, 0, kAnyNumber, "", "BlockGroup"},
    LayoutRow{3, kGroupBlock, 1, 1, "81 any:2 00 any", "Block"},
    LayoutRow{3, "75a1", 1, 1, "", "BlockAdditions"},
    LayoutRow{4, "a6", 1, 1, "", "BlockMore"},
    LayoutRow{5, "ee", 1, 1, "01", "BlockAddID"},
    LayoutRow{5, "a5", 1, 1, "any", "BlockAdditional"},
    LayoutRow{3, kReference, 0, 1, "any", "ReferenceBlock"},
    LayoutRow{1, kChapters, 0, 1, "", "Chapters"},
    LayoutRow{2, kEdition, 1, 1, "", "EditionEntry"},
    LayoutRow{3, kAtom, 1, kAnyNumber, "", "ChapterAtom"},
    LayoutRow{4, "73c4", 1, 1, "any", "ChapterUID"},
    LayoutRow{4, "91", 1, 1, "any", "ChapterTimeStart"},
    LayoutRow{4, "92", 1, 1, "any", "ChapterTimeEnd"},
    LayoutRow{4, kDisplay, 1, 1, "", "ChapterDisplay"},
    LayoutRow{5, "85", 1, 1, "any", "ChapString"},
    LayoutRow{5, "437c", 1, 1, "756e64", "ChapLanguage"},
    LayoutRow{1, kCues, 0, 1, "", "Cues"},
    LayoutRow{2, "bb", 1, kAnyNumber, "", "CuePoint"},
    LayoutRow{3, kCueTime, 1, 1, "any", "CueTime"},
    LayoutRow{3, kCuePositions, 1, 1, "", "CueTrackPositions"},
    LayoutRow{4, "f7", 1, 1, "01", "CueTrack"},
    LayoutRow{4, kCueAt, 1, 1, "any", "CueClusterPosition"},
    LayoutRow{4, kCueInner, 0, 1, "any", "CueRelativePosition"}};

/// Returns the clip's length in the muxer's words, "00:00:01.500000000".
std::string durationText(std::int64_t milliseconds) {
  const std::int64_t seconds = milliseconds / 1000;
  return fmt::format("{:02}:{:02}:{:02}.{:03}000000", seconds / 3600, seconds / 60 % 60,
                     seconds % 60, milliseconds % 1000);
}

/// Returns when frame `n` is shown, as the muxer rounds it. [ms]
std::int64_t millisecondsAt(std::int64_t n, FrameRate rate) {
  return (2000 * n * rate.denominator + rate.numerator) / (2 * std::int64_t{rate.numerator});
}

LayoutValues valuesOf(const WrittenForm& form, const Payload& payload) {
  const auto only = [](std::int64_t value) {
    const auto number = static_cast<std::uint64_t>(value);
    return LayoutValues::Range{number, number};
  };
  const std::int64_t nanoseconds =
      1'000'000'000LL * form.frameRate.denominator / form.frameRate.numerator;
  const std::int64_t length =
      millisecondsAt(form.frames - 1, form.frameRate) + millisecondsAt(1, form.frameRate);
  const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(length));
  return {.numbers = {{"width", only(form.width)},
                      {"height", only(form.height)},
                      {"frame_time", only(nanoseconds)}},
          .texts = {{"length", {bigEndianBytes(bits, 8)}},
                    {"duration", {durationText(length)}},
                    {"title", {payload.title}},
                    {"comment", {payload.comment}}}};
}

/// An element that others point to, at `position` in the segment's content.
struct Place {
  std::string id;
  std::uint64_t position = 0;
  auto operator<=>(const Place&) const = default;
};

/// Calls `action` with each element in `outer`.
template <typename Action>
void forEachElement(std::istream& file, const Part& outer, const Action& action) {
  auto element = partAt(file, webmElement, outer.content, outer.end);
  for (; element; element = partAt(file, webmElement, element->end, outer.end)) action(*element);
}

/// Returns the first element in `outer` with that identifier.
Part elementIn(std::istream& file, const Part& outer, std::string_view id) {
  Part found;
  forEachElement(file, outer, [&](const Part& element) {
    if (element.id == id && found.id.empty()) found = element;
  });
  return found;
}

std::string contentOf(std::istream& file, const Part& element) {
  return bytesAt(file, element.content, std::min(element.end - element.content, kMaxNumber));
}

/// Returns the place that a Seek or a CuePoint points to.
Place targetOf(std::istream& file, const Part& pointer) {
  if (pointer.id == kSeek) {
    const std::string id = contentOf(file, elementIn(file, pointer, kSeekId));
    return {webmId(id), bigEndian(contentOf(file, elementIn(file, pointer, kSeekAt)))};
  }
  const Part positions = elementIn(file, pointer, kCuePositions);
  return {std::string(kCluster), bigEndian(contentOf(file, elementIn(file, positions, kCueAt)))};
}

/// Returns whether all pointers in the segment, of a file that the layout fits, point to what is
/// there. Who follows one that doesn't finds what nobody else reads.
bool pointersAreRight(std::istream& file, const Part& segment) {
  std::set<Place> places, targets;
  forEachElement(file, segment, [&](const Part& element) {
    places.insert({element.id, element.start - segment.content});
    if (element.id != kSeekHead && element.id != kCues) return;
    forEachElement(file, element,
                   [&](const Part& pointer) { targets.insert(targetOf(file, pointer)); });
  });
  return std::ranges::includes(places, targets);
}

/// A picture in a cluster.
struct Block {
  std::uint64_t cluster = 0;  ///< Position of its cluster in the segment's content.
  std::uint64_t inner = 0;    ///< Its own in the cluster's.
  std::int64_t time = 0;      ///< [ms]
  bool isKey = false;
};

/// Returns a number of eight bytes at most, of which the first has the sign.
std::int64_t signedNumber(const std::string& bytes) {
  const int unused = 64 - 8 * static_cast<int>(bytes.size());
  return unused == 64 ? 0 : static_cast<std::int64_t>(bigEndian(bytes) << unused) >> unused;
}

/// Returns the picture in a SimpleBlock or BlockGroup of a cluster that began at `start` [ms],
/// after one at `before` [ms]; a time of -1 if it refers to another than that one.
Block blockIn(std::istream& file, const Part& element, std::int64_t start, std::int64_t before) {
  constexpr std::uint8_t kKeyFlag = 0x80;
  const bool isSimple = element.id == kBlock;
  const Part inner = isSimple ? element : elementIn(file, element, kGroupBlock);
  const std::string head = bytesAt(file, inner.content, 4);  // Track, time and flags.
  Block block{.time = start + signedNumber(head.substr(1, 2))};
  const Part reference = isSimple ? Part{} : elementIn(file, element, kReference);
  block.isKey = isSimple ? static_cast<std::uint8_t>(head[3]) == kKeyFlag : reference.id.empty();
  if (!reference.id.empty() && block.time + signedNumber(contentOf(file, reference)) != before)
    block.time = -1;
  return block;
}

/// Returns all pictures of a segment that the layout fits.
std::vector<Block> blocksIn(std::istream& file, const Part& segment) {
  std::vector<Block> blocks;
  forEachElement(file, segment, [&](const Part& cluster) {
    if (cluster.id != kCluster) return;
    std::int64_t start = -1;  // None before its Timestamp.
    forEachElement(file, cluster, [&](const Part& element) {
      if (element.id == kTime) {
        start = static_cast<std::int64_t>(bigEndian(contentOf(file, element)));
      } else {
        Block block = blockIn(file, element, start, blocks.empty() ? 0 : blocks.back().time);
        block.cluster = cluster.start - segment.content;
        block.inner = element.start - cluster.content;
        blocks.push_back(block);
      }
    });
  });
  return blocks;
}

/// Returns whether the pictures have their times, and those alone are marked as key frames that
/// are.
bool blocksAreRight(const std::vector<Block>& blocks, const WrittenForm& form,
                    const Payload& payload) {
  std::size_t key = 0;
  for (std::size_t n = 0; n < blocks.size(); ++n) {
    const bool isKey = key < payload.keys.size() && payload.keys[key] == n;
    key += isKey ? 1 : 0;
    const auto frame = static_cast<std::int64_t>(n);
    if (blocks[n].isKey != isKey || blocks[n].time != millisecondsAt(frame, form.frameRate))
      return false;
  }
  return std::ssize(blocks) == form.frames;
}

/// Returns whether each key frame has its CuePoint, in order; true, too, if there are none at all.
bool cuesAreRight(std::istream& file, const Part& segment, const std::vector<Block>& blocks) {
  const Part cues = elementIn(file, segment, kCues);
  if (cues.id.empty()) return true;
  std::vector<Block> keys;
  std::ranges::copy_if(blocks, std::back_inserter(keys), &Block::isKey);
  std::size_t count = 0;
  bool areRight = true;
  forEachElement(file, cues, [&](const Part& cue) {
    const Block key = count < keys.size() ? keys[count] : Block{.time = -1};
    const Part positions = elementIn(file, cue, kCuePositions);
    const Part inner = elementIn(file, positions, kCueInner);
    const auto number = [&](const Part& part) { return bigEndian(contentOf(file, part)); };
    areRight = areRight && std::cmp_equal(number(elementIn(file, cue, kCueTime)), key.time) &&
               number(elementIn(file, positions, kCueAt)) == key.cluster &&
               (inner.id.empty() || number(inner) == key.inner);
    ++count;
  });
  return areRight && count == keys.size();
}

/// Returns whether a segment that the layout fits has the clip's chapters, in their order.
bool chaptersAreRight(std::istream& file, const Part& segment, const WrittenForm& form) {
  std::size_t count = 0;
  bool areRight = true;
  const Part edition = elementIn(file, elementIn(file, segment, kChapters), kEdition);
  forEachElement(file, edition, [&](const Part& atom) {
    if (count++ >= form.chapters.size()) return;
    const auto number = [&](std::string_view id) {
      return bigEndian(contentOf(file, elementIn(file, atom, id)));
    };
    const auto nanoseconds = [&](std::int64_t frame) {
      return static_cast<std::uint64_t>(av_rescale_q(
          frame, {form.frameRate.denominator, form.frameRate.numerator}, {1, 1'000'000'000}));
    };
    const Chapter& chapter = form.chapters[count - 1];
    const std::int64_t end =
        count < form.chapters.size() ? form.chapters[count].frame : form.frames;
    const Part name = elementIn(file, elementIn(file, atom, kDisplay), "85");
    areRight = areRight && number("73c4") == count && number("91") == nanoseconds(chapter.frame) &&
               number("92") == nanoseconds(end) &&
               bytesAt(file, name.content, name.end - name.content) == chapter.name;
  });
  return areRight && count == form.chapters.size();
}

}  // namespace

std::string webmDifference(std::istream& file, const WrittenForm& form, const Payload& payload) {
  std::array rows = kWebmRows;
  const auto only = [&](std::string_view id, int max) {
    LayoutRow& row = *std::ranges::find(rows, id, &LayoutRow::id);
    row.min = std::min(row.min, max);
    row.max = max;
  };
  only(kAlphaMode, form.transparent ? 1 : 0);
  only(kGroup, form.transparent ? kAnyNumber : 0);
  only(kBlock, form.transparent ? 0 : kAnyNumber);
  if (form.chapters.empty()) only(kChapters, 0);
  const std::string difference =
      differenceFrom(rows, valuesOf(form, payload), file, webmElement, PartOrder::Any);
  if (!difference.empty()) return difference;
  const Part segment = elementIn(file, Part{"", 0, 0, sizeOf(file)}, kWebmSegment);
  const std::vector<Block> blocks = blocksIn(file, segment);
  if (!blocksAreRight(blocks, form, payload)) return "Segment/Cluster has a picture that differs";
  if (!chaptersAreRight(file, segment, form)) return "Segment/Chapters differs";
  if (!pointersAreRight(file, segment) || !cuesAreRight(file, segment, blocks))
    return "a pointer in Segment leads elsewhere";
  return "";
}

}  // namespace rotatebook::video
