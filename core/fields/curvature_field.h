#pragma once

#include <vector>

#include "core/base/executor.h"
#include "core/mesh/connectivity.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// The most that one magnitude of a curvature field is times the other at a vertex.
inline constexpr double most_stretch = 4;

/// A tangent space per vertex: the principal directions of curvature, the first with the larger
/// one, and magnitudes that go as the roots of the principal curvatures' absolute values. So equal
/// lengths in the metric are equal heights of the surface above its chords. Magnitudes are equal
/// where curvatures are, or both are under a 32nd of the mean; a curvature counts at most 32 means.
/// The mean of the product of magnitudes over the surface is 1. Everything is isotropic where the
/// surface is as flat as a sphere 1000 times as large, and at vertices without a normal.
///
/// The curvature is that of edges, by their bends, over the area around a vertex (Cohen-Steiner and
/// Morvan 2003), each bend as the chord between unit normals. It is averaged over some five edges,
/// as tensors transported from plane to plane. That needs no orientation of the surface.
/// Non-manifold edges have no bend. O(triangles). How curved a surface is at the scale of a remesh
/// is another question (core/surface/sizing/curvature.h).
std::vector<TangentSpace> curvature_field(const Mesh& mesh, const MeshEdges& edges,
                                          Executor& executor = sequential());

/// The same, of a mesh whose edges_at_vertices() are at hand.
std::vector<TangentSpace> curvature_field(const Mesh& mesh, const MeshEdges& edges,
                                          const Bucketed<std::uint32_t>& edges_at,
                                          Executor& executor);

}  // namespace geolloyd
