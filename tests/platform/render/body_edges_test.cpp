#include "render/antialias/body_edges.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "render/body/mesh_geometry.h"
#include "render/drawing.h"

namespace rotatebook::render {
namespace {

using testing::book;
using testing::kX;
using testing::kY;

constexpr int kWidth = 640, kHeight = 360;

struct Found {
  EdgePixels pixels{kWidth, kHeight};
  std::vector<ScreenTriangle> triangles;
  geometry::PixelRect bounds;

  explicit Found(const body::Cage& corners) {
    const geometry::Projection projection =
        geometry::project({{0, 0, 0.76}, {0, 0, 0}, {0, 1, 0}, 30}, corners, {kWidth, kHeight});
    bounds = projection.bounds;
    BodyEdges(geometry::makeBookMesh())
        .find(corners, projection.clipFromWorld, frontFaceWinding(corners), {}, pixels, triangles);
    pixels.number();
  }

  int countIn(const geometry::PixelRect& area) const {
    int count = 0;
    for (int y = area.y; y < area.y + area.height; ++y) {
      pixels.forEach(y, area.x, area.x + area.width, [&](int, std::size_t) { ++count; });
    }
    return count;
  }
};

TEST(BodyEdges, GoRoundTheBookAndNotThroughItsCover) {
  const Found found(book());
  const geometry::PixelRect& all = found.bounds;
  EXPECT_EQ(found.countIn({all.x + all.width / 3, all.y + all.height / 3, 20, 20}), 0);
  for (const int y : {all.y, all.y + all.height - 12}) {
    EXPECT_GE(found.countIn({all.x + all.width / 2, y, 30, 12}), 30) << "at row " << y;
  }
  EXPECT_GE(found.countIn({all.x + all.width - 12, all.y + all.height / 2, 12, 30}), 30);
}

TEST(BodyEdges, AreFew) {
  const Found found(book({{-35, kY}, {20, kX}}));
  const int share = 100 * static_cast<int>(found.pixels.count()) / (kWidth * kHeight);
  EXPECT_LE(share, 4);  // measured 2 %
  EXPECT_GE(found.pixels.count(), 1000U);
}

TEST(BodyEdges, LeaveOutBackFaces) {
  const geometry::Mesh mesh = geometry::makeBookMesh();
  std::size_t all = 0;
  for (const geometry::MeshPart& part : mesh.parts) all += part.triangles.size() / 3;
  body::Cage pierced = book();  // A corner of the cover has gone through the book.
  pierced(2, 7) -= 0.2;
  const Found usual(book()), open(pierced);
  EXPECT_LT(usual.triangles.size(), all / 2);
  for (const ScreenTriangle& triangle : usual.triangles) {
    const auto& [a, b, c] = triangle.corners;
    EXPECT_LE((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x(), 0);
  }
  ASSERT_EQ(frontFaceWinding(pierced), 0);
  EXPECT_EQ(open.triangles.size(), all);
}

TEST(BodyEdges, LeaveOutWhatReachesBehindTheCamera) {
  body::Cage corners = book();
  corners.rightCols<4>().row(2).array() += 2;  // The front cover.
  const Found found(corners);
  EXPECT_LT(found.triangles.size(), 2000U);
  for (const ScreenTriangle& triangle : found.triangles) {
    for (const auto& corner : triangle.corners) EXPECT_TRUE(corner.allFinite());
  }
}

}  // namespace
}  // namespace rotatebook::render
