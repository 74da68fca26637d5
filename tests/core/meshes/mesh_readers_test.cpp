#include "meshes/mesh_readers.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "body/closed_surface.h"
#include "body/mass_properties.h"
#include "body/message_of.h"
#include "body/solids.h"
#include "meshes/mesh_texts.h"
#include "messages.h"

namespace rotatebook::meshes {
namespace {

using body::testing::messageOf;
using testing::binaryPlyOf;
using testing::binaryStlOf;
using testing::objOf;
using testing::textPlyOf;
using testing::textStlOf;

void expectBox(const char* name, const std::string& bytes) {
  const body::TriangleMesh mesh = readMesh(name, bytes).surface.mesh;
  EXPECT_EQ(mesh.points.size(), 8U) << name;
  EXPECT_EQ(mesh.triangles.size(), 12U) << name;
  EXPECT_DOUBLE_EQ(body::massPropertiesOf(mesh, 1).volume, 6) << name;
}

TEST(MeshReaders, ReadOneBodyFromEachFormat) {
  const body::TriangleMesh box = body::testing::boxMesh(1, 2, 3);
  expectBox("a.obj", objOf(box));
  expectBox("a.STL", textStlOf(box));
  expectBox("a.stl", binaryStlOf(box));
  expectBox("a.stl", binaryStlOf(box, "made by hand"));
  expectBox("a.ply", textPlyOf(box));
  expectBox("a.ply", binaryPlyOf(box, false));
  expectBox("a.ply", binaryPlyOf(box, true));
}

TEST(MeshReaders, RefuseOtherEndings) {
  const auto refused = messageOf([] { readMesh("book.fbx", ""); });
  EXPECT_EQ(refused, "book.fbx: not a mesh that can be read; export it as .obj, .stl, .ply, .glb");
  EXPECT_TRUE(isMeshName("a/b.Ply"));
  EXPECT_FALSE(isMeshName("scene.toml"));
}

TEST(ObjReader, TakesPolygonsAndNegativeNumbers) {
  const body::TriangleMesh mesh = readObj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv +.5 .5 1e0\n"
      "f -2 -3 -4 -5\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5");
  EXPECT_EQ(mesh.triangles.size(), 6U);
  requireClosed(mesh);
  EXPECT_DOUBLE_EQ(body::massPropertiesOf(mesh, 1).volume, 1.0 / 3);
}

// A plane polygon that isn't convex, and whose fan leaves it: an L of three unit squares.
TEST(ObjReader, TakesPolygonsThatArentConvex) {
  const body::TriangleMesh mesh = readObj(
      "v 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 1 0\nv 1 1 0\n"
      "v 1 0 1\nv 2 0 1\nv 2 2 1\nv 0 2 1\nv 0 1 1\nv 1 1 1\n"
      "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\n"
      "f 5 6 12 11\nf 6 1 7 12\n");
  requireClosed(mesh);
  EXPECT_DOUBLE_EQ(body::massPropertiesOf(mesh, 1).volume, 3);
}

struct Broken {
  const char* name;
  std::string bytes;
  const char* message;
};

std::vector<Broken> brokenTexts() {
  const std::string stl = "solid s\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n";
  return {
      {"a.obj", "v 1 2\n", "line 1: z is missing"},
      {"a.obj", "v 1 2 x\n", "line 1: z must be a number, not \"x\""},
      {"a.obj", "v 1 2 3,5\n", "line 1: z must be a number, not \"3,5\"; write decimal points"},
      {"a.obj", "v 0 0 0\n\nf 1 1\n", "line 3: a face has 2 corners; it must have three or more"},
      {"a.obj", "v 0 0 0\nf 1 1 2\n", "line 2: the face names point 2, but 1 is before it"},
      {"a.obj", "v 0 0 0\nf 1 1 0\n", "line 2: the face names point 0"},
      {"a.obj", "v 0 0 0\nf 1 1 -2\n", "line 2: the face names point -2"},
      {"a.obj", "v 0 0 0\nf 1 a 1\n", "line 2: a face's corner must begin with a point's number"},
      {"a.obj", "v 0 0 0\nf 1 99999999999999999999 1\n", "line 2: a face's corner must begin"},
      {"a.stl", "facet", "line 1: \"outer\" is expected here, but the file ends"},
      {"a.stl", "facit", "a.stl: it begins with \"facit\", and has neither \"solid\" nor the 84 "},
      {"a.stl", "solid s\nfacit\n", "line 2: \"facet\" is expected here, not \"facit\""},
      {"a.stl", "solid s\nfacet normal 0 0 1\ninner loop\n", "line 3: \"outer\" is expected here"},
      {"a.stl", stl, "line 5: \"vertex\" is expected here, but the file ends"},
      {"a.stl", stl + "vertex 1 0\n", "line 5: z is missing"},
      {"a.stl", stl + "vertex 1 0 0\nvertex 1 1 0\nendlop\n", "line 7: \"endloop\" is"},
      {"a.stl", stl + "vertex 1 0 0\nvertex 1 1 0\nvertex 1 1 1\n",
       "line 7: a facet has more than three corners; export triangles"},
      {"a.ply", "play", "it doesn't begin with \"ply\": not a PLY file"},
      {"a.ply", "ply\nformat ascii 1.0\n", "the header has no end_header"},
      {"a.ply", "ply\nformat utf8 1.0\nend_header\n", "line 2: unknown format \"utf8\""},
      {"a.ply", "ply\nproperty float x\n",
       "line 2: a property comes before any element that could have it"},
      {"a.ply", "ply\nelement vertex -1\n", "line 2: there can't be -1 elements"},
      {"a.ply", "ply\nelement vertex many\n", "must be a whole number, not \"many\""},
      {"a.ply", "ply\nelement vertex 1\nproperty real x\n", "line 3: unknown type \"real\""},
      {"a.ply", "ply\nbase\n", "line 2: not a line of a PLY header: \"base\""},
      {"a.ply", "ply\nelement x 9999999999\nend_header\n ", "\"x\" has no properties"},
      {"a.ply", "ply\nelement vertex 2\nproperty float x\nend_header\n1\n", "the file ends within"},
      {"a.ply", "ply\nelement vertex 1\nproperty float x\nend_header\ny\n",
       "line 5: this must be a number, not \"y\""},
      {"a.ply", "ply\nelement face 1\nproperty list int int vertex_index\nend_header\n3 0 1 2\n",
       "line 5: a face names a vertex that doesn't exist; there are 0"},
      {"a.ply", "ply\nelement face 1\nproperty list int int vertex_index\nend_header\n-3\n",
       "line 5: a list has -3 numbers, and must have 0 to 10000; export it again"},
      {"a.ply", "ply\nelement face 1\nproperty list int int vertex_index\nend_header\n2 0 0\n",
       "a face names a vertex"},
      {"a.ply",
       "ply\nelement vertex 3\nproperty float x\nelement face 1\n"
       "property list int float vertex_index\nend_header\n0\n1\n2\n3 0 0.5 1\n",
       "line 10: a face names a vertex"},
      {"a.ply", "ply\nelement face 1\nproperty list float int vertex_index\nend_header\n2.5 0 0\n",
       "line 5: a list has 2.5 numbers, and must have 0 to 10000"},
      {"a.obj", "v 1 2 " + std::string(1000, 'z'), "zzz...\""},
      {"a.ply", "ply\nelement vertex 1\nproperty float x\nend_header\n1\n2\n",
       "line 6: the file goes on after its data"},
      {"a.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nend_header\n1 2",
       "the file goes on after its data"},
      {"a.stl", std::string(84, '\0') + "x",
       "it says that it has 0 triangles of 50 bytes, but has 1"},
      {"a.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty int x\nend_header\n123",
       "the file ends at byte 82, within its data; is it whole?"},
  };
}

TEST(MeshReaders, SayWhereATextIsBroken) {
  for (const auto& [name, bytes, message] : brokenTexts()) {
    const std::string said = messageOf([&, name = name, &bytes = bytes] { readMesh(name, bytes); });
    EXPECT_MESSAGE(said) << bytes;
    EXPECT_MESSAGE(said) << bytes;
  }
}

TEST(StlReader, SaysWhereABinaryFileEnds) {
  const std::string whole = binaryStlOf(body::testing::boxMesh(1, 1, 1), "binary");
  for (const std::size_t size : {whole.size() - 1, whole.size() - 50, std::size_t{84}}) {
    EXPECT_MESSAGE(messageOf([&] { readStl(std::string_view(whole).substr(0, size)); }));
  }
  std::string endless = whole;
  endless[83] = '\x7f';
  EXPECT_MESSAGE(messageOf([&] { readStl(endless); }));
}

TEST(PlyReader, SaysWhereABinaryFileEnds) {
  const std::string whole = binaryPlyOf(body::testing::boxMesh(1, 1, 1), true);
  for (std::size_t cut = 1; cut < 300; cut += 7) {
    EXPECT_MESSAGE(messageOf([&] {
      readPly(std::string_view(whole).substr(0, whole.size() - cut));
    })) << cut;
  }
}

}  // namespace
}  // namespace rotatebook::meshes
