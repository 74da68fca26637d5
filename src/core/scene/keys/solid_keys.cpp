// The keys of [body] that put a shape, a mesh or a sum of shapes in the place of the book.
#include "scene/keys/solid_keys.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/document/problems.h"
#include "base/elementary.h"
#include "base/text.h"
#include "body/shape.h"
#include "meshes/mesh_readers.h"
#include "scene/keys/keys.h"
#include "scene/keys/kinds.h"
#include "scene/limits.h"

namespace rotatebook::scene {
namespace {

constexpr NumberRange kShapeLengths{"a length from 1e-6 to 1e6 m", 1e-6, 1e6, Dimension::Length};
constexpr NumberRange kDensities{"a density from 1e-6 to 1e9 kg/m^3", 1e-6, 1e9};
constexpr NumberRange kPartDensities{"a density from -1e9 to 1e9 kg/m^3 other than 0", -1e9, 1e9};
constexpr NumberRange kPlaces{"three lengths from -1e6 to 1e6 m", -1e6, 1e6, Dimension::Length};
constexpr const char* kExpectedParts = "tables with the header [[body.part]]";
constexpr const char* kExpectedLengths = "a table of the shape's lengths, such as { radius = 0.1 }";
constexpr const char* kBook = "book";
constexpr std::size_t kMaxParts = 100;

constexpr std::array<Named<double>, 5> kMeshUnits{
    {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"km", 1e3}, {"in", 0.0254}}};

std::vector<std::string_view> shapeNames() {
  std::vector<std::string_view> names{kBook};
  for (const body::Shape& shape : body::allShapes()) names.push_back(shape.name);
  return names;
}

/// Reads what `table` says of the lengths of its shape; the others are as by default.
std::vector<double> lengthsFrom(const ValueReader& table, const body::Shape& shape) {
  std::vector<double> lengths;
  std::vector<Field> fields;
  for (const body::ShapeLength& length : shape.lengths) {
    fields.push_back({length.name, [&lengths, i = lengths.size()](const ValueReader& value) {
                        lengths[i] = value.number(kShapeLengths);
                      }});
    lengths.push_back(length.byDefault);
  }
  if (const auto stated = table.find("dimensions")) stated->readTable(fields);
  return lengths;
}

std::string lengthsText(const BodyPart& part) {
  const body::Shape* shape = body::findShape(part.shape);
  std::vector<std::string> parts;
  for (std::size_t i = 0; shape != nullptr && i < part.lengths.size(); ++i)
    parts.push_back(std::string(shape->lengths[i].name) + " = " + tomlNumber(part.lengths[i]));
  return parts.empty() ? "" : "{ " + joined(parts) + " }";
}

/// Reads the shape that `table` names, with its lengths; empty for the book.
void readShape(const ValueReader& table, BodyPart& part) {
  const auto name = table.find("shape");
  if (!name) table.fail(table.name() + " needs a shape, such as \"box\"");
  const auto names = shapeNames();
  const std::string_view chosen = names[name->choice(names)];
  if (chosen == kBook) return;
  part.shape = chosen;
  part.lengths = lengthsFrom(table, *body::findShape(chosen));
}

double partDensityFrom(const ValueReader& value) {
  const double density = value.number(kPartDensities);
  if (density == 0) value.mismatch(std::string(kPartDensities.expected));
  return density;
}

/// Of keys that are read together with others.
template <typename S>
void readLater(const ValueReader&, S&) {}

std::string shapeText(const BodyPart& part) {
  return tomlString(part.shape);
}

Keys<BodyPart> partKeys() {
  static constexpr std::array keys{
      keyOf<BodyPart, readLater<BodyPart>, shapeText>(
          "shape", ownForm(kTextKind, "the name of a shape"),
          {.meaning = "a [shape](bodies.md#shapes), but for the book", .byDefault = "required"}),
      keyOf<BodyPart, readLater<BodyPart>, lengthsText>(
          "dimensions", ownForm(kTableKind, kExpectedLengths),
          {.meaning = "its lengths", .byDefault = "the shape's", .unit = "m"}),
      own<&BodyPart::density, partDensityFrom, tomlNumber>(
          "density", kNumberKind, kPartDensities.expected,
          {.meaning = "negative for what is taken away",
           .byDefault = "the shape's",
           .unit = "kg/m³"}),
      vector<&BodyPart::place>("place", kPlaces, {.meaning = "of the shape's origin"}),
      angleAboutAxis<&BodyPart::turn>(
          "turn", {.meaning = "before it is moved to its place", .byDefault = "none"}),
  };
  return keys;
}

BodyPart partFrom(const ValueReader& table) {
  BodyPart part;
  readKeys(table, partKeys(), part);
  readShape(table, part);
  if (part.shape.empty())
    table.find("shape")->fail("a part can't be the book; use the shape \"box\" of its size");
  return part;
}

void readParts(const ValueReader& value, Solid& solid) {
  const auto tables = value.tables(kExpectedParts);
  if (tables.size() > kMaxParts) {
    value.fail("a body has up to " + std::to_string(kMaxParts) + " parts, not " +
               std::to_string(tables.size()));
  }
  readEach(tables, [&](const ValueReader& table) { solid.parts.push_back(partFrom(table)); });
}

std::string partsText(const Solid& solid) {
  if (solid.isShape || solid.parts.empty()) return "";
  return listText(solid.parts, [](const BodyPart& part) { return inlineTable(partKeys(), part); });
}

/// Reads the numbers of meshText().
MeshFile meshFrom(const ValueReader& value) {
  constexpr NumberRange kAny{"numbers", -1e200, 1e200};
  MeshFile mesh;
  Eigen::Vector3d diagonal(0, 0, 0), others(0, 0, 0);
  const auto vectorInto = [&](Eigen::Vector3d& into) {
    return [&](const ValueReader& numbers) { into = vectorFrom(numbers, kAny); };
  };
  constexpr const char* kName = "the name of a file that ends in .obj, .stl, .ply or .glb";
  if (std::holds_alternative<std::string>(value.node().value)) value.mismatch(kName);
  value.readTable({{"file", [&](const ValueReader& name) { mesh.name = name.text(kLongestPath); }},
                   {"volume", [&](const ValueReader& v) { mesh.volume = v.number(kAny); }},
                   {"size", vectorInto(mesh.size)},
                   {"moments", vectorInto(diagonal)},
                   {"products", vectorInto(others)}});
  const bool isWhole = meshes::isMeshName(mesh.name) && mesh.volume > 0 && mesh.size.minCoeff() > 0;
  if (!isWhole) value.mismatch(kName);
  mesh.inertia = diagonal.asDiagonal();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    mesh.inertia(i, j) = mesh.inertia(j, i) = others[i];
  }
  return mesh;
}

void readMesh(const ValueReader& value, Solid& solid) {
  const double unit = solid.mesh.unit;
  solid.mesh = meshFrom(value);
  solid.mesh.unit = unit;
}

std::string meshTextOf(const Solid& solid) {
  return solid.mesh.name.empty() ? "" : meshText(solid.mesh);
}

void readUnit(const ValueReader& value, Solid& solid) {
  solid.mesh.unit = choiceFrom(value, kMeshUnits);
}

/// Returns the unit of a mesh; nothing of other bodies.
std::string unitText(const Solid& solid) {
  return solid.mesh.name.empty() ? "" : quotedName(kMeshUnits, solid.mesh.unit);
}

/// Returns what kText returns of the part of a single shape; nothing of other solids.
template <auto kText>
std::string textOfShape(const Solid& solid) {
  const bool isIt = solid.isShape && solid.parts.size() == 1;
  return isIt ? kText(solid.parts.front()) : "";
}

}  // namespace

Keys<Solid> solidKeys() {
  static constexpr std::array keys{
      keyOf<Solid, readLater<Solid>, textOfShape<shapeText>>(
          "shape", ownForm(kTextKind, "\"book\" or the name of a shape"),
          {.meaning = "a [shape](bodies.md#shapes)", .byDefault = "`\"book\"`"}),
      keyOf<Solid, readLater<Solid>, textOfShape<lengthsText>>(
          "dimensions", ownForm(kTableKind, kExpectedLengths),
          {.meaning = "of the shape", .byDefault = "the shape's", .unit = "m"}),
      keyOf<Solid, readMesh, meshTextOf>(
          "mesh", ownForm(kTextKind, "the name of a file: .obj, .stl, .ply or .glb"),
          {.meaning = "a closed mesh in the scene's folder, see [bodies](bodies.md)",
           .byDefault = "none"}),
      keyOf<Solid, readUnit, unitText>(
          "unit", {.type = ValueForm::Type::Choice, .choices = kNamesOf<kMeshUnits>},
          {.meaning = "of the mesh's lengths", .byDefault = "`\"m\"`"}),
      number<&Solid::density>("density", kDensities,
                              {.meaning = "of a shape or a mesh, in place of `mass`",
                               .byDefault = "the shape's",
                               .unit = "kg/m³"}),
      keyOf<Solid, readParts, partsText>(
          "part", ownForm(kListKind, kExpectedParts),
          {.meaning = "tables `[[body.part]]`, shapes that add up", .byDefault = "none"}),
  };
  return keys;
}

const std::vector<KeyRow>& partRows() {
  static const std::vector<KeyRow> rows = rowsOf("body.part.N.", partKeys());
  return rows;
}

std::string meshText(const MeshFile& mesh) {
  const Eigen::Matrix3d& inertia = mesh.inertia;
  return "{ file = " + tomlString(mesh.name) + ", volume = " + tomlNumber(mesh.volume) +
         ", size = " + vectorText(mesh.size) + ", moments = " + vectorText(inertia.diagonal()) +
         ", products = " + vectorText({inertia(0, 1), inertia(1, 2), inertia(2, 0)}) + " }";
}

void readStatedShape(const ValueReader& section, Solid& solid) {
  if (!section.find("shape")) return;
  BodyPart part;
  readShape(section, part);
  if (part.shape.empty()) return;
  part.density = solid.density;
  solid.density.reset();
  solid.isShape = true;
  solid.parts = {part};
}

}  // namespace rotatebook::scene
