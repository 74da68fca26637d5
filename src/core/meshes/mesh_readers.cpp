#include "meshes/mesh_readers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "meshes/foreign_files.h"
#include "meshes/mesh_words.h"

namespace rotatebook::meshes {
namespace {

template <body::TriangleMesh (*kRead)(std::string_view)>
NotedSurface plainSurface(std::string_view bytes) {
  return {{.mesh = kRead(bytes)}};
}

struct Format {
  std::string_view ending;
  NotedSurface (*read)(std::string_view);
};
constexpr Format kFormats[] = {{".obj", plainSurface<readObj>},
                               {".stl", readStl},
                               {".ply", plainSurface<readPly>},
                               {".glb", readGlb}};

const Format* formatOf(std::string_view name) {
  const std::string ending = lowerCase(name.substr(std::min(name.rfind('.'), name.size())));
  for (const Format& format : kFormats) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

/// Returns what `read` makes of a file by the format of its name. Throws InputError that begins
/// with it.
template <typename Read>
auto atName(std::string_view name, std::string_view bytes, const Read& read) {
  const std::string file = oneLine(name, 200);
  const Format* format = formatOf(name);
  if (format == nullptr) {
    throw InputError(file + ": not a mesh that can be read; export it as " +
                     joinedOf(kFormats, [](const Format& f) { return std::string(f.ending); }));
  }
  try {
    return read(*format);
  } catch (const InputError& error) {
    const std::string other = otherKind(format->ending, bytes);
    throw InputError(file + ": " + (other.empty() ? error.what() : other));
  }
}

}  // namespace

bool isMeshName(std::string_view name) {
  return formatOf(name) != nullptr;
}

body::ClosedMesh readMesh(std::string_view name, std::string_view bytes) {
  return atName(name, bytes, [&](const Format& format) {
    NotedSurface read = format.read(bytes);
    body::Closing closing = closeSurface(read.surface);
    closing.notes.insert(closing.notes.end(), read.notes.begin(), read.notes.end());
    return body::ClosedMesh{std::move(read.surface), std::move(closing),
                            std::move(read.undrawable)};
  });
}

}  // namespace rotatebook::meshes
