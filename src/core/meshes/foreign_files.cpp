#include "meshes/foreign_files.h"

#include <algorithm>

#include "base/file_text.h"
#include "base/text.h"
#include "meshes/mesh_words.h"

namespace rotatebook::meshes {
namespace {

/// A kind of file by its first bytes.
struct Beginning {
  std::string_view bytes;
  std::string_view sentence;
};

constexpr std::string_view kUtf32 = "its text is in UTF-32; save it in UTF-8";
constexpr Beginning kBeginnings[]{
    {"\x1F\x8B", "it is compressed by gzip; unpack it"},
    {"BZh", "it is compressed by bzip2; unpack it"},
    {"\xFD\x37zXZ", "it is compressed by xz; unpack it"},
    {"\x28\xB5\x2F\xFD", "it is compressed by zstd; unpack it"},
    {"7z\xBC\xAF\x27\x1C", "it is an archive of 7-Zip; unpack it"},
    {"PK\x03\x04", "it is a ZIP archive, as .3mf is, too; unpack it, or export the mesh as .stl"},
    {std::string_view("\xFF\xFE\0\0", 4), kUtf32},
    {std::string_view("\0\0\xFE\xFF", 4), kUtf32},
    {"version https://git-lfs",
     "it is a pointer of git-lfs in the place of the file; fetch that with \"git lfs pull\""},
    {"Kaydara FBX", "it is an FBX file, which isn't read; export it as .glb"},
    {"BLENDER", "it is a file of Blender, which isn't read; export it as .glb"},
    {"ISO-10303-21", "it is a STEP file, which isn't read; export its mesh as .stl"},
    {"\x89PNG", "it is a picture (PNG), no mesh"},
    {"\xFF\xD8\xFF", "it is a picture (JPEG), no mesh"},
    {"%PDF", "it is a PDF, no mesh"},
};
/// Texts, in small letters, behind blanks.
constexpr Beginning kTexts[]{
    {"<!doctype html", "it is a web page; download the file that it shows"},
    {"<html", "it is a web page; download the file that it shows"},
    {"<?xml", "it is XML, as Collada and X3D are, which isn't read; export it as .glb"},
    {"; fbx", "it is an FBX file, which isn't read; export it as .glb"},
    {"#vrml", "it is a VRML file, which isn't read; export it as .ply"},
    {"off\n", "it is an OFF file, which isn't read; export it as .ply"},
    {"off\r", "it is an OFF file, which isn't read; export it as .ply"},
    {"{", "it is JSON, as glTF's text (.gltf) is, which isn't read; export it as .glb"},
};

template <typename Beginnings>
std::string_view sentenceOn(std::string_view bytes, const Beginnings& beginnings) {
  const auto found = std::ranges::find_if(
      beginnings, [&](const Beginning& one) { return bytes.starts_with(one.bytes); });
  return found != std::end(beginnings) ? found->sentence : std::string_view();
}

/// Returns whether each of the first letters has four bytes, three of which are zeros.
bool isBareUtf32(std::string_view bytes) {
  constexpr std::size_t kLetters = 4, kSize = 4;
  if (bytes.size() < kLetters * kSize) return false;
  const auto isLetter = [&](std::size_t at, std::size_t byte) {
    for (std::size_t i = 0; i < kSize; ++i)
      if ((bytes[at + i] != '\0') != (i == byte)) return false;
    return true;
  };
  for (const std::size_t byte : {std::size_t{0}, kSize - 1}) {
    bool isText = true;
    for (std::size_t i = 0; i < kLetters; ++i) isText = isText && isLetter(i * kSize, byte);
    if (isText) return true;
  }
  return false;
}

/// Returns whether a text has a line of OBJ with a point.
bool hasPointOfObj(std::string_view text) {
  MeshWords words(text, MeshWords::Syntax::Wavefront);
  do {
    if (lowerCase(words.word()) != "v") continue;
    if (numberIn(words.word()) && numberIn(words.word()) && numberIn(words.word())) return true;
  } while (words.nextLine());
  return false;
}

/// Returns the ending of meshes such as this; empty if it seems to be none.
std::string_view endingOf(std::string_view bytes, std::string_view text) {
  if (bytes.starts_with("glTF")) return ".glb";
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return ".ply";
  const std::string small = lowerCase(text);
  if (trimmed(small).starts_with("solid") && small.find("facet") != small.npos) return ".stl";
  if (hasSizeOfStl(bytes)) return ".stl";
  return hasPointOfObj(text) ? ".obj" : "";
}

std::string upperCaseName(std::string_view ending) {
  std::string name;
  for (const char letter : ending.substr(1)) name += static_cast<char>(letter - 'a' + 'A');
  return name;
}

}  // namespace

bool hasSizeOfStl(std::string_view bytes) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  if (bytes.size() <= kHeader) return false;
  const std::size_t count = MeshBytes(bytes.substr(kHeader - 4)).next<std::uint32_t>();
  const std::size_t size = bytes.size() - kHeader;
  return size % kTriangle == 0 && size / kTriangle == count;
}

std::string otherKind(std::string_view ending, std::string_view bytes) {
  constexpr std::size_t kBeginning = 1 << 16;
  if (bytes.empty()) return "it is empty";
  if (bytes.find_first_not_of('\0') == bytes.npos)
    return "it has nothing but zeros; copy or export it again";
  if (const auto sentence = sentenceOn(bytes, kBeginnings); !sentence.empty())
    return std::string(sentence);
  if (isBareUtf32(bytes)) return std::string(kUtf32);
  std::string decoded;
  const std::string_view text = textOfFile(bytes.substr(0, kBeginning), decoded);
  const std::string_view found = endingOf(bytes, text);
  if (found == ending) return "";
  if (!found.empty()) {
    return "it is " + std::string(found == ".obj" || found == ".stl" ? "an " : "a ") +
           upperCaseName(found) + " file; name it so that it ends in " + std::string(found);
  }
  return std::string(sentenceOn(lowerCase(trimmed(text.substr(0, 1000))), kTexts));
}

}  // namespace rotatebook::meshes
