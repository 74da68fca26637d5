// Files as trees of their boxes or elements, to change.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rotatebook::video::testing {

/// A file, or a box of an MP4, or an element of a WebM.
struct PartTree {
  std::string id;                 ///< "moov", or an element's number in its bytes.
  std::string head{};             ///< Its content before the parts in it.
  std::vector<PartTree> parts{};  ///< The parts in it.
  std::size_t lengthBytes = 8;    ///< Of a WebM: those that state its length.

  /// Returns the part at `path`, of each id the first: "moov/trak/tkhd"; elements' numbers in
  /// hexadecimal digits. Throws std::runtime_error if there is none.
  PartTree& at(const std::string& path);
};

PartTree treeOfMp4(const std::string& content);
PartTree treeOfWebm(const std::string& content);

/// Returns the file again, with the positions of its samples as they are in it.
std::string mp4Of(PartTree tree);
/// Returns the file again; positions in it are those of the file that was read.
std::string webmOf(const PartTree& tree);

/// Returns the bytes of hexadecimal digits.
std::string bytesOfHex(const std::string& digits);

}  // namespace rotatebook::video::testing
