#include "body/mesh_readers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "body/polygon.h"

namespace rotatebook::body {
namespace {

Surface plainSurface(TriangleMesh mesh) {
  return {.mesh = std::move(mesh)};
}

struct Format {
  std::string_view ending;
  TriangleMesh (*read)(std::string_view);
  Surface (*readSurface)(std::string_view);
};
constexpr Format kFormats[] = {
    {".obj", readObj, [](std::string_view bytes) { return plainSurface(readObj(bytes)); }},
    {".stl", readStl, [](std::string_view bytes) { return plainSurface(readStl(bytes)); }},
    {".ply", readPly, [](std::string_view bytes) { return plainSurface(readPly(bytes)); }},
    {".glb", readGlb, readGlbSurface}};

const Format* formatOf(std::string_view name) {
  std::string ending(name.substr(std::min(name.rfind('.'), name.size())));
  for (char& letter : ending) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  for (const Format& format : kFormats) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

/// Returns what `read` makes by the format of a name. Throws InputError that begins with it.
template <typename Read>
auto atName(std::string_view name, const Read& read) {
  const std::string file = oneLine(name, 200);
  const Format* format = formatOf(name);
  if (format == nullptr) {
    throw InputError(file + ": not a mesh that can be read; export it as " +
                     joinedOf(kFormats, [](const Format& f) { return std::string(f.ending); }));
  }
  try {
    return read(*format);
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

}  // namespace

bool isMeshName(std::string_view name) {
  return formatOf(name) != nullptr;
}

TriangleMesh readMesh(std::string_view name, std::string_view bytes) {
  return atName(name, [&](const Format& format) { return welded(format.read(bytes)); });
}

Surface readSurface(std::string_view name, std::string_view bytes) {
  return atName(name, [&](const Format& format) {
    Surface surface = format.readSurface(bytes);
    surface.mesh = welded(surface.mesh);
    return surface;
  });
}

}  // namespace rotatebook::body
