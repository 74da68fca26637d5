#include "render/antialias/surface_colours.h"

#include <vector>

#include "image/linear_accumulator.h"

namespace rotatebook::render {
namespace {

constexpr std::uint32_t kMaxPixelsOfMean = 256;  // LinearAccumulator's limit.

/// Returns the steps from a pixel to itself and its neighbours, the nearest first.
const std::vector<std::array<int, 2>>& neighbourSteps() {
  static const std::vector<std::array<int, 2>> steps = [] {
    constexpr int kReach = 4;
    std::vector<std::array<int, 2>> all;
    for (int y = -kReach; y <= kReach; ++y) {
      for (int x = -kReach; x <= kReach; ++x) all.push_back({x, y});
    }
    std::ranges::stable_sort(all, {}, [](const auto& s) { return s[0] * s[0] + s[1] * s[1]; });
    return all;
  }();
  return steps;
}

/// The mean of up to kMaxPixelsOfMean colours, the first ones. Alpha isn't part of a colour.
class ColourMean {
 public:
  void add(const std::uint8_t* pixel) {
    if (count_ == kMaxPixelsOfMean) return;
    const std::array<std::uint8_t, 4> opaque{pixel[0], pixel[1], pixel[2], 255};
    sum_.add(opaque.data(), 1);
    ++count_;
  }

  /// Sets `colour` if there is any.
  void get(std::array<std::uint8_t, 4>& colour) const {
    if (count_ > 0) sum_.mean(count_, colour.data());
  }

 private:
  image::LinearAccumulator sum_;
  std::uint32_t count_ = 0;
};

}  // namespace

AlikeSurfaces alikeSurfacesOf(const geometry::Mesh& mesh) {
  AlikeSurfaces parts{};
  std::vector<std::uint8_t> firsts(mesh.parts.size());  // A surface of each part.
  for (const geometry::MeshPart& part : mesh.parts) {
    for (std::size_t i = 2; i < part.triangles.size(); i += 3) {
      const auto surface = static_cast<std::uint8_t>(mesh.vertices[part.triangles[i]].surfaceId);
      std::uint8_t &first = firsts[part.alike], &known = parts[surface];
      if (first == 0) first = surface;
      if (known == 0) known = first;
    }
  }
  return parts;
}

const std::uint8_t* SurfaceColours::at(int x, int y, std::uint8_t surface) {
  for (const auto& [dx, dy] : neighbourSteps()) {
    if (surfaceAt(x + dx, y + dy) == surface) return pixelAt(x + dx, y + dy);
  }
  if (!hasMeans_) computeMeans();
  return means_[surface][3] > 0 ? means_[surface].data() : ofAnother(x, y, surface);
}

const std::uint8_t* SurfaceColours::ofAnother(int x, int y, std::uint8_t surface) const {
  const Colour& ofPart = alikeMeans_[alike_[surface]];
  if (alike_[surface] != 0 && ofPart[3] > 0) return ofPart.data();
  for (const auto& [dx, dy] : neighbourSteps()) {
    if (surfaceAt(x + dx, y + dy) != 0) return pixelAt(x + dx, y + dy);
  }
  return alikeMeans_[0][3] > 0 ? alikeMeans_[0].data() : nullptr;
}

void SurfaceColours::computeMeans() {
  std::array<ColourMean, kHighest + 1> means, alikeMeans;
  for (int y = 0; y < pixels_.height(); ++y) {
    pixels_.forEach(y, 0, pixels_.width(),
                    [&](int x, std::size_t) { means[surfaceAt(x, y)].add(pixelAt(x, y)); });
  }
  for (std::size_t i = 1; i < means_.size(); ++i) {
    means[i].get(means_[i]);
    if (means_[i][3] == 0) continue;
    if (alike_[i] != 0) alikeMeans[alike_[i]].add(means_[i].data());
    alikeMeans[0].add(means_[i].data());
  }
  for (std::size_t i = 0; i < alikeMeans_.size(); ++i) alikeMeans[i].get(alikeMeans_[i]);
  hasMeans_ = true;
}

}  // namespace rotatebook::render
