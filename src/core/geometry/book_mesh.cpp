#include "geometry/book_mesh.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "geometry/book_light.h"
#include "geometry/book_profile.h"
#include "geometry/mesh_steps.h"

namespace rotatebook::geometry {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr BookDimensions kBook;
constexpr float kRim = 0.004F;               // Texture coordinate whose cloth the inner sides show.
constexpr float kHollow = 3;                 // Depth of the fore edge's inward curve. [mm]
constexpr float kLeavesPerThickness = 0.5F;  // Repeats of the paper texture across the page block.
constexpr float kLeavesPerHeight = 4;        // Repeats along it, per height of the book.

/// Kinds of surfaces of a part of the case. A rounding only a pixel or two wide looks like a line
/// with a colour of its own. The shoulder, from the hinge's groove to the spine, can hide the board
/// beyond the groove, or be hidden by it.
enum class Kind { Outer, Shoulder, Rounding, Rim, Inner };

constexpr int kCaseParts = 3;
constexpr int kForeEdge = 16, kFoot = 17, kHead = 18;

/// Returns the MeshVertex::surfaceId.
int surfaceIdOf(BookPart part, Kind kind) {
  return 1 + kCaseParts * static_cast<int>(kind) + static_cast<int>(part);
}

/// A point of a side, not yet scaled to the unit cube.
struct SidePoint {
  Vector3f position;  // [mm]
  Vector3f normal;    // Of unit length.
  Vector2f texCoord{0, 0};
  Outlook outlook{};
  bool againstLeaves = false;
};

/// A row of the outer side's points along y: of the flat part, or of a rounding at the foot or the
/// head.
struct Station {
  float y;      // [mm]
  float inset;  // How far inward the points lie. [mm]
  float lean;   // The normals' component along y, -1 at the foot to 1 at the head.
};

std::vector<Station> outerStations(const MeshSteps& steps) {
  const float r = kBook.edgeRadius;
  std::vector<Station> half;
  for (int i = 0; i <= steps.rounding; ++i) {
    const float angle = std::numbers::pi_v<float> / 2 *
                        (1 - static_cast<float>(i) / static_cast<float>(steps.rounding));
    half.push_back({r * (1 - sineOf(angle)), r * (1 - cosineOf(angle)), -sineOf(angle)});
  }
  half.push_back({kBook.headInset, 0, 0});
  std::vector<Station> all = half;
  for (int i = 1; i < steps.flat; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps.flat);
    all.push_back({r + (kBook.height - 2 * r) * share, 0, 0});
  }
  for (auto station = half.rbegin(); station != half.rend(); ++station) {
    all.push_back({kBook.height - station->y, station->inset, -station->lean});
  }
  return all;
}

/// The strip that a square belongs to: none, or the one along a row or a column of its grid.
/// Squares beside that line may be narrower parts of the strip.
struct GridLine {
  enum class Direction { None, Row, Column } direction = Direction::None;
  int number = 0;

  friend auto operator<=>(const GridLine&, const GridLine&) = default;
};

constexpr GridLine kNoLine{};
constexpr GridLine row(int i) {
  return {GridLine::Direction::Row, i};
}
constexpr GridLine column(int j) {
  return {GridLine::Direction::Column, j};
}

SidePoint midpoint(const SidePoint& a, const SidePoint& b) {
  return {(a.position + b.position) / 2,
          (a.normal + b.normal).normalized(),
          (a.texCoord + b.texCoord) / 2,
          {(a.outlook.skyVisibility + b.outlook.skyVisibility) / 2,
           (a.outlook.away + b.outlook.away) / 2}};
}

MeshVertex vertexOf(const SidePoint& point, int surfaceId) {
  const Vector3f size(kBook.width, kBook.height, kBook.thickness);
  const Vector3f& away = point.outlook.away;
  return {point.position.cwiseQuotient(size),
          point.normal.cwiseProduct(size).normalized(),
          point.texCoord,
          point.outlook.skyVisibility,
          static_cast<float>(surfaceId),
          away.norm() * away.cwiseProduct(size).normalized()};
}

class MeshBuilder {
 public:
  MeshBuilder() {
    mesh_.parts.resize(kBookPartCount);
    for (std::size_t i = 0; i < kBookPartCount; ++i) mesh_.parts[i].alike = i;
    mesh_.parts[static_cast<std::size_t>(BookPart::Lining)].hidden = true;
  }

  /// Adds the grid of points at(i, j), i < rows, j < columns. Its front face is the one from which
  /// the turn from the direction of j to that of i is counter-clockwise; `flipped`: the other one.
  /// surfaceId(i, j) and line(i, j) describe the square whose first point is (i, j).
  void addGrid(BookPart part, int rows, int columns, bool flipped,
               const std::function<SidePoint(int, int)>& at,
               const std::function<int(int, int)>& surfaceId,
               const std::function<GridLine(int, int)>& line) {
    std::map<std::array<int, 3>, std::uint32_t> known;
    std::map<GridLine, std::uint8_t> strips{{kNoLine, kNoStrip}};
    for (int i = 0; i + 1 < rows; ++i) {
      for (int j = 0; j + 1 < columns; ++j) {
        // Share the vertices of neighbouring squares of one surface
        const int id = surfaceId(i, j);
        const auto vertex = [&](int row, int column) {
          const auto [found, isNew] = known.try_emplace({row, column, id}, nextVertex());
          if (isNew) addVertex(at(row, column), id);
          return found->second;
        };
        const auto a = vertex(i, j), b = vertex(i, j + 1), c = vertex(i + 1, j);
        const auto d = vertex(i + 1, j + 1);

        // Extend the square's strip, if it lies on the strip's line
        const auto [found, isNew] = strips.try_emplace(line(i, j), nextStrip());
        const std::uint8_t strip = found->second;
        if (isNew) mesh_.strips.push_back({static_cast<std::size_t>(part), 0, true, {}, {}});
        if (line(i, j) == row(i)) {
          extend(strip, {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}, flipped, id);
        } else if (line(i, j) == column(j)) {
          extend(strip, {at(i, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)}, flipped, id);
        }

        addTriangle(part, strip, a, flipped ? c : b, flipped ? b : c);
        addTriangle(part, strip, c, flipped ? d : b, flipped ? b : d);
      }
    }
  }

  Mesh take() { return std::move(mesh_); }

 private:
  std::uint32_t nextVertex() const { return static_cast<std::uint32_t>(mesh_.vertices.size()); }

  void addVertex(const SidePoint& point, int surfaceId) {
    mesh_.vertices.push_back(vertexOf(point, surfaceId));
    againstLeaves_.push_back(point.againstLeaves);
  }

  std::uint8_t nextStrip() const { return static_cast<std::uint8_t>(mesh_.strips.size()); }

  /// Appends a square to a strip that is empty or ends at the square's first two corners; it then
  /// ends at the other two.
  void extend(std::uint8_t number, const std::array<SidePoint, 4>& corners, bool flipped,
              int surfaceId) {
    MeshStrip& strip = mesh_.strips[number];
    for (const std::size_t i : {0, 2}) {
      if (i == 0 && !strip.middle.empty()) continue;
      const SidePoint middle = midpoint(corners[i], corners[i + 1]);
      if (i == 2) {
        strip.length +=
            (middle.position - midpoint(corners[0], corners[1]).position).norm() / kBook.height;
      }
      strip.middle.push_back(vertexOf(middle, surfaceId));
      strip.flat = strip.flat && corners[i].normal == corners[i + 1].normal;
      strip.sides[flipped ? 1 : 0].push_back(vertexOf(corners[i], surfaceId).position);
      strip.sides[flipped ? 0 : 1].push_back(vertexOf(corners[i + 1], surfaceId).position);
    }
  }

  /// Adds a triangle, unless two of its corners coincide but for rounding.
  void addTriangle(BookPart part, std::uint8_t strip, std::uint32_t a, std::uint32_t b,
                   std::uint32_t c) {
    constexpr float kRounding = 1e-6F;
    const auto distance = [&](std::uint32_t i, std::uint32_t j) {
      return (mesh_.vertices[i].position - mesh_.vertices[j].position).norm();
    };
    if (std::min({distance(a, b), distance(b, c), distance(c, a)}) < kRounding) return;
    if (againstLeaves_[a] && againstLeaves_[b] && againstLeaves_[c]) part = BookPart::Lining;
    MeshPart& added = mesh_.parts[static_cast<std::size_t>(part)];
    added.triangles.insert(added.triangles.end(), {a, b, c});
    added.stripOf.push_back(strip);
  }

  Mesh mesh_;
  std::vector<bool> againstLeaves_;  // By vertex.
};

/// Returns the texture coordinate u of a point (x, z) of the cross-section.
float texCoordU(BookPart part, const Vector2f& point) {
  const float u = part == BookPart::Spine ? point.y() / kBook.thickness : point.x() / kBook.width;
  return part == BookPart::Back ? 1 - u : u;
}

int sizeOf(const std::vector<ProfilePoint>& profile) {
  return static_cast<int>(profile.size());
}

template <typename Value>
std::function<Value(int, int)> always(Value value) {
  return [value](int, int) { return value; };
}

/// Adds y to a point or vector (x, z) of the cross-section.
Vector3f inSpace(const Vector2f& xz, float y) {
  return {xz.x(), y, xz.y()};
}

/// Returns the kind of the outer side's square between two profile points and two stations.
Kind outerKind(const ProfilePoint& point, const ProfilePoint& next, const Station& station,
               const Station& following) {
  if (station.lean != following.lean) return Kind::Rounding;
  const float middle = (point.outside.x() + next.outside.x()) / 2;
  if (middle < kBook.hinge) return Kind::Shoulder;
  const float atForeEdge = kBook.width - 1.001F * kBook.edgeRadius;
  if (std::min(point.outside.x(), next.outside.x()) < atForeEdge) return Kind::Outer;
  return point.normal == next.normal ? Kind::Rim : Kind::Rounding;
}

void addOuterSide(MeshBuilder& builder, BookPart part, const std::vector<ProfilePoint>& profile,
                  const MeshSteps& steps) {
  const std::vector<Station> stations = outerStations(steps);
  const auto point = [&](int i) { return profile[static_cast<std::size_t>(i)]; };
  const auto station = [&](int j) { return stations[static_cast<std::size_t>(j)]; };
  builder.addGrid(
      part, sizeOf(profile), static_cast<int>(stations.size()), false,
      [&](int i, int j) -> SidePoint {
        const float lean = station(j).lean;
        const Vector2f xz =
            point(i).outside - (point(i).sharp ? 0 : station(j).inset) * point(i).normal;
        return {inSpace(xz, station(j).y),
                inSpace(std::sqrt(1 - lean * lean) * point(i).normal, lean),
                {texCoordU(part, point(i).outside), station(j).y / kBook.height},
                {point(i).skyVisibility}};
      },
      [&](int i, int j) {
        return surfaceIdOf(part, outerKind(point(i), point(i + 1), station(j), station(j + 1)));
      },
      [&](int i, int j) {
        if (station(j).lean != station(j + 1).lean) return column(j);
        const Kind kind = outerKind(point(i), point(i + 1), station(j), station(j + 1));
        const bool flat = kind == Kind::Outer && point(i).normal == point(i + 1).normal;
        return part == BookPart::Spine || flat ? kNoLine : row(i);
      });
}

/// Adds the narrow side at the foot or the head, between the outer and the inner side.
void addEnd(MeshBuilder& builder, BookPart part, const std::vector<ProfilePoint>& profile,
            bool head) {
  const float y = head ? kBook.height : 0;
  builder.addGrid(
      part, sizeOf(profile), 2, head,
      [&](int i, int j) -> SidePoint {
        const ProfilePoint& point = profile[static_cast<std::size_t>(i)];
        const Vector2f rounded =
            point.outside - (point.sharp ? 0 : kBook.edgeRadius) * point.normal;
        return {inSpace(j == 1 ? rounded : point.inside, y),
                {0, head ? 1.0F : -1.0F, 0},
                {texCoordU(part, point.outside), head ? 1 - kRim : kRim}};
      },
      always(surfaceIdOf(part, Kind::Rim)), always(column(0)));
}

/// Adds the inner side, of which the rim beyond the leaves is visible.
void addInnerSide(MeshBuilder& builder, BookPart part, const std::vector<ProfilePoint>& profile,
                  const MeshSteps& steps) {
  const std::vector<Station> stations = outerStations(steps);
  const float leaves = kBook.width - kBook.foreEdgeInset;
  builder.addGrid(
      part, sizeOf(profile), static_cast<int>(stations.size()), true,
      [&](int i, int j) -> SidePoint {
        const ProfilePoint& point = profile[static_cast<std::size_t>(i)];
        const float y = stations[static_cast<std::size_t>(j)].y;
        const bool atRim =
            y < kBook.headInset || y > kBook.height - kBook.headInset || point.inside.x() > leaves;
        const float sign = point.inside.y() > kBook.thickness / 2 ? -1.0F : 1.0F;
        const bool spine = part == BookPart::Spine;
        return {inSpace(point.inside, y),
                spine ? Vector3f(1, 0, 0) : Vector3f(0, 0, sign),
                {0.5F, kRim},
                outlookBesideLeaves(kBook, point.inside.x(), y),
                !atRim};
      },
      always(surfaceIdOf(part, Kind::Inner)),
      [&](int i, int j) {
        // Between the edge and the leaves, all squares but one repeat the rounding's stations.
        const int last = static_cast<int>(stations.size()) - 2;
        if (j <= steps.rounding) return column(steps.rounding);
        if (j >= last - steps.rounding) return column(last - steps.rounding);
        const auto next = static_cast<std::size_t>(i + 1);
        const float x = std::min(profile[next - 1].inside.x(), profile[next].inside.x());
        return x > leaves ? row(i) : kNoLine;
      });
}

void addCase(MeshBuilder& builder, BookPart part, const std::vector<ProfilePoint>& profile,
             const MeshSteps& steps) {
  addOuterSide(builder, part, profile, steps);
  addInnerSide(builder, part, profile, steps);
  addEnd(builder, part, profile, false);
  addEnd(builder, part, profile, true);
}

/// Returns z of a grid line at this share of the page block's thickness. [mm]
float acrossLeaves(float share) {
  return kBook.board + share * (kBook.thickness - 2 * kBook.board);
}

/// Returns the x where the leaves end at this share of their thickness. [mm]
float foreEdge(float share) {
  const float fromMiddle = 2 * share - 1;
  return kBook.width - kBook.foreEdgeInset - kHollow * (1 - fromMiddle * fromMiddle);
}

void addForeEdge(MeshBuilder& builder, const MeshSteps& steps) {
  const std::vector<float>&across = steps.acrossLeaves, &alongs = steps.alongForeEdge;
  builder.addGrid(
      BookPart::Pages, static_cast<int>(across.size()), static_cast<int>(alongs.size()), false,
      [&](int row, int column) -> SidePoint {
        const auto i = static_cast<std::size_t>(row);
        const float share = across[i], along = alongs[static_cast<std::size_t>(column)];
        const float slope = 4 * kHollow * (2 * share - 1) / (kBook.thickness - 2 * kBook.board);
        const float y = kBook.headInset + along * (kBook.height - 2 * kBook.headInset);
        const float x = foreEdge(share), z = acrossLeaves(share);
        const Vector3f normal = Vector3f(1, 0, -slope).normalized();
        return {{x, y, z},
                normal,
                {kLeavesPerHeight * along, kLeavesPerThickness * share},
                outlookOfForeEdge(kBook, x, z, normal)};
      },
      always(kForeEdge), [](int i, int) { return row(i); });
}

/// Adds the leaves' ends at the foot or the head, from the spine's inner side to the fore edge.
void addLeafEnds(MeshBuilder& builder, const MeshSteps& steps, bool head) {
  const std::vector<float>&across = steps.acrossLeaves, &alongs = steps.alongEnds;
  const float y = head ? kBook.height - kBook.headInset : kBook.headInset;
  builder.addGrid(
      BookPart::Pages, static_cast<int>(alongs.size()), static_cast<int>(across.size()), !head,
      [&](int row, int column) -> SidePoint {
        const auto i = static_cast<std::size_t>(column);
        const float along = alongs[static_cast<std::size_t>(row)];
        const float x = kBook.board + along * (foreEdge(across[i]) - kBook.board);
        const float z = acrossLeaves(across[i]);
        return {{x, y, z},
                {0, head ? 1.0F : -1.0F, 0},
                {kLeavesPerHeight * along * kBook.width / kBook.height,
                 kLeavesPerThickness * across[i]},
                outlookOfLeafEnds(kBook, x, z)};
      },
      always(head ? kHead : kFoot), [](int, int j) { return column(j); });
}

}  // namespace

Mesh makeBookMesh(MeshDetail detail) {
  const MeshSteps steps = detail == MeshDetail::Small ? stepsOfSmallBook() : MeshSteps{};
  MeshBuilder builder;
  addCase(builder, BookPart::Front, frontProfile(kBook, steps.profile), steps);
  addCase(builder, BookPart::Spine, spineProfile(kBook, steps.profile), steps);
  addCase(builder, BookPart::Back, backProfile(kBook, steps.profile), steps);
  addForeEdge(builder, steps);
  addLeafEnds(builder, steps, false);
  addLeafEnds(builder, steps, true);
  return builder.take();
}

}  // namespace rotatebook::geometry
