#pragma once

#include <vector>

#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// The edges with two triangles that are features, each by its triangles; ascending: those given,
/// borders of groups, and creases.
///
/// Creases are chains of edges that turn by 40 degrees and more, from one junction of such edges to
/// the next. Along three quarters of a chain, the surface beside it is flat, or there are planes on
/// both sides (flat_sides.h): so each is judged by what is near it, and scans have none. Pieces,
/// and curves with a loose end, have at least 6 edges and a length of 6 `spacing`s (mesh units); an
/// edge between planes counts as 16, of three times its length. Where an angle was given, creases
/// are all edges that turn so far; only what is shorter than 2 spacings is left out. Throws
/// InvalidInput where an edge or a group of `options` is not one of the mesh.
std::vector<TrianglePair> find_features(const Mesh& mesh, const MeshEdges& edges,
                                        const FeatureOptions& options, double spacing,
                                        Executor& executor = sequential());

}  // namespace geolloyd
