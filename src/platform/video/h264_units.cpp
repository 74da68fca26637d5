// Units of H.264 (ITU-T H.264).
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "video/bit_reader.h"
#include "video/coded_units.h"
#include "video/video_settings.h"

namespace rotatebook::video {
namespace {

// Types of NAL units (table 7-1), and the lowest bits of their first byte that hold it.
constexpr int kSlice = 1, kKeySlice = 5, kMessage = 6, kSequence = 7, kPicture = 8;
constexpr int kTypeBits = 0x1f;
constexpr int kForbiddenBit = 0x80;

int typeOf(Bytes unit) {
  return unit.empty() || (unit[0] & kForbiddenBit) != 0 ? -1 : unit[0] & kTypeBits;
}

/// Returns whether a unit is of that type, and marked as most needed.
bool isNeeded(Bytes unit, int type) {
  constexpr int kNeeded = 0x60;
  return !unit.empty() && unit[0] == (kNeeded | type);
}

std::string unitText(Bytes unit) {
  return "a NAL unit of type " + std::to_string(typeOf(unit));
}

/// Returns whether bytes follow each other that no unit may hold (7.4.1): some decoders would take
/// what comes then for another unit.
bool hidesUnit(Bytes unit) {
  constexpr int kEscape = 3;
  for (std::size_t i = 2; i < unit.size(); ++i) {
    if (unit[i - 2] == 0 && unit[i - 1] == 0 && unit[i] < kEscape) return true;
  }
  return false;
}

/// Returns the unit's payload without the bytes that keep it from looking like another one.
std::vector<std::uint8_t> payloadOf(Bytes unit) {
  constexpr int kEscape = 3;
  std::vector<std::uint8_t> bytes;
  int zeros = 0;
  for (const std::uint8_t byte : unit.subspan(std::min<std::size_t>(unit.size(), 1))) {
    const bool isEscape = zeros >= 2 && byte == kEscape;
    zeros = byte == 0 ? zeros + 1 : 0;
    if (!isEscape) bytes.push_back(byte);
  }
  return bytes;
}

/// Takes a number of `size` bytes and as many bytes as it says from the front of `rest`.
Bytes takeUnit(Bytes& rest, std::size_t size) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < std::min(size, rest.size()); ++i) length = length << 8 | rest[i];
  const std::size_t begin = std::min(size, rest.size());
  const Bytes unit = rest.subspan(begin, std::min(length, rest.size() - begin));
  rest = rest.subspan(begin + unit.size());
  return unit.size() == length ? unit : Bytes{};
}

/// Returns the bits of the longest vectors that x264 searches at a level (its table of levels).
std::uint32_t vectorBits(std::uint32_t level) {
  constexpr std::uint32_t kShortest = 8;  // Of vectors up to 64 pixels, in quarters.
  return kShortest + (level > 10 ? 1 : 0) + (level > 20 ? 1 : 0) + (level > 30 ? 1 : 0);
}

/// Facts of a sequence that its display repeats.
struct Sequence {
  bool isIntra = false;    ///< It is marked as one of key frames alone.
  bool isInOrder = false;  ///< Pictures are shown as they are decoded.
  std::uint32_t level = 0;
  std::uint32_t numberBits = 0;
  std::uint32_t references = 0;
};

/// Reads how many pictures wait to be shown; returns whether that is their delay in the container.
/// A decoder that is told otherwise may show them in another order.
bool isPlainWait(BitReader& in, const Sequence& sequence, const Payload& payload) {
  constexpr std::int64_t kMostWaiting = 2;
  if (in.flag() == sequence.isIntra) return false;
  if (sequence.isIntra) return true;
  if (!in.flag() || in.golomb() != 0 || in.golomb() != 0) return false;
  const std::uint32_t across = in.golomb(), down = in.golomb();
  if (across != vectorBits(sequence.level) || down != across) return false;
  const std::int64_t waiting = in.golomb();
  if ((waiting == 0) != sequence.isInOrder || waiting > kMostWaiting) return false;
  const bool isDelay =
      std::ssize(payload.sizes) > waiting ? payload.delay == waiting : payload.delay <= waiting;
  // x264 numbers the pictures that others refer to, twice as many where some wait for those.
  const std::uint32_t most = sequence.references * (waiting == kMostWaiting ? 2 : 1) + 1;
  return isDelay && in.golomb() == sequence.references &&
         sequence.numberBits == std::max(4U, static_cast<std::uint32_t>(std::bit_width(most)));
}

/// Reads what a sequence says of its display (E.1.1); returns whether libx264 says so.
bool isPlainDisplay(BitReader& in, const WrittenForm& form, const Sequence& sequence,
                    const Payload& payload) {
  constexpr std::uint32_t kSquare = 1, kUnspecified = 5, kBt709 = 1;
  if (!in.flag() || in.bits(8) != kSquare) return false;
  if (in.flag()) return false;  // Overscan.
  if (!in.flag() || in.bits(3) != kUnspecified || in.flag() || !in.flag()) return false;
  for (int i = 0; i < 3; ++i) {
    if (in.bits(8) != kBt709) return false;
  }
  if (in.flag() && (in.golomb() != 0 || in.golomb() != 0))
    return false;  // Chroma isn't at the left.
  if (!in.flag()) return false;
  const std::uint64_t unit = in.bits(32), scale = in.bits(32);
  const auto rate = static_cast<std::uint64_t>(form.frameRate.numerator);
  if (scale * static_cast<std::uint64_t>(form.frameRate.denominator) != 2 * rate * unit)
    return false;
  if (in.flag()) return false;  // A rate that never changes, which x264 leaves open.
  // Buffers, whose limits are stated for transmission, and fields.
  if (in.flag() || in.flag() || in.flag()) return false;
  return isPlainWait(in, sequence, payload) && in.isAtEnd();
}

/// Returns whether the pixels that are cut off, in steps of two, only fill up macroblocks.
bool isPlainSize(BitReader& in, const WrittenForm& form) {
  constexpr std::uint32_t kMacroblock = 16;
  const std::uint32_t width = kMacroblock * (in.golomb() + 1);
  const std::uint32_t height = kMacroblock * (in.golomb() + 1);
  if (!in.flag() || !in.flag()) return false;  // Fields; vectors in smaller blocks than theirs.
  std::array<std::uint32_t, 4> crop{};         // At left, right, top and bottom.
  if (in.flag()) {
    for (std::uint32_t& side : crop) side = 2 * in.golomb();
  }
  return crop[0] == 0 && crop[2] == 0 &&
         width - crop[1] == static_cast<std::uint32_t>(form.width) &&
         height - crop[3] == static_cast<std::uint32_t>(form.height);
}

/// Returns whether a sequence's parameters (7.3.2.1.1) are as libx264 writes them.
bool isPlainSequence(Bytes unit, const WrittenForm& form, const Payload& payload) {
  constexpr std::uint32_t kHigh = 100, kIntra = 0x10, kColour420 = 1, kInOrder = 2;
  const std::vector<std::uint8_t> bytes = payloadOf(unit);
  BitReader in(bytes);
  Sequence sequence;
  if (in.bits(8) != kHigh) return false;
  const std::uint32_t constraints = in.bits(8);
  sequence.isIntra = constraints == kIntra && payload.keys.size() == payload.sizes.size();
  if (constraints != 0 && !sequence.isIntra) return false;
  sequence.level = in.bits(8);
  if (in.golomb() != 0 || in.golomb() != kColour420) return false;
  if (in.golomb() != 0 || in.golomb() != 0 || in.flag() || in.flag()) return false;
  sequence.numberBits = in.golomb() + 4;
  const std::uint32_t order = in.golomb();
  sequence.isInOrder = order == kInOrder;
  if (order != 0 && order != kInOrder) return false;
  if (order == 0) in.golomb();
  sequence.references = in.golomb();
  if (in.flag()) return false;  // Gaps between pictures.
  return isPlainSize(in, form) && in.flag() && isPlainDisplay(in, form, sequence, payload);
}

/// Returns whether a picture's parameters (7.3.2.2) ask for no redundant or scattered slices, and
/// are as libx264 writes them where pictures don't depend on them.
bool isPlainPicture(Bytes unit, const Payload& payload) {
  constexpr std::uint32_t kByDistance = 2;  // Pictures are mixed by their distances.
  const std::vector<std::uint8_t> bytes = payloadOf(unit);
  BitReader in(bytes);
  if (in.golomb() != 0 || in.golomb() != 0) return false;
  in.flag();
  if (in.flag() || in.golomb() != 0) return false;  // Orders of fields.
  in.golomb(), in.golomb();
  in.flag();
  const std::uint32_t mixed = in.bits(2);
  if (mixed != kByDistance && (mixed != 0 || payload.delay > 0)) return false;
  in.golomb();
  if (in.golomb() != 0) return false;  // The quantiser of switching slices.
  const std::uint32_t offset = in.golomb();
  // Filters are stated in slices; no redundant ones; small blocks, too; no matrices of quantisers.
  return in.flag() && in.bits(2) == 0 && in.flag() && !in.flag() && in.golomb() == offset &&
         in.isAtEnd();
}

/// Returns whether `note` begins as libx264's do, of a version that decoders take for right: of
/// older ones FFmpeg, alone among decoders, repeats mistakes.
bool isOfKnownVersion(std::string_view note) {
  constexpr std::string_view kBegin = "x264 - core ";
  constexpr int kOldest = 152;  // Of 2017.
  int version = 0;
  if (!note.starts_with(kBegin)) return false;
  std::from_chars(note.data() + kBegin.size(), note.data() + note.size(), version);
  return version >= kOldest;
}

/// Returns whether settings of libx264 are of the form, or of kWebPreset.
bool areOfForm(const std::set<std::string>& settings, const WrittenForm& form) {
  const auto haveAll = [&](const std::vector<std::string>& needed) {
    return std::ranges::all_of(needed, [&](const auto& one) { return settings.contains(one); });
  };
  return form.preset.empty() || haveAll(noteSettings(form.crf, form.preset)) ||
         haveAll(presetSettings(kWebPreset));
}

/// Returns whether `text`, "cabac=1 ref=3 ...", states settings of libx264, each once: no word is
/// free but numbers, and these are the form's.
bool areSettings(const std::string& text, const WrittenForm& form) {
  static const std::regex kSetting(
      "(8x8dct|analyse|aq|b_adapt|b_bias|b_pyramid|bframes|bluray_compat|cabac|chroma_me|"
      "chroma_qp_offset|constrained_intra|cqm|crf|deadzone|deblock|decimate|direct|fast_pskip|"
      "interlaced|intra_refresh|ip_ratio|keyint|keyint_min|lookahead_threads|mbtree|me|me_range|"
      "mixed_ref|nr|open_gop|pb_ratio|psy|psy_rd|qcomp|qp|qpmax|qpmin|qpstep|rc|rc_lookahead|ref|"
      "scenecut|sliced_threads|stitchable|subme|threads|trellis|weightb|weightp)="
      "(dia|hex|umh|esa|tesa|crf|cqp|infinite|[-+0-9.]{1,6}([:,][-+0-9.]{1,6}){0,2}|"
      "0x[0-9a-f]{1,4}:0x[0-9a-f]{1,4})");
  std::set<std::string> names, settings;
  std::istringstream words(text);
  std::size_t length = 0;
  for (std::string word; words >> word; length += word.size() + 1) {
    std::smatch parts;
    if (!std::regex_match(word, parts, kSetting) || !names.insert(parts[1]).second) return false;
    settings.insert(word);
  }
  return length == text.size() + 1 && areOfForm(settings, form);  // One space between two.
}

/// Returns whether `note` has the words of libx264, of whatever build, and no others, and the
/// settings of the form.
bool isPlainNote(std::string_view note, const WrittenForm& form) {
  constexpr std::size_t kLongest = 2000;
  static const std::regex kVersion(
      "x264 - core [0-9]{3}( r[0-9]{1,5}([+][0-9]{1,4})?M?( [0-9a-f]{7,12}M?)?)? - "
      "H[.]264/MPEG-4 AVC codec - Copy(left|right) 2003-20[0-9]{2} - "
      "http://www[.]videolan[.]org/x264[.]html");
  constexpr std::string_view kOptions = " - options: ";
  if (note.size() > kLongest || !note.ends_with('\0')) return false;
  note.remove_suffix(1);
  const std::size_t end = note.find(kOptions);
  return end != note.npos && std::regex_match(std::string(note.substr(0, end)), kVersion) &&
         areSettings(std::string(note.substr(end + kOptions.size())), form);
}

/// Returns whether a unit is a single message: libx264's version and settings.
bool isNote(Bytes unit, const WrittenForm& form) {
  constexpr std::array<std::uint8_t, 16> kX264{0xdc, 0x45, 0xe9, 0xbd, 0xe6, 0xd9, 0x48, 0xb7,
                                               0x96, 0x2c, 0xd8, 0x20, 0xd9, 0x23, 0xee, 0xef};
  constexpr std::uint8_t kOwnData = 5, kEnd = 0x80;
  const std::vector<std::uint8_t> bytes = payloadOf(unit);
  std::size_t at = 1, length = 0;
  if (bytes.empty() || bytes[0] != kOwnData) return false;
  for (; at < bytes.size() && bytes[at] == 0xff; ++at) length += 0xff;
  if (at >= bytes.size()) return false;
  length += bytes[at++];
  if (length < kX264.size() || bytes.size() != at + length + 1 || bytes.back() != kEnd)
    return false;
  const std::string_view note(reinterpret_cast<const char*>(bytes.data()) + at, length);
  return std::equal(kX264.begin(), kX264.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at)) &&
         isOfKnownVersion(note.substr(kX264.size())) &&
         isPlainNote(note.substr(kX264.size()), form);
}

/// Returns whether a slice begins a picture (7.3.3), and is of the only parameters.
bool isWholePicture(Bytes unit) {
  constexpr std::size_t kHead = 16;
  const std::vector<std::uint8_t> bytes = payloadOf(unit.first(std::min(unit.size(), kHead)));
  BitReader in(bytes);
  if (in.golomb() != 0) return false;
  in.golomb();
  return in.golomb() == 0;
}

}  // namespace

std::string h264Difference(Bytes parameters, const WrittenForm& form, const Payload& payload) {
  constexpr std::array<std::uint8_t, 4> kHighEnd{0xfd, 0xf8, 0xf8, 0};  // 4:2:0, 8 bits, no more.
  constexpr std::size_t kHead = 6;
  if (parameters.size() < kHead) return "the stream lacks parameters";
  Bytes rest = parameters.subspan(kHead);
  const Bytes sequence = takeUnit(rest, 2);
  const bool isOne = !rest.empty() && rest[0] == 1;
  rest = rest.subspan(std::min<std::size_t>(rest.size(), 1));
  const Bytes picture = takeUnit(rest, 2);
  // Version, profile and level, sizes of four bytes, one sequence.
  const bool isHead = sequence.size() > 3 && parameters[0] == 1 &&
                      std::ranges::equal(parameters.subspan(1, 3), sequence.subspan(1, 3)) &&
                      parameters[4] == 0xff && parameters[5] == 0xe1;
  if (!isHead || !isOne || !std::ranges::equal(rest, kHighEnd)) return "the stream's head differs";
  if (!isNeeded(sequence, kSequence) || hidesUnit(sequence) ||
      !isPlainSequence(sequence, form, payload))
    return "the sequence's parameters differ";
  if (!isNeeded(picture, kPicture) || hidesUnit(picture) || !isPlainPicture(picture, payload))
    return "the pictures' parameters differ";
  return "";
}

PictureOrder::PictureOrder(Bytes parameters) {
  constexpr std::size_t kHead = 6;
  constexpr std::uint32_t kMostBits = 16;
  Bytes rest = parameters.subspan(std::min(parameters.size(), kHead));
  const std::vector<std::uint8_t> bytes = payloadOf(takeUnit(rest, 2));
  BitReader in(bytes);
  in.bits(24);
  for (int i = 0; i < 4; ++i) in.golomb();
  in.bits(2);
  const auto bits = [&] { return static_cast<int>(std::min(in.golomb() + 4, kMostBits)); };
  numberBits_ = bits();
  if (in.golomb() == 0) orderBits_ = bits();
}

bool PictureOrder::isPlain(Bytes packet, std::int64_t frame) {
  constexpr std::size_t kHead = 32;
  constexpr int kNeededBits = 0x60;
  Bytes rest = packet;
  Bytes unit = takeUnit(rest, 4);
  if (typeOf(unit) == kMessage) unit = takeUnit(rest, 4);
  const std::vector<std::uint8_t> bytes = payloadOf(unit.first(std::min(unit.size(), kHead)));
  BitReader in(bytes);
  for (int i = 0; i < 3; ++i) in.golomb();  // The first block, the type and the parameters.
  const bool isKey = typeOf(unit) == kKeySlice;
  if (isKey) needed_ = 0, start_ = frame;
  const auto isNext = [&](int size, std::int64_t number) {
    return in.bits(size) == (static_cast<std::uint64_t>(number) & ((1ULL << size) - 1));
  };
  if (!isNext(numberBits_, needed_)) return false;
  if (isKey) in.golomb();
  if (orderBits_ > 0 && !isNext(orderBits_, 2 * (frame - start_))) return false;
  if (!unit.empty() && (unit[0] & kNeededBits) != 0) ++needed_;
  return !isKey || in.bits(2) == 0;  // Those before it are shown; it is kept as others are.
}

CodedPicture h264Picture(Bytes packet, bool first, const WrittenForm& form) {
  Bytes rest = packet;
  Bytes unit = takeUnit(rest, 4);
  if (typeOf(unit) == kMessage && first) {
    if (!isNote(unit, form) || hidesUnit(unit)) return {.difference = "a foreign message"};
    unit = takeUnit(rest, 4);
  }
  const int type = typeOf(unit);
  CodedPicture picture{.isKey = type == kKeySlice};
  if (type != kSlice && type != kKeySlice) {
    picture.difference = unitText(unit);
  } else if (!rest.empty()) {
    picture.difference = unitText(takeUnit(rest, 4)) + " after its slice";
  } else if (!isWholePicture(unit) || hidesUnit(unit)) {
    picture.difference = "a slice that isn't a whole picture";
  }
  return picture;
}

}  // namespace rotatebook::video
