// Readers of meshes: OBJ, STL, PLY and glTF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "body/closed_mesh.h"
#include "body/surface.h"
#include "body/triangle_mesh.h"

namespace rotatebook::meshes {

// Each takes a file's bytes and returns its triangles as they are there; closeSurface() joins and
// judges them. Polygons become fans, which have the polygon's integrals if it is plane, convex or
// not. All throw InputError with the line or the byte, and the remedy, for what isn't that format,
// is cut off, or has more than kMaxTriangles.

/// Reads Wavefront's OBJ: `v` and `f`, with lines that go on after a backslash; everything else is
/// skipped.
body::TriangleMesh readObj(std::string_view text);

/// Reads Stanford's PLY, text or binary, of either byte order: the elements `vertex` with x, y and
/// z, and `face` or `tristrips` with lists of vertices, in any order.
body::TriangleMesh readPly(std::string_view bytes);

/// The surface of a file, and sentences on what of it isn't read or drawn.
struct NotedSurface {
  body::Surface surface;
  std::vector<std::string> notes{};
  std::string undrawable{};  ///< Why its look can't be read; it is neutral then. Empty if it can.
};

/// Reads STL, text or binary; words in any case.
NotedSurface readStl(std::string_view bytes);

/// Reads glTF 2.0 in one file (.glb): the triangles of the scene that it shows, or of all its
/// nodes, in their places, with the weights of their morph targets and in the pose of their
/// skeletons; with their materials, and the texture coordinates of their pictures. Its unit is the
/// metre.
NotedSurface readGlb(std::string_view bytes);

/// Reads a mesh by the ending of its name, .obj, .stl, .ply or .glb, and closes it. Throws
/// InputError, which begins with the name, also for other endings, and for what isn't closed; what
/// can't be read and is of another kind is called that. But for GLB, all of it has the first,
/// neutral, material.
body::ClosedMesh readMesh(std::string_view name, std::string_view bytes);

/// Returns whether the name ends like that of a mesh.
bool isMeshName(std::string_view name);

}  // namespace rotatebook::meshes
