#include "render/book_mesh.h"

#include <span>
#include <utility>

#include <Eigen/Geometry>

namespace rotatebook::render {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// Shares of the paper's book, 0.188 x 0.291 x 0.05 m: boards of 3 mm, pages inset 3.5 mm at the
// fore edge and 4 mm at head and foot.
constexpr float kBoardThickness = 0.06F;   // of the thickness
constexpr float kSpineThickness = 0.016F;  // of the width
constexpr float kForeEdgeInset = 0.019F;   // of the width
constexpr float kHeadInset = 0.014F;       // of the height

constexpr float kInsideOpenness = 0.45F;  // Where boards and pages meet.
constexpr float kCoverRim =
    0.004F;  // Texture coordinate from which edges and insides take the cloth.
constexpr float kLeavesPerThickness = 1;  // Repeats of the paper texture across the page block.
constexpr float kLeavesPerLength = 4;     // And along it.

// Enough that a face whose corners leave their plane shows no crease, few enough to be quick.
constexpr std::array kEven = {0.0F, 0.25F, 0.5F, 0.75F, 1.0F};
constexpr std::array kEnds = {0.0F, 1.0F};
constexpr std::array kShadedEnds = {0.0F, 0.1F, 0.9F, 1.0F};

/// A flat rectangle in the unit cube: origin + s * across + t * along, s and t from 0 to 1.
struct Face {
  Vector3f origin;
  Vector3f across;
  Vector3f along;
  Vector3f normal;
};

/// A box by its lowest and highest corner.
struct Box {
  Vector3f low;
  Vector3f high;
};

/// Where on a texture a face lies: origin + s * across + t * along.
struct TexturePatch {
  Vector2f origin{0.5F, kCoverRim};
  Vector2f across{0, 0};
  Vector2f along{0, 0};
};

class MeshBuilder {
 public:
  /// Adds `face` as a grid; `acrossStops` shaded at both ends if `shadeEnds`.
  void addFace(BookPart part, const Face& face, const TexturePatch& patch,
               std::span<const float> acrossStops, std::span<const float> alongStops,
               float openness) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    const bool shadeEnds = acrossStops.size() == kShadedEnds.size();
    for (const float t : alongStops) {
      for (const float s : acrossStops) {
        const bool atEnd = shadeEnds && (s == 0 || s == 1);
        mesh_.vertices.push_back({face.origin + s * face.across + t * face.along, face.normal,
                                  patch.origin + s * patch.across + t * patch.along,
                                  atEnd ? kInsideOpenness : openness});
      }
    }
    addTriangles(part, first, static_cast<std::uint32_t>(acrossStops.size()),
                 static_cast<std::uint32_t>(alongStops.size()),
                 face.across.cross(face.along).dot(face.normal) < 0);
  }

  BookMesh take() { return std::move(mesh_); }

 private:
  /// Counter-clockwise as seen from outside; `flipped` where across x along points inward.
  void addTriangles(BookPart part, std::uint32_t first, std::uint32_t columns, std::uint32_t rows,
                    bool flipped) {
    auto& triangles = mesh_.triangles[static_cast<std::size_t>(part)];
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
      for (std::uint32_t column = 0; column + 1 < columns; ++column) {
        const std::uint32_t a = first + row * columns + column;
        const std::uint32_t b = a + columns;
        const std::uint32_t c = flipped ? b : a + 1, d = flipped ? a + 1 : b;
        triangles.insert(triangles.end(), {a, c, d, d, c, b + 1});
      }
    }
  }

  BookMesh mesh_;
};

/// The side of `box` whose outward normal is `sign` along `axis`.
Face sideOf(const Box& box, int axis, int sign) {
  const int acrossAxis = axis == 0 ? 2 : 0;
  const int alongAxis = axis == 1 ? 2 : 1;
  const Vector3f extent = box.high - box.low;
  Face face{box.low, Vector3f::Zero(), Vector3f::Zero(), Vector3f::Zero()};
  if (sign > 0) face.origin[axis] = box.high[axis];
  face.across[acrossAxis] = extent[acrossAxis];
  face.along[alongAxis] = extent[alongAxis];
  face.normal[axis] = static_cast<float>(sign);
  return face;
}

/// A board's narrow side.
void addEdge(MeshBuilder& builder, BookPart part, const Face& face) {
  const bool wide = face.across.norm() > face.along.norm();
  builder.addFace(part, face, {}, wide ? std::span<const float>(kEven) : kEnds,
                  wide ? std::span<const float>(kEnds) : kEven, 1);
}

/// A cover board: its outside carries the whole picture, edges and inside the cloth at the
/// picture's rim. Toward the spine it has no edge, the spine's outside lies there.
void addCover(MeshBuilder& builder, BookPart part, const Box& box, int sign,
              const TexturePatch& picture) {
  builder.addFace(part, sideOf(box, 2, sign), picture, kEven, kEven, 1);
  builder.addFace(part, sideOf(box, 2, -sign), {}, kEnds, kEnds, kInsideOpenness);
  addEdge(builder, part, sideOf(box, 0, 1));
  addEdge(builder, part, sideOf(box, 1, -1));
  addEdge(builder, part, sideOf(box, 1, 1));
}

/// The spine, with edges only between the covers: no two faces may share a place, where which one
/// shows would be up to rounding.
void addSpine(MeshBuilder& builder, const TexturePatch& picture) {
  const Box whole{{0, 0, 0}, {kSpineThickness, 1, 1}};
  const Box between{{0, 0, kBoardThickness}, {kSpineThickness, 1, 1 - kBoardThickness}};
  builder.addFace(BookPart::Spine, sideOf(whole, 0, -1), picture, kEven, kEven, 1);
  builder.addFace(BookPart::Spine, sideOf(between, 0, 1), {}, kEnds, kEnds, kInsideOpenness);
  addEdge(builder, BookPart::Spine, sideOf(between, 1, -1));
  addEdge(builder, BookPart::Spine, sideOf(between, 1, 1));
}

/// One of the three open sides of the page block.
void addPageSide(MeshBuilder& builder, const Box& box, int axis, int sign) {
  const Face face = sideOf(box, axis, sign);
  const bool foreEdge = axis == 0;
  TexturePatch patch{{0, 0}, {0, kLeavesPerThickness}, {kLeavesPerLength, 0}};
  if (!foreEdge) patch = {{0, 0}, {kLeavesPerLength, 0}, {0, kLeavesPerThickness}};
  if (foreEdge) {
    builder.addFace(BookPart::Pages, face, patch, kShadedEnds, kEven, 1);
    return;
  }
  // Across must be the direction between the boards, whose ends are shaded.
  const Face turned{face.origin, face.along, face.across, face.normal};
  const TexturePatch turnedPatch{patch.origin, patch.along, patch.across};
  builder.addFace(BookPart::Pages, turned, turnedPatch, kShadedEnds, kEven, 1);
}

void addPageBlock(MeshBuilder& builder) {
  const Box pages{{kSpineThickness, kHeadInset, kBoardThickness},
                  {1 - kForeEdgeInset, 1 - kHeadInset, 1 - kBoardThickness}};
  addPageSide(builder, pages, 0, 1);
  addPageSide(builder, pages, 1, 1);
  addPageSide(builder, pages, 1, -1);
}

}  // namespace

BookMesh makeBookMesh() {
  MeshBuilder builder;
  const Box front{{0, 0, 1 - kBoardThickness}, {1, 1, 1}};
  const Box back{{0, 0, 0}, {1, 1, kBoardThickness}};
  addCover(builder, BookPart::Front, front, 1, {{0, 0}, {1, 0}, {0, 1}});
  // Seen from behind the spine is on the right, seen from the spine the front cover is.
  addCover(builder, BookPart::Back, back, -1, {{1, 0}, {-1, 0}, {0, 1}});
  addSpine(builder, {{0, 0}, {1, 0}, {0, 1}});
  addPageBlock(builder);
  return builder.take();
}

}  // namespace rotatebook::render
