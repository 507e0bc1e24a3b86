#pragma once

#include <vector>

#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// The edges with two triangles that are features, each by its triangles; ascending. Creases are
/// found by the angle between normals: components of edges from 40 degrees on that
/// have one from 60 on, are nearly all that sharp, and are surrounded by flat edges; none where
/// such components have less than half of the length of all edges from 40 degrees on, as on scans.
/// Of creases, curves with a loose end and pieces are left out where they are shorter than 6
/// `spacing`s (mesh units) or have fewer than 6 edges; where the angle was given, than 2 spacings.
/// Throws InvalidInput where an edge or a group of `options` is not one of the mesh.
std::vector<TrianglePair> find_features(const Mesh& mesh, const MeshEdges& edges,
                                        const FeatureOptions& options, double spacing,
                                        Executor& executor = sequential());

}  // namespace geolloyd
