#pragma once

#include "core/repair/mesh_under_repair.h"
#include "geolloyd/repair.h"

namespace geolloyd {

/// Removes slivers of a manifold, which stays one of the same topology: in turn, and as long as one
/// of these works, in order of triangles,
///
/// - a sliver with two boundary edges is left out;
/// - the shortest edge collapses, if it is shorter than a millionth of the longest one; the vertex
///   that remains is one on the boundary, then one with fewer triangles moves, then the smaller
///   one remains;
/// - the longest edge flips, if the flatter of its two triangles is less flat then; or the sliver
///   is left out if that edge is on the boundary and the corner opposite to it is not.
///
/// Nothing is done that turns a triangle by 60 degrees and more, or at a vertex of more than 256
/// triangles where all of them would have to be looked at. Near-linear.
void remove_slivers(MeshUnderRepair& state, Repairs& repairs);

}  // namespace geolloyd
