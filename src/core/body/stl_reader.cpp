#include "base/error.h"
#include "base/text.h"
#include "body/mesh_readers.h"
#include "body/mesh_words.h"
#include "body/polygon.h"

namespace rotatebook::body {
namespace {

constexpr std::size_t kHeader = 84;    // A comment of 80 bytes, and the number of triangles
constexpr std::size_t kTriangle = 50;  // A normal, three corners, and two bytes more

void addTriangle(const Eigen::Vector3d (&corners)[3], TriangleMesh& mesh) {
  requireFewTriangles(mesh.triangles.size() + 1);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners, corners + 3);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

TriangleMesh readBinaryStl(std::string_view bytes, std::size_t count) {
  TriangleMesh mesh;
  MeshBytes data(bytes.substr(kHeader), kHeader);
  for (std::size_t i = 0; i < count; ++i) {
    data.take(3 * sizeof(float));
    Eigen::Vector3d corners[3];
    for (Eigen::Vector3d& corner : corners) {
      for (double& number : corner) number = static_cast<double>(data.next<float>());
    }
    data.take(2);
    addTriangle(corners, mesh);
  }
  return mesh;
}

void expect(MeshWords& words, std::string_view wanted) {
  const std::string_view found = words.wordOnAnyLine();
  if (found == wanted) return;
  words.fail("\"" + std::string(wanted) + "\" is expected here" +
             (found.empty() ? ", but the file ends" : ", not " + quotedText(oneLine(found, 40))));
}

/// Reads a facet after its first word.
void readFacet(MeshWords& words, TriangleMesh& mesh) {
  words.restOfLine();  // Its normal follows from its corners
  expect(words, "outer");
  expect(words, "loop");
  Eigen::Vector3d corners[3];
  for (Eigen::Vector3d& corner : corners) {
    expect(words, "vertex");
    corner.x() = words.number("x");
    corner.y() = words.number("y");
    corner.z() = words.number("z");
  }
  expect(words, "endloop");
  expect(words, "endfacet");
  addTriangle(corners, mesh);
}

TriangleMesh readTextStl(std::string_view text) {
  TriangleMesh mesh;
  MeshWords words(text);
  for (std::string_view word = words.wordOnAnyLine(); !word.empty(); word = words.wordOnAnyLine()) {
    if (word == "facet") {
      readFacet(words, mesh);
    } else if (word == "solid" || word == "endsolid") {
      words.restOfLine();
    } else {
      words.fail("\"facet\" is expected here, not " + quotedText(oneLine(word, 40)));
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh readStl(std::string_view bytes) {
  // Some binary files begin with "solid", too; their length tells.
  if (bytes.size() >= kHeader) {
    const std::size_t count = MeshBytes(bytes.substr(kHeader - 4)).next<std::uint32_t>();
    const bool isWhole =
        (bytes.size() - kHeader) / kTriangle == count && (bytes.size() - kHeader) % kTriangle == 0;
    if (isWhole) {
      requireFewTriangles(count);
      return readBinaryStl(bytes, count);
    }
    if (!trimmed(bytes.substr(0, 80)).starts_with("solid")) {
      throw InputError("it says that it has " + std::to_string(count) + " triangles of " +
                       std::to_string(kTriangle) + " bytes, but has " +
                       std::to_string(bytes.size() - kHeader) +
                       " bytes of them: no STL file, or not whole; export it again");
    }
  }
  if (!trimmed(bytes).starts_with("solid")) {
    throw InputError("neither \"solid\" nor the " + std::to_string(kHeader) +
                     " bytes of a binary header: not an STL file");
  }
  return readTextStl(bytes);
}

}  // namespace rotatebook::body
