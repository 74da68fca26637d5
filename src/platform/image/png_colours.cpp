#include "image/png_colours.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string_view>

#include <fmt/core.h>

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::image {
namespace {

using PngBytes = std::span<const std::uint8_t>;

constexpr std::size_t kSignature = 8, kChunkHead = 8, kChunkEnd = 4;  // [bytes]
constexpr std::size_t kBitDepth = 8;                                  // in IHDR

std::uint32_t wordAt(PngBytes bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (const std::uint8_t byte : bytes.subspan(at, 4)) word = word << 8 | byte;
  return word;
}

/// Returns the chunks before the pixels, by their names.
std::map<std::string, PngBytes, std::less<>> chunksIn(PngBytes bytes) {
  std::map<std::string, PngBytes, std::less<>> chunks;
  for (std::size_t at = kSignature; at + kChunkHead <= bytes.size();) {
    const std::size_t size = wordAt(bytes, at);
    const auto name = bytes.subspan(at + 4, 4);
    const std::size_t begin = at + kChunkHead;
    if (size > bytes.size() - begin) break;
    const std::string text(name.begin(), name.end());
    if (text == "IDAT") break;
    chunks.emplace(text, bytes.subspan(begin, size));
    at = begin + size + kChunkEnd;
  }
  return chunks;
}

/// Returns a profile's name, which is in Latin-1, in quotes.
std::string profileName(PngBytes chunk) {
  const auto end = std::ranges::find(chunk, std::uint8_t{0});
  std::string name(chunk.begin(), end);
  std::ranges::replace_if(
      name, [](char c) { return c < ' ' || c > '~'; }, '?');
  return quotedBeginning(name, 40);
}

bool isSrgbGamma(PngBytes chunk) {
  constexpr std::int64_t kGamma = 45'455, kRoom = 500;  // 1e5 / 2.2
  return chunk.size() == 4 && std::abs(wordAt(chunk, 0) - kGamma) <= kRoom;
}

/// Returns whether primaries are those of sRGB, and white is its.
bool areSrgbPrimaries(PngBytes chunk) {
  constexpr std::array<std::int64_t, 8> kPrimaries{31'270, 32'900, 64'000, 33'000,
                                                   30'000, 60'000, 15'000, 6'000};
  constexpr std::int64_t kRoom = 200;  // of 1e5
  for (std::size_t i = 0; i < kPrimaries.size(); ++i) {
    if (chunk.size() != 32 || std::abs(wordAt(chunk, 4 * i) - kPrimaries.at(i)) > kRoom)
      return false;
  }
  return true;
}

/// Returns whether a profile of that name is sRGB, and not the one of its primaries whose values
/// are linear: "GIMP built-in Linear sRGB", "sRGB-elle-V2-g10.icc".
bool isSrgbName(const std::string& name) {
  const auto has = [&](std::string_view part) { return name.find(part) != name.npos; };
  return has("sRGB") && !has("inear") && !has("g10");
}

/// Returns what a cICP chunk says; empty if that is sRGB, from 0 to 255.
std::string otherCode(PngBytes chunk) {
  // BT.709's primaries, sRGB's curve, no matrix, and the full range
  constexpr std::array<std::uint8_t, 4> kSrgb{1, 13, 0, 1};
  if (chunk.size() != kSrgb.size() || std::ranges::equal(chunk, kSrgb)) return "";
  return fmt::format("colours of the code {}, {}, {}, {} (cICP)", chunk[0], chunk[1], chunk[2],
                     chunk[3]);
}

/// Returns what says that the colours aren't sRGB; the first chunk of these decides.
std::string otherColours(const std::map<std::string, PngBytes, std::less<>>& chunks) {
  const auto find = [&](std::string_view name) {
    const auto found = chunks.find(name);
    return found == chunks.end() ? PngBytes() : found->second;
  };
  if (const PngBytes code = find("cICP"); !code.empty()) return otherCode(code);
  if (const PngBytes profile = find("iCCP"); !profile.empty()) {
    const std::string name = profileName(profile);
    return isSrgbName(name) ? "" : "the colour profile " + name;
  }
  if (chunks.contains("sRGB")) return "";
  if (const PngBytes gamma = find("gAMA"); gamma.size() == 4 && !isSrgbGamma(gamma))
    return fmt::format("a gamma of {} (gAMA)", roundedText(wordAt(gamma, 0) / 1e5, 3));
  const PngBytes primaries = find("cHRM");
  if (!primaries.empty() && !areSrgbPrimaries(primaries)) return "other primaries (cHRM)";
  return "";
}

}  // namespace

std::vector<std::string> lostColoursOf(PngBytes bytes) {
  const auto chunks = chunksIn(bytes);
  std::vector<std::string> lost;
  const auto header = chunks.find("IHDR");
  if (header != chunks.end() && header->second.size() > kBitDepth &&
      header->second[kBitDepth] == 16) {
    lost.emplace_back("16 bits a channel, of which 8 are kept");
  }
  const std::string other = otherColours(chunks);
  if (!other.empty())
    lost.push_back(other + ", in place of which sRGB is assumed; convert to it first");
  return lost;
}

}  // namespace rotatebook::image
