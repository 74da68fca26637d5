#include "video/part_tree.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>

#include "video/decoded_video.h"

namespace rotatebook::video::testing {
namespace {

/// Boxes with others in them, after so many bytes.
const std::map<std::string, std::size_t> kOuterBoxes{
    {"moov", 0}, {"trak", 0}, {"edts", 0}, {"mdia", 0},    {"minf", 0},
    {"dinf", 0}, {"dref", 8}, {"stbl", 0}, {"stsd", 8},    {"avc1", 78},
    {"udta", 0}, {"meta", 4}, {"ilst", 0}, {"\251nam", 0}, {"\251cmt", 0}};

/// Elements with others in them.
const std::set<std::string> kOuterElements{
    "1a45dfa3", "18538067", "114d9b74", "4dbb",     "1549a966", "1654ae6b", "ae",
    "e0",       "55b0",     "1254c367", "7373",     "63c0",     "67c8",     "1f43b675",
    "a0",       "75a1",     "a6",       "1c53bb6b", "bb",       "b7"};

std::string hexOf(const std::string& bytes) {
  std::string digits;
  for (const char byte : bytes) {
    for (const int shift : {4, 0}) digits += "0123456789abcdef"[byte >> shift & 0xf];
  }
  return digits;
}

std::string numberOf(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = count; i-- > 0;) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

std::vector<PartTree> boxTrees(const std::string& content) {
  std::vector<PartTree> trees;
  for (const Box& box : boxesIn(content)) {
    const auto outer = kOuterBoxes.find(box.type);
    const bool isOuter = outer != kOuterBoxes.end();
    PartTree tree{box.type, isOuter ? box.content.substr(0, outer->second) : box.content};
    if (isOuter) tree.parts = boxTrees(box.content.substr(outer->second));
    trees.push_back(tree);
  }
  return trees;
}

std::string boxOf(const PartTree& tree) {
  std::string content = tree.head;
  for (const PartTree& part : tree.parts) content += boxOf(part);
  return tree.id.empty() ? content : numberOf(content.size() + 8, 4) + tree.id + content;
}

/// Takes an element's number or length, of which it keeps the marker or not.
std::string takeNumber(const std::string& content, std::size_t& at, bool marked) {
  const auto first = static_cast<std::uint8_t>(content.at(at));
  const auto count = static_cast<std::size_t>(std::countl_zero(first)) + 1;
  std::string bytes = content.substr(at, count);
  at += count;
  if (!marked) bytes[0] = static_cast<char>(first & (0xff >> count));
  return bytes;
}

std::vector<PartTree> elementTrees(const std::string& content) {
  std::vector<PartTree> trees;
  for (std::size_t at = 0; at < content.size();) {
    PartTree tree{takeNumber(content, at, true)};
    const std::string length = takeNumber(content, at, false);
    std::uint64_t size = 0;
    for (const char byte : length) size = size << 8 | static_cast<std::uint8_t>(byte);
    tree.lengthBytes = length.size();
    const std::string inner = content.substr(at, size);
    at += size;
    if (kOuterElements.contains(hexOf(tree.id))) {
      tree.parts = elementTrees(inner);
    } else {
      tree.head = inner;
    }
    trees.push_back(tree);
  }
  return trees;
}

}  // namespace

PartTree& PartTree::at(const std::string& path) {
  const std::size_t length = std::min(path.find('/'), path.size());
  const std::string wanted = path.substr(0, length);
  for (PartTree& part : parts) {
    if (part.id != wanted && hexOf(part.id) != wanted) continue;
    return length == path.size() ? part : part.at(path.substr(length + 1));
  }
  throw std::runtime_error("no part " + path);
}

PartTree treeOfMp4(const std::string& content) {
  return {.id = "", .parts = boxTrees(content)};
}

PartTree treeOfWebm(const std::string& content) {
  return {.id = "", .parts = elementTrees(content)};
}

std::string mp4Of(PartTree tree) {
  // All samples are in one chunk here.
  const std::size_t begin = boxOf(tree).find("mdat") + 4;
  std::string& chunks = tree.at("moov/trak/mdia/minf/stbl/stco").head;
  chunks = chunks.substr(0, 8) + numberOf(begin, 4);
  return boxOf(tree);
}

std::string webmOf(const PartTree& tree) {
  std::string content = tree.head;
  for (const PartTree& part : tree.parts) content += webmOf(part);
  if (tree.id.empty()) return content;
  const std::uint64_t marker = std::uint64_t{1} << (7 * tree.lengthBytes);
  const std::size_t count = content.size() < marker - 1 ? tree.lengthBytes : 8;
  return tree.id + numberOf(content.size() | std::uint64_t{1} << (7 * count), count) + content;
}

std::string bytesOfHex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

}  // namespace rotatebook::video::testing
