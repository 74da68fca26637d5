#include <vector>

#include "base/error.h"
#include "base/file_text.h"
#include "base/text.h"
#include "meshes/mesh_readers.h"
#include "meshes/mesh_words.h"
#include "meshes/polygon.h"

namespace rotatebook::meshes {
namespace {

/// Returns the index of a corner's point: "7", "7/1/3" and "7//3" are the seventh, "-1" the last.
std::uint32_t cornerOf(std::string_view word, std::size_t points, const MeshWords& words) {
  const auto number = integerIn(word.substr(0, word.find('/')));
  if (!number) {
    words.fail("a face's corner must begin with a point's number, not " +
               quotedBeginning(word, 40));
  }
  const auto count = static_cast<std::int64_t>(points);
  const std::int64_t index = *number < 0 ? count + *number : *number - 1;
  if (index < 0 || index >= count) {
    words.fail("the face names point " + std::to_string(*number) + ", but " +
               std::to_string(count) + (count == 1 ? " is" : " are") +
               " before it; points must be before their faces");
  }
  return static_cast<std::uint32_t>(index);
}

void readFace(MeshWords& words, body::TriangleMesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (std::string_view word = words.word(); !word.empty(); word = words.word())
    corners.push_back(cornerOf(word, mesh.points.size(), words));
  if (corners.size() < 3) {
    words.fail("a face has " + countText(std::ssize(corners), "corner") +
               "; it must have three or more: take it away");
  }
  addPolygon(corners, mesh);
}

}  // namespace

body::TriangleMesh readObj(std::string_view bytes) {
  std::string decoded;
  const std::string_view text = textOfFile(bytes, decoded);
  refuseUtf16(text);
  body::TriangleMesh mesh;
  MeshWords words(text, MeshWords::Syntax::Wavefront);
  do {
    const std::string_view kind = words.word();
    if (kind == "v" || kind == "V") {
      requireFewPoints(mesh.points.size() + 1);
      const double x = words.number("x"), y = words.number("y"), z = words.number("z");
      mesh.points.emplace_back(x, y, z);
    } else if (kind == "f" || kind == "F" || kind == "fo") {  // "fo": of old versions
      readFace(words, mesh);
    }
  } while (words.nextLine());
  if (mesh.points.empty()) throw InputError("it has no points (\"v\"): not an OBJ file");
  return mesh;
}

}  // namespace rotatebook::meshes
