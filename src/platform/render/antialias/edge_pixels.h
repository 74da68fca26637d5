// The pixels that edges pass through. Inside the room only.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace rotatebook::render {

/// A set of a picture's pixels, numbered row by row.
class EdgePixels {
 public:
  EdgePixels(int width, int height);

  void clear();
  /// Adds a pixel, unless it is outside the picture.
  void add(int x, int y);
  /// Adds all pixels that the line touches. `from`, `to`: [pixels]
  void addLine(const Eigen::Vector2f& from, const Eigen::Vector2f& to);
  /// Numbers the pixels. Call it after the last of them is added, before count() and forEach().
  void number();

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t count() const { return count_; }

  /// Calls each(x, number) for the set's pixels in row `y` from `left` to below `right`, all within
  /// the picture. Inlined, so that it is compiled for the processor that its caller is for.
  template <typename Each>
  [[gnu::always_inline]] void forEach(int y, int left, int right, const Each& each) const {
    if (left >= right) return;
    const std::size_t row = static_cast<std::size_t>(y) * wordsPerRow_;
    for (int word = left / kBits; word <= (right - 1) / kBits; ++word) {
      const std::uint64_t all = words_[row + static_cast<std::size_t>(word)];
      const int first = word * kBits;
      std::uint64_t bits = all;
      if (left > first) bits &= ~std::uint64_t{0} << (left - first);
      if (right < first + kBits) bits &= ~(~std::uint64_t{0} << (right - first));
      if (bits == 0) continue;
      const std::uint64_t before = all & ((bits & -bits) - 1);
      std::size_t number = numbers_[row + static_cast<std::size_t>(word)] +
                           static_cast<std::size_t>(countOf(before));
      for (; bits != 0; bits &= bits - 1) each(first + std::countr_zero(bits), number++);
    }
  }

 private:
  static constexpr int kBits = 64;

  /// Returns the number of bits set: std::popcount() is a function call where the processor may
  /// lack the instruction.
  static constexpr std::uint64_t countOf(std::uint64_t bits) {
    bits -= bits >> 1 & 0x5555555555555555U;
    bits = (bits & 0x3333333333333333U) + (bits >> 2 & 0x3333333333333333U);
    bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fU;
    return bits * 0x0101010101010101U >> 56;
  }

  int width_, height_;
  std::size_t wordsPerRow_, count_ = 0;
  std::vector<std::uint64_t> words_;  // One bit per pixel, lowest first.
  std::vector<std::size_t> numbers_;  // The number of each word's first pixel.
};

}  // namespace rotatebook::render
