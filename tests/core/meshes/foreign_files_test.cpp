// Files that aren't what their names say.
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "body/message_of.h"
#include "body/solids.h"
#include "meshes/glb_box.h"
#include "meshes/mesh_readers.h"
#include "meshes/mesh_texts.h"
#include "messages.h"

namespace rotatebook::meshes {
namespace {

using body::testing::messageOf;

constexpr const char* kNames[] = {"a.obj", "a.stl", "a.ply", "a.glb"};

std::string said(const std::string& name, const std::string& bytes) {
  return messageOf([&] { readMesh(name, bytes); });
}

// 4 names, of which one fits, and 5 files.
TEST(ForeignFiles, OfMeshesAreNamedByWhatTheyAre) {
  const body::TriangleMesh box = body::testing::boxMesh(1, 2, 3);
  const std::pair<std::string, std::string> files[] = {
      {".obj", testing::objOf(box)},
      {".stl", testing::textStlOf(box)},
      {".stl", testing::binaryStlOf(box, "made by hand")},
      {".ply", testing::textPlyOf(box)},
      {".glb", testing::BoxFile().bytes()}};
  for (const auto& [ending, bytes] : files) {
    for (const std::string name : kNames) {
      const std::string kind = ending == ".obj"   ? "an OBJ"
                               : ending == ".stl" ? "an STL"
                               : ending == ".ply" ? "a PLY"
                                                  : "a GLB";
      EXPECT_EQ(said(name, bytes),
                name.ends_with(ending)
                    ? "accepted"
                    : name + ": it is " + kind + " file; name it so that it ends in " + ending);
    }
  }
}

/// Returns the text in UTF-32, in either order of its bytes.
std::string utf32Of(const std::string& text, bool isBigEndian) {
  std::string wide;
  for (const char letter : text) {
    wide += isBigEndian ? std::string(3, '\0') + letter : letter + std::string(3, '\0');
  }
  return wide;
}

TEST(ForeignFiles, OfOtherKindsAreNamedWithARemedy) {
  using namespace std::string_literals;
  const std::string obj = testing::objOf(body::testing::boxMesh(1, 2, 3)), zeros(200, '\0');
  const std::pair<std::string, const char*> files[] = {
      {"\x1F\x8B\x08"s + zeros, "it is compressed by gzip; unpack it"},
      {"BZh91AY&SY" + zeros, "it is compressed by bzip2; unpack it"},
      {"\xFD\x37zXZ\0"s + zeros, "it is compressed by xz; unpack it"},
      {"PK\x03\x04" + zeros, "it is a ZIP archive, as .3mf is, too; unpack it"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
       "it is a pointer of git-lfs in the place of the file; fetch that with \"git lfs pull\""},
      {"\xFF\xFE\0\0"s + utf32Of(obj, false), "its text is in UTF-32; save it in UTF-8"},
      {"\0\0\xFE\xFF"s + utf32Of(obj, true), "its text is in UTF-32; save it in UTF-8"},
      {utf32Of(obj, false), "its text is in UTF-32; save it in UTF-8"},
      {utf32Of(obj, true), "its text is in UTF-32; save it in UTF-8"},
      {"\n<!DOCTYPE html><html></html>", "it is a web page; download the file that it shows"},
      {"<?xml version=\"1.0\"?><COLLADA/>", "it is XML, as Collada and X3D are"},
      {"{\"asset\": {\"version\": \"2.0\"}}", "it is JSON, as glTF's text (.gltf) is"},
      {"OFF\n8 12 0\n", "it is an OFF file"},
      {"ISO-10303-21;\nHEADER;\n", "it is a STEP file"},
      {"Kaydara FBX Binary  \0"s + zeros, "it is an FBX file"},
      {"\x89PNG\r\n\x1a\n" + zeros, "it is a picture (PNG), no mesh"},
      {std::string(5000, '\0'), "it has nothing but zeros; copy or export it again"},
      {"", "it is empty"}};
  for (const auto& [bytes, sentence] : files) {
    for (const std::string name : kNames) EXPECT_MESSAGE(said(name, bytes)) << bytes.substr(0, 20);
  }
}

// What a file of the right kind lacks is said, whatever else it may look like.
TEST(ForeignFiles, AreNoneOfTheirOwnKind) {
  EXPECT_EQ(said("a.obj", "# no points\n"), "a.obj: it has no points (\"v\"): not an OBJ file");
  EXPECT_EQ(said("a.obj", "v 0 0 0\n"),
            "a.obj: there are no triangles; export a mesh of triangles");
  EXPECT_MESSAGE(said("a.stl", "solid facets\nv 0 0 0\n"));
  EXPECT_MESSAGE(said("a.ply", "ply\nv 0 0 0\n"));
  EXPECT_MESSAGE(said("a.glb", "glTF{}"));
  const std::string box = testing::binaryStlOf(body::testing::boxMesh(1, 2, 3), "PK\x03\x04");
  EXPECT_EQ(said("a.stl", box), "accepted") << "a comment may be anything";
}

}  // namespace
}  // namespace rotatebook::meshes
