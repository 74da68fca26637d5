#include "render/antialias/edge_pixels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rotatebook::render {

EdgePixels::EdgePixels(int width, int height)
    : width_(width),
      height_(height),
      wordsPerRow_((static_cast<std::size_t>(width) + kBits - 1) / kBits),
      words_(wordsPerRow_ * static_cast<std::size_t>(height)),
      numbers_(words_.size()) {}

void EdgePixels::clear() {
  std::ranges::fill(words_, 0U);
}

void EdgePixels::add(int x, int y) {
  if (x < 0 || x >= width_ || y < 0 || y >= height_) return;
  words_[static_cast<std::size_t>(y) * wordsPerRow_ + static_cast<std::size_t>(x / kBits)] |=
      std::uint64_t{1} << (x % kBits);
}

void EdgePixels::addLine(const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
  // Step along the longer axis u: each step then touches at most two pixels along v
  const Eigen::Vector2f line = to - from;
  const bool steep = std::abs(line.y()) > std::abs(line.x());
  const int u = steep ? 1 : 0, v = 1 - u;

  // Clip the line to the picture along u
  float begin = from[u], end = to[u];
  if (begin > end) std::swap(begin, end);
  begin = std::max(begin, 0.0F);
  end = std::min(end, static_cast<float>(steep ? height_ : width_));

  // Add the pixels at both ends of each step
  const float slope = line[u] != 0 ? line[v] / line[u] : 0;
  const auto across = [&](float along) {
    const float position = from[v] + slope * (along - from[u]);
    return static_cast<int>(std::floor(std::clamp(position, -2.0F, static_cast<float>(1 << 20))));
  };
  for (float along = std::floor(begin); along < end; ++along) {
    const int a = across(std::max(along, begin)), b = across(std::min(along + 1, end));
    const int step = static_cast<int>(along);
    for (const int pixel : {a, b}) steep ? add(pixel, step) : add(step, pixel);
  }
}

void EdgePixels::number() {
  count_ = 0;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    numbers_[i] = count_;
    count_ += static_cast<std::size_t>(countOf(words_[i]));
  }
}

}  // namespace rotatebook::render
