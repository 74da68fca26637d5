// Readers of meshes: OBJ, STL, PLY and glTF.
#pragma once

#include <string_view>

#include "body/surface.h"
#include "body/triangle_mesh.h"

namespace rotatebook::body {

// Each takes a file's bytes and returns its triangles as they are there: `welded()` joins them, and
// `requireClosed()` judges them. Polygons become fans, which have the polygon's integrals if it is
// plane, convex or not. All throw InputError with the line or the byte, and the remedy, for what
// isn't that format, is cut off, or has more than kMaxTriangles.

/// Reads Wavefront's OBJ: `v` and `f`; everything else is skipped.
TriangleMesh readObj(std::string_view text);

/// Reads STL, text or binary.
TriangleMesh readStl(std::string_view bytes);

/// Reads Stanford's PLY, text or binary, of either byte order: the elements `vertex` with x, y and
/// z, and `face` with a list of vertices.
TriangleMesh readPly(std::string_view bytes);

/// Reads glTF 2.0 in one file (.glb): the triangles of the scene that it shows, or of all its
/// nodes, in their places. Its unit is the metre.
TriangleMesh readGlb(std::string_view bytes);

/// Reads the same triangles with their materials, and the first set of texture coordinates of each
/// that has a picture. Throws also for pictures outside the file.
Surface readGlbSurface(std::string_view bytes);

/// Reads a mesh by the ending of its name, .obj, .stl, .ply or .glb, and returns it welded. Throws
/// InputError, which begins with the name, also for other endings.
TriangleMesh readMesh(std::string_view name, std::string_view bytes);

/// Reads a surface likewise; but for GLB, all of it has the first, neutral, material.
Surface readSurface(std::string_view name, std::string_view bytes);

/// Returns whether the name ends like that of a mesh.
bool isMeshName(std::string_view name);

}  // namespace rotatebook::body
