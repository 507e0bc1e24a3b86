#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "geolloyd/properties.h"
#include "geolloyd/types.h"

namespace geolloyd {

/// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<VertexId, 3>;

/// Triangles with shared vertices, in input order. Coordinates are finite and at most 1e75;
/// vertices of triangles are below positions.size(). Nothing else is required: holes, several
/// components, triangles without area and non-manifold edges are all handled.
struct Mesh {
  std::vector<Vec3> positions;  ///< mesh units
  std::vector<Triangle> triangles;

  [[nodiscard]] std::size_t vertex_count() const { return positions.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return triangles.size(); }
};

/// Throws InvalidInput where a mesh made by hand breaks one of these rules, or has no triangle. The
/// message names the vertex or triangle. All functions that take a mesh call this; write and
/// the functions of quality.h accept a mesh without triangles, too.
void validate(const Mesh& mesh);

/// A mesh as a file holds it, and what reading it had to do.
struct LoadedMesh {
  Mesh mesh;
  std::string format;              ///< for people: "PLY, binary little endian"
  std::size_t polygon_count = 0;   ///< faces of four and more corners, split into triangles
  std::size_t welded_corners = 0;  ///< STL and glTF: corners that fell on an earlier one
  /// Per vertex: the one that stands for it in all triangles, itself or one in the same place.
  /// Empty: none was welded.
  std::vector<VertexId> welded_to = {};
  std::size_t welded_vertices = 0;  ///< that are another one now
  Properties properties;            ///< if they were asked for
};

struct ReadOptions {
  bool properties = false;  ///< read them, too: they may take more memory than the mesh
  std::uint64_t most_bytes = std::numeric_limits<std::uint64_t>::max();  ///< of an unpacked file
  bool weld = true;  ///< vertices that are split in the file: see read
};

/// Reads PLY, OBJ, OFF/COFF, STL, GLB, glTF, Gmsh or medit, told by the extension, also packed by
/// gzip or zstd ("scan.ply.gz"), which the first bytes tell.
///
/// A polygon of n corners becomes n - 2 triangles, in order, so triangle ids count those: a fan
/// around its first corner, or, where it is concave and flat, others that cover it. Throws IoError
/// where the file cannot be read, InvalidInput where it cannot be used (syntax, non-finite or
/// over-large coordinate, index out of range, no triangles), naming file and line or byte offset.
/// Never takes memory that the size of the file does not warrant.
///
/// Many files have a vertex several times, once for each normal or texture coordinate at it. Such
/// vertices, whose places are the same to the bit, are welded: triangles name the first of them.
/// All vertices stay, with their numbers, those that nothing names any more as well. Welded are the
/// ends of two boundary edges in the same place, so surfaces that merely touch stay apart
/// (core/seams/stitching.h). Vertices of STL and glTF have one number per place. STL always has.
///
/// Properties are the numbers of a PLY file's vertices and faces, OBJ's colours, texture
/// coordinates and normals where a vertex has the same in all faces, and its groups and materials
/// (numbered in order of appearance), and COFF's colours and normals. A malformed property is
/// refused in the same way if properties are asked for; else nobody looks at it.
LoadedMesh read(const std::filesystem::path& path, const ReadOptions& options = {});

/// Writes PLY (binary little endian), OBJ, OFF or STL (binary), told by the extension; packed where
/// ".gz" or ".zst" stands behind it. The file appears whole or not at all. No coordinate loses a
/// digit, except in STL, which knows float32 only. PLY holds all properties, with their bits, OBJ
/// and OFF colours, normals and texture coordinates of vertices, OFF also colours of triangles, STL
/// none; the others are left out. Throws IoError where the file cannot be written, InvalidInput
/// where the mesh is not valid, or where properties do not fit it.
void write(const std::filesystem::path& path, const Mesh& mesh, const Properties& properties = {});

}  // namespace geolloyd
