#pragma once

#include <vector>

#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// The edges with two triangles that are features, each by its triangles; ascending. Creases are
/// chains of edges that turn by 40 degrees and more, from one junction of such edges to the next,
/// with a flat side along three quarters of their length, or planes on both (flat_sides.h): so each
/// is judged by what is beside it, and scans have none. Where an angle was given, all edges that
/// turn so far. Of creases, curves with a loose end and pieces are left out where they are shorter
/// than 6 `spacing`s (mesh units) or have fewer than 6 edges, and an edge between planes counts as
/// 16 of three times its length; where the angle was given, where they are shorter than 2 spacings.
/// Throws InvalidInput where an edge or a group of `options` is not one of the mesh.
std::vector<TrianglePair> find_features(const Mesh& mesh, const MeshEdges& edges,
                                        const FeatureOptions& options, double spacing,
                                        Executor& executor = sequential());

}  // namespace geolloyd
