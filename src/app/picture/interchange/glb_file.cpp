#include "picture/interchange/glb_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <utility>

namespace rotatebook::interchange {
namespace {

static_assert(std::endian::native == std::endian::little, "the numbers of glTF are so");

// Numbers that glTF 2.0 has for types and uses of binary data.
constexpr int kUnsigned8 = 5121, kUnsigned16 = 5123, kUnsigned32 = 5125, kFloat32 = 5126;
constexpr int kNoTarget = 0, kVertices = 34962, kCorners = 34963;

constexpr std::size_t kAlignment = 4;
constexpr std::size_t kMostSmall = 65'535;  // Numbers in 16 bits; 65,535 would restart a strip.

void align(std::string& bytes, char filler) {
  bytes.resize((bytes.size() + kAlignment - 1) / kAlignment * kAlignment, filler);
}

template <typename Number>
std::string_view bytesOf(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), sizeof(Number) * numbers.size()};
}

void append32(std::string& bytes, std::size_t number) {
  const auto value = static_cast<std::uint32_t>(number);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Returns the least, or by `order` another, of each column. There is a row or more.
template <typename Order>
Json firstOf(const std::vector<float>& numbers, std::size_t columns, const Order& order) {
  std::vector<float> first(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(columns));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    first[i % columns] = std::min(first[i % columns], numbers[i], order);
  return first;
}

}  // namespace

GlbFile::GlbFile(Json asset) {
  json_["asset"] = std::move(asset);
}

std::size_t GlbFile::add(const char* list, Json object) {
  json_[list].push_back(std::move(object));
  return json_[list].size() - 1;
}

std::size_t GlbFile::addView(std::string_view bytes, int target) {
  align(binary_, '\0');
  Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (target != kNoTarget) view["target"] = target;
  binary_ += bytes;
  return add("bufferViews", std::move(view));
}

std::size_t GlbFile::addFloats(const std::vector<float>& numbers, std::size_t columns,
                               Numbers use) {
  constexpr std::array<const char*, 5> kTypes{"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  const bool areKeys = use == Numbers::OfKeys || columns == 1;
  Json accessor{{"bufferView", addView(bytesOf(numbers), areKeys ? kNoTarget : kVertices)},
                {"componentType", kFloat32},
                {"count", numbers.size() / columns},
                {"type", kTypes.at(columns)}};
  if (use == Numbers::Ranged) {
    accessor["min"] = firstOf(numbers, columns, std::less<>());
    accessor["max"] = firstOf(numbers, columns, std::greater<>());
  }
  return add("accessors", std::move(accessor));
}

std::array<std::size_t, 3> GlbFile::addAlongAxes(const std::vector<float>& numbers) {
  constexpr std::size_t kColumns = 3, kRow = kColumns * sizeof(float);
  // 0 0 x 0 0 x 0 0 ... x 0 0: rows that begin with the third number are along x, with the second
  // along y, with the first along z
  std::vector<float> all(kColumns * numbers.size() + 2, 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) all[kColumns * i + 2] = numbers[i];
  const std::size_t view = addView(bytesOf(all), kVertices);
  json_["bufferViews"][view]["byteStride"] = kRow;
  const auto [least, most] = std::ranges::minmax(numbers);
  std::array<std::size_t, 3> accessors{};
  for (std::size_t axis = 0; axis < kColumns; ++axis) {
    std::array<float, 3> low{}, high{};
    low.at(axis) = least;
    high.at(axis) = most;
    accessors.at(axis) = add("accessors", {{"bufferView", view},
                                           {"byteOffset", sizeof(float) * (2 - axis)},
                                           {"componentType", kFloat32},
                                           {"count", numbers.size()},
                                           {"type", "VEC3"},
                                           {"min", low},
                                           {"max", high}});
  }
  return accessors;
}

std::size_t GlbFile::addSparse(const std::vector<std::uint32_t>& places,
                               const std::vector<float>& values, std::size_t rows) {
  Json accessor{{"componentType", kFloat32}, {"count", rows}, {"type", "VEC3"}};
  if (!places.empty()) {
    const std::vector<std::uint16_t> small(places.begin(), places.end());
    const bool isSmall = rows <= kMostSmall;
    accessor["sparse"] = {
        {"count", places.size()},
        {"indices",
         {{"bufferView", addView(isSmall ? bytesOf(small) : bytesOf(places), kNoTarget)},
          {"componentType", isSmall ? kUnsigned16 : kUnsigned32}}},
        {"values", {{"bufferView", addView(bytesOf(values), kNoTarget)}}}};
  }
  return add("accessors", std::move(accessor));
}

std::size_t GlbFile::addBytes(const std::array<std::uint8_t, 4>& row, std::size_t rows,
                              bool normalised) {
  std::vector<std::array<std::uint8_t, 4>> all(rows, row);
  Json accessor{{"bufferView", addView(bytesOf(all), kVertices)},
                {"componentType", kUnsigned8},
                {"count", rows},
                {"type", "VEC4"}};
  if (normalised) accessor["normalized"] = true;
  return add("accessors", std::move(accessor));
}

std::size_t GlbFile::addCorners(const std::vector<std::uint32_t>& corners, std::size_t vertices) {
  const std::vector<std::uint16_t> small(corners.begin(), corners.end());
  const bool isSmall = vertices <= kMostSmall;
  return add("accessors",
             {{"bufferView", addView(isSmall ? bytesOf(small) : bytesOf(corners), kCorners)},
              {"componentType", isSmall ? kUnsigned16 : kUnsigned32},
              {"count", corners.size()},
              {"type", "SCALAR"}});
}

std::size_t GlbFile::addPicture(std::string_view bytes) {
  const bool isPng = bytes.starts_with("\x89PNG");
  return add("images", {{"bufferView", addView(bytes, kNoTarget)},
                        {"mimeType", isPng ? "image/png" : "image/jpeg"}});
}

std::string GlbFile::bytes() const {
  Json json = json_;
  std::string binary = binary_;
  align(binary, '\0');
  json["buffers"] = Json::array({{{"byteLength", binary.size()}}});
  std::string text = jsonText(json);
  align(text, ' ');
  // GLB's header of 12 bytes, then both chunks, each after its length and its name
  constexpr std::size_t kHeader = 12, kChunk = 8, kVersion = 2;
  std::string bytes = "glTF";
  append32(bytes, kVersion);
  append32(bytes, kHeader + kChunk + text.size() + kChunk + binary.size());
  append32(bytes, text.size());
  bytes += "JSON" + text;
  append32(bytes, binary.size());
  bytes.append("BIN\0", 4);
  return bytes + binary;
}

}  // namespace rotatebook::interchange
