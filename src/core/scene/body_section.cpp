#include "scene/body_section.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/error.h"
#include "base/text.h"
#include "meshes/mesh_readers.h"
#include "scene/keys/keys.h"
#include "scene/keys/solid_keys.h"
#include "scene/solid_numbers.h"

namespace rotatebook::scene {
namespace {

using document::TomlNode;

/// Throws InputError if `section` has a key that `because` makes meaningless.
void refuse(const ValueReader& section, std::string_view key, const std::string& because) {
  if (const auto value = section.find(key)) value->fail(value->name() + " " + because);
}

/// Throws InputError unless `section` states one body, completely.
void checkStatement(const ValueReader& section, const Solid& solid) {
  for (const auto& [kept, other] :
       {std::pair("shape", "mesh"), {"shape", "part"}, {"mesh", "part"}}) {
    if (section.find(kept) && section.find(other))
      refuse(section, other,
             "and body." + std::string(kept) + " both say what the body is; keep one");
  }
  if (!section.find("shape") || solid.isBook())
    refuse(section, "dimensions", "belongs to a shape that isn't the book; the book has body.size");
  if (!section.find("mesh")) refuse(section, "unit", "belongs to body.mesh, which isn't stated");
  const bool hasParts = section.find("part").has_value();
  if (hasParts || solid.isBook())
    refuse(section, "density",
           "belongs to a shape or a mesh; parts have their own, the book a mass");
  if (solid.isBook()) return;
  for (const char* key : {"size", "inertia"})
    refuse(section, key, "follows from the body's shape; leave it out");
  if (section.find("mass") && section.find("density"))
    refuse(section, "density", "and body.mass both say how heavy the body is; keep one");
  if (section.find("mesh") && !section.find("mass") && !section.find("density"))
    section.find("mesh")->fail("body.mesh needs body.density or body.mass");
}

void readBody(const ValueReader& section, Motion& motion) {
  auto fields = fieldsInto(motion, bodyKeys());
  const auto others = fieldsInto(motion.solid, solidKeys());
  fields.insert(fields.end(), others.begin(), others.end());
  section.readTable(fields);
  readStatedShape(section, motion.solid);
  checkStatement(section, motion.solid);
  if (motion.solid.isBook()) return;
  motion.solid.mass.reset();
  if (section.find("mass")) motion.solid.mass = motion.body.mass;
  motion.body = {};
}

std::string bodyLines(const Motion& motion, const Printed& printed) {
  if (motion.solid.isBook()) return linesOf(bodyKeys(), motion.motion(), printed);
  std::string lines = linesOf(solidKeys(), motion.solid, printed);
  const BodyPart* shape = motion.solid.isShape ? &motion.solid.parts.front() : nullptr;
  if (shape != nullptr && shape->density && !motion.solid.mass)
    lines += "density = " + tomlNumber(*shape->density) + "\n";
  if (motion.solid.mass) lines += "mass = " + tomlNumber(*motion.solid.mass) + "\n";
  return lines;
}

std::vector<KeyRow> bodyRows() {
  std::vector<KeyRow> rows = rowsOf("body.", bodyKeys());
  for (const auto& more : {rowsOf("body.", solidKeys()), partRows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

TomlNode* nodeAt(TomlNode* node, std::string_view key) {
  auto* table = node != nullptr ? std::get_if<TomlNode::Table>(&node->value) : nullptr;
  auto* entry = table != nullptr ? find(*table, key) : nullptr;
  return entry != nullptr ? &entry->node : nullptr;
}

/// Reads each file once, into `known`.
void includeMesh(TomlNode& root, const ReadNamedFile& readNamedFile, MeshFiles& known) {
  TomlNode* node = nodeAt(nodeAt(&root, "body"), "mesh");
  // A record of a clip has the numbers already
  if (node == nullptr || std::holds_alternative<TomlNode::Table>(node->value)) return;
  const auto* name = std::get_if<std::string>(&node->value);
  if (name == nullptr || !meshes::isMeshName(*name)) {
    document::failAt(node->location,
                     "body.mesh must be the name of a file that ends in .obj, .stl, .ply or .glb, "
                     "not " +
                         describe(*node));
  }
  const std::string shown = "body.mesh names the file " + describe(*node);
  if (!readNamedFile) document::failAt(node->location, shown + ", but no file is read here");
  if (std::filesystem::path(*name).is_absolute())
    document::failAt(node->location, shown + ", which must be relative to the scene's folder");
  const auto [mesh, isNew] = known.try_emplace(*name);
  if (isNew) {
    try {
      mesh->second = readMeshFile(*name, readNamedFile(*name, kLongestMesh));
    } catch (const InputError& error) {
      document::failAt(node->location, shown + ": " + error.what());
    }
  }
  *node = *document::parseTomlValue(meshText(mesh->second), node->location);
}

}  // namespace

Section<Motion> bodySection() {
  return {"body", readBody, bodyLines, bodyRows()};
}

MeshFiles includeMeshes(TomlNode& root, const ReadNamedFile& readNamedFile) {
  MeshFiles files;
  includeMesh(root, readNamedFile, files);
  TomlNode* panels = nodeAt(&root, "panel");
  auto* tables = panels != nullptr ? std::get_if<TomlNode::Array>(&panels->value) : nullptr;
  if (tables == nullptr) return files;
  for (TomlNode& panel : *tables) includeMesh(panel, readNamedFile, files);
  return files;
}

void takeContent(const MeshFile& file, MeshFile& mesh) {
  MeshFile same = file;
  same.unit = mesh.unit;
  if (same == mesh) mesh = same;
}

void takeContent(const MeshFiles& files, MeshFile& mesh) {
  const auto file = files.find(mesh.name);
  if (file != files.end()) takeContent(file->second, mesh);
}

}  // namespace rotatebook::scene
