#include <algorithm>

#include "base/error.h"
#include "base/file_text.h"
#include "base/text.h"
#include "meshes/foreign_files.h"
#include "meshes/mesh_readers.h"
#include "meshes/mesh_words.h"
#include "meshes/polygon.h"

namespace rotatebook::meshes {
namespace {

constexpr std::size_t kHeader = 84;    // A comment of 80 bytes, and the number of triangles
constexpr std::size_t kTriangle = 50;  // A normal, three corners, and two bytes more

void addTriangle(const Eigen::Vector3d (&corners)[3], body::TriangleMesh& mesh) {
  requireFewTriangles(mesh.triangles.size() + 1);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners, corners + 3);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Throws InputError unless a binary file has the triangles that it says; a byte more, or any
/// number of blanks and zeros, does no harm.
void requireWhole(std::string_view bytes, std::size_t count) {
  const std::string_view data = bytes.substr(kHeader);
  const std::uint64_t said = std::uint64_t{count} * kTriangle;
  if (data.size() >= said && count > 0) {
    const std::string_view spare = data.substr(static_cast<std::size_t>(said));
    if (spare.size() <= 1 || spare.find_first_not_of(kPadding) == spare.npos) return;
  }
  if (data.empty() && count == 0) return;
  throw InputError("it says that it has " + std::to_string(count) + " triangles of " +
                   std::to_string(kTriangle) + " bytes, but has " +
                   countText(static_cast<std::int64_t>(data.size()), "byte") + " of them" +
                   (data.size() > said
                        ? ", " + std::to_string(data.size() - said) +
                              " too many: the number is wrong, or something else follows"
                        : ": no STL file, or not whole") +
                   "; export it again");
}

body::TriangleMesh readBinaryStl(std::string_view bytes) {
  const std::size_t count = MeshBytes(bytes.substr(kHeader - 4)).next<std::uint32_t>();
  requireWhole(bytes, count);
  requireFewTriangles(count);
  body::TriangleMesh mesh;
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

/// Returns the next word in small letters, without comments; "end loop" as one word.
std::string keyword(MeshWords& words) {
  std::string_view word = words.wordOnAnyLine();
  while (word.starts_with('#') || word.starts_with(';')) {
    words.restOfLine();
    word = words.wordOnAnyLine();
  }
  std::string found = lowerCase(word);
  if (found == "end") found += lowerCase(words.word());
  return found;
}

[[noreturn]] void failAt(const MeshWords& words, std::string_view wanted, std::string_view found) {
  words.fail("\"" + std::string(wanted) + "\" is expected here" +
             (found.empty() ? ", but the file ends" : ", not " + quotedBeginning(found, 40)));
}

void expect(MeshWords& words, std::string_view wanted) {
  const std::string found = keyword(words);
  if (found != wanted) failAt(words, wanted, found);
}

/// Reads a facet after its first word.
void readFacet(MeshWords& words, body::TriangleMesh& mesh) {
  // Its normal follows from its corners
  std::string word = "normal";
  while (!word.empty() && word != "outer") word = lowerCase(words.word());
  if (word.empty()) expect(words, "outer");
  expect(words, "loop");
  Eigen::Vector3d corners[3];
  for (Eigen::Vector3d& corner : corners) {
    expect(words, "vertex");
    corner.x() = words.number("x");
    corner.y() = words.number("y");
    corner.z() = words.number("z");
  }
  const std::string end = keyword(words);
  if (end == "vertex") words.fail("a facet has more than three corners; export triangles");
  if (end != "endloop") failAt(words, "endloop", end);
  expect(words, "endfacet");
  addTriangle(corners, mesh);
}

/// Skips a solid's name, up to the line's end or to a facet behind it. Returns whether that is one,
/// of which the first word is then read, too.
bool endsAtFacet(MeshWords& words) {
  std::string before, word = lowerCase(words.word());
  while (!word.empty() && !(before == "facet" && word == "normal")) {
    before = word;
    word = lowerCase(words.word());
  }
  return !word.empty();
}

NotedSurface readTextStl(std::string_view text) {
  NotedSurface read;
  MeshWords words(text);
  bool hasEnd = false;
  for (std::string word = keyword(words); !word.empty(); word = keyword(words)) {
    const bool isName = word == "solid" || word == "endsolid";
    if (!isName && word != "facet") failAt(words, "facet", word);
    hasEnd = word == "endsolid";
    if (!isName || endsAtFacet(words)) readFacet(words, read.surface.mesh);
  }
  if (!hasEnd) {
    read.notes.emplace_back(
        "it has no \"endsolid\" behind its last triangle: others may be missing");
  }
  return read;
}

/// Returns whether a file has a byte in its beginning that no text has.
bool hasBinaryByte(std::string_view bytes) {
  const auto isOfText = [](char byte) {
    return static_cast<unsigned char>(byte) >= ' ' || (byte >= '\t' && byte <= '\r');
  };
  return bytes.size() >= kHeader &&
         !std::ranges::all_of(bytes.substr(0, kHeader + kTriangle), isOfText);
}

}  // namespace

NotedSurface readStl(std::string_view bytes) {
  // Some binary files begin with "solid", too
  if (hasSizeOfStl(bytes)) return {{.mesh = readBinaryStl(bytes)}};
  std::string decoded;
  const std::string_view file = textOfFile(bytes, decoded);
  refuseUtf16(file);
  if (decoded.empty() && hasBinaryByte(file)) return {{.mesh = readBinaryStl(bytes)}};
  const std::string_view text = withoutPadding(file);
  MeshWords words(text);
  if (const std::string first = keyword(words); first != "solid" && first != "facet") {
    throw InputError(
        (first.empty() ? "it is empty" : "it begins with " + quotedBeginning(first, 40)) +
        ", and has neither \"solid\" nor the " + std::to_string(kHeader) +
        " bytes of a binary header: not an STL file");
  }
  return readTextStl(text);
}

}  // namespace rotatebook::meshes
