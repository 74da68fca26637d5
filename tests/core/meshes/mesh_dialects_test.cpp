// Files as other programs write them.
#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "body/mass_properties.h"
#include "body/message_of.h"
#include "body/solids.h"
#include "meshes/mesh_readers.h"
#include "meshes/mesh_texts.h"
#include "messages.h"

namespace rotatebook::meshes {
namespace {

using body::testing::messageOf;
using testing::binaryStlOf;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::objOf;
using testing::replaced;
using testing::textPlyOf;
using testing::textStlOf;

const body::TriangleMesh& box() {
  static const body::TriangleMesh mesh = body::testing::boxMesh(1, 2, 3);
  return mesh;
}

void expectSameBox(const char* name, const std::string& bytes) {
  EXPECT_EQ(messageOf([&] {
              const body::TriangleMesh mesh = readMesh(name, bytes).surface.mesh;
              EXPECT_EQ(mesh.points.size(), 8U);
              EXPECT_EQ(mesh.triangles.size(), 12U);
              EXPECT_DOUBLE_EQ(body::massPropertiesOf(mesh, 1).volume, 6);
            }),
            "accepted")
      << bytes.substr(0, 300);
}

std::string upperCase(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::toupper(letter));
  return text;
}

/// Returns the text in UTF-16, in either order of its bytes, with or without their mark.
std::string utf16Of(const std::string& text, bool isBigEndian, bool hasMark) {
  std::string wide;
  if (hasMark) wide = isBigEndian ? "\xfe\xff" : "\xff\xfe";
  for (const char letter : text)
    wide += isBigEndian ? std::string{'\0', letter} : std::string{letter, '\0'};
  return wide;
}

TEST(MeshReaders, TakeLinesThatEndInAnyWay) {
  for (const char* end : {"\r", "\r\n", "\n\n", "\r\n\r\n"}) {
    expectSameBox("a.obj", replaced(replaced(objOf(box()), "\r", ""), "\n", end));
    expectSameBox("a.stl", replaced(textStlOf(box()), "\n", end));
    expectSameBox("a.ply", replaced(textPlyOf(box()), "\n", end));
  }
}

TEST(MeshReaders, CountLinesThatEndInAnyWay) {
  for (const char* end : {"\r", "\r\n", "\n"}) {
    const std::string obj = replaced("v 0 0 0\n# a comment\nv 0 0 x\n", "\n", end);
    EXPECT_MESSAGE(messageOf([&] { readObj(obj); }));
  }
}

TEST(MeshReaders, TakeAByteOrderMark) {
  expectSameBox("a.obj", "\xef\xbb\xbf" + objOf(box()));
  expectSameBox("a.stl", "\xef\xbb\xbf" + textStlOf(box()));
  expectSameBox("a.ply", "\xef\xbb\xbf" + textPlyOf(box()));
  expectSameBox("a.ply", "\xef\xbb\xbf" + testing::binaryPlyOf(box(), false));
}

TEST(MeshReaders, TakePaddingBehindTheirEnd) {
  for (const std::string& padding :
       {std::string(1, '\0'), std::string("\x1a"), std::string(5, '\0')}) {
    expectSameBox("a.obj", objOf(box()) + padding);
    expectSameBox("a.stl", textStlOf(box()) + padding);
    expectSameBox("a.ply", textPlyOf(box()) + padding);
  }
}

// 3 formats, 2 orders of bytes; without the mark the text may be another.
TEST(MeshReaders, TakeUtf16WithItsMark) {
  for (const auto& [name, text] : {std::pair("a.obj", objOf(box())),
                                   {"a.stl", textStlOf(box())},
                                   {"a.ply", textPlyOf(box())}}) {
    for (const bool isBigEndian : {false, true}) {
      expectSameBox(name, utf16Of(text, isBigEndian, true));
      const std::string bare = utf16Of(text, isBigEndian, false);
      EXPECT_EQ(messageOf([&, name = name] { readMesh(name, bare); }),
                std::string(name) +
                    ": it is a text in UTF-16 without its byte order mark; save it in UTF-8");
    }
  }
}

TEST(ObjReader, TakesLinesThatGoOn) {
  const std::string obj = replaced(objOf(box()), "//2\t", "//2 \\\n\t");
  expectSameBox("a.obj", obj);
  expectSameBox("a.obj", replaced(obj, "//2 \\", "//2\\"));
  expectSameBox("a.obj", replaced(obj, "\\\n", "\\ \r\n"));
  expectSameBox("a.obj", replaced(objOf(box()), "v ", "v\\\n\\\n "));
  EXPECT_MESSAGE(messageOf([] { readObj("v 0 \\\n 0 \\\n x\n"); }));
}

// What goes on after other lines is no line of its own; a comment doesn't go on.
TEST(ObjReader, TakesOtherLinesThatGoOn) {
  expectSameBox("a.obj", "g left \\\nf right\n# C:\\\n" + objOf(box()) + "usemtl a\\\n");
}

TEST(ObjReader, TakesCommentsAfterAFace) {
  expectSameBox("a.obj", replaced(objOf(box()), "\n", " # so it is\n"));
  expectSameBox("a.obj", replaced(objOf(box()), "\n", "#so\n"));
}

TEST(ObjReader, TakesOldAndLargeLetters) {
  expectSameBox("a.obj", replaced(objOf(box()), "f ", "fo "));
  expectSameBox("a.obj", replaced(replaced(objOf(box()), "f ", "F "), "v ", "V "));
}

TEST(StlReader, TakesWordsInAnyCase) {
  expectSameBox("a.stl", upperCase(textStlOf(box())));
  expectSameBox("a.stl", replaced(textStlOf(box()), "end", "END"));
  expectSameBox("a.stl", replaced(textStlOf(box()), "vertex", "Vertex"));
}

TEST(StlReader, TakesEndsOfTwoWords) {
  expectSameBox("a.stl", replaced(textStlOf(box()), "end", "end "));
  expectSameBox("a.stl", replaced(textStlOf(box()), "end", "End\t"));
}

TEST(StlReader, TakesComments) {
  expectSameBox("a.stl",
                "; made by hand\n" + replaced(textStlOf(box()), "  facet", "# facet\n  facet"));
}

// Text that is longer decoded than in the file, which is too short for a binary one.
TEST(StlReader, ReadsNoBinaryFileFromDecodedText) {
  const std::string bytes = std::string("\xff\xfe\x01\0", 4) + std::string(70, '\x08');
  EXPECT_MESSAGE(messageOf([&] { readStl(bytes); }));
}

TEST(StlReader, SaysHowATextBegins) {
  EXPECT_MESSAGE(messageOf([] { readStl("<!DOCTYPE html>" + std::string(200, ' ')); }));
}

TEST(StlReader, TakesATextWithoutAnEndAndNotesIt) {
  const std::string whole = textStlOf(box());
  const std::string bare = whole.substr(0, whole.find("endsolid"));
  for (const std::string& text : {bare, replaced(bare, "\n", "\r\n"), replaced(bare, "\n", " ")}) {
    expectSameBox("a.stl", text);
    EXPECT_THAT(
        readMesh("a.stl", text).closing.notes,
        ElementsAre("it has no \"endsolid\" behind its last triangle: others may be missing"));
  }
  for (const std::string& text : {whole, upperCase(whole), replaced(whole, "end", "end "),
                                  binaryStlOf(box()), "solid b\nendsolid b\n" + whole})
    EXPECT_THAT(readMesh("a.stl", text).closing.notes, IsEmpty());
  EXPECT_THAT(readStl(whole + bare).notes, Not(IsEmpty()));
  expectSameBox("a.stl", bare.substr(bare.find("facet")));  // nor a beginning
}

TEST(StlReader, TakesATextInOneLine) {
  const std::string whole = textStlOf(box());
  for (const char* name : {"a name", "", "a facet of a solid", "facet", "normal facet  ", "2.5"}) {
    std::string text = replaced(replaced(whole, "a name", name), "\n", " ");
    expectSameBox("a.stl", text);
    expectSameBox("a.stl", upperCase(text));
  }
  // Two solids
  const std::size_t middle = whole.find("endfacet") + 9;
  expectSameBox("a.stl", replaced(whole.substr(0, middle) + "endsolid\nsolid more of it\n" +
                                      whole.substr(middle),
                                  "\n", "  "));
}

TEST(StlReader, TakesSpareBytes) {
  for (const char* comment : {"solid, it says", "made by hand", "SOLID"}) {
    const std::string whole = binaryStlOf(box(), comment);
    for (const std::string& spare : {std::string("\n"), std::string("\r\n"), std::string("x"),
                                     std::string(100, '\0'), std::string("\x1a")})
      expectSameBox("a.stl", whole + spare);
  }
}

TEST(StlReader, SaysHowManyBytesAreTooMany) {
  for (const char* comment : {"solid, it says", "made by hand"}) {
    EXPECT_MESSAGE(messageOf([&] { readStl(binaryStlOf(box(), comment) + "and more"); }));
  }
}

/// Returns the box with its faces before its vertices.
std::string facesFirst(const std::string& ply) {
  const std::size_t vertices = ply.find("element vertex"), faces = ply.find("element face"),
                    end = ply.find("end_header\n") + 11;
  std::size_t middle = end;
  for (int i = 0; i < 8; ++i) middle = ply.find('\n', middle) + 1;
  return ply.substr(0, vertices) + ply.substr(faces, end - 11 - faces) +
         ply.substr(vertices, faces - vertices) + "end_header\n" + ply.substr(middle) +
         ply.substr(end, middle - end);
}

TEST(PlyReader, TakesElementsInAnyOrder) {
  expectSameBox("a.ply", facesFirst(textPlyOf(box())));
  const std::string wrong = replaced(facesFirst(textPlyOf(box())), "3 0 4 6", "3 0 4 8");
  EXPECT_MESSAGE(messageOf([&] { readPly(wrong); }));
}

// The sides of the box as one strip, its ends as two more.
TEST(PlyReader, TakesStrips) {
  std::string ply = textPlyOf(box());
  ply.resize(ply.find("element face"));
  std::string text = textPlyOf(box());
  const std::size_t end = text.find("end_header\n") + 11;
  std::size_t faces = end;
  for (int i = 0; i < 8; ++i) faces = text.find('\n', faces) + 1;
  ply += "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
         text.substr(end, faces - end) + "20 0 4 2 6 3 7 1 5 0 4 -1 0 2 1 3 -1 4 5 6 7\n";
  expectSameBox("a.ply", ply);
}

TEST(PlyReader, TakesCommentsAfterItsData) {
  expectSameBox("a.ply", textPlyOf(box()) + "comment unit m\ncomment\n");
}

// A carriage return ends the header of a binary file whose data may begin with a line feed.
TEST(PlyReader, TakesHeadersThatEndInAnyWay) {
  for (const bool isBigEndian : {false, true}) {
    const std::string ply = testing::binaryPlyOf(box(), isBigEndian);
    const std::size_t end = ply.find("end_header\n") + 11;
    for (const char* line : {"\r", "\r\n"})
      expectSameBox("a.ply", replaced(ply.substr(0, end), "\n", line) + ply.substr(end));
  }
}

TEST(PlyReader, SaysWhichNamesItMisses) {
  EXPECT_MESSAGE(messageOf([] { readPly(replaced(textPlyOf(box()), "_indices", "_idx")); }));
  EXPECT_MESSAGE(
      messageOf([] { readPly(replaced(textPlyOf(box()), "double z", "double height")); }));
}

}  // namespace
}  // namespace rotatebook::meshes
