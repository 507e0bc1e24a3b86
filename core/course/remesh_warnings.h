#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// What is known of a mesh before it is remeshed, while all its edges are there.
struct InputSigns {
  bool is_closed = false;          ///< and oriented
  std::size_t split_vertices = 0;  ///< that reading would have welded
  double sharp_length = 0;         ///< of edges of 60 degrees and more between flat triangles
  double area = 0;
  bool has_self_intersections = false;  ///< looked for only where the remesh has some
};

InputSigns find_signs(const Mesh& mesh, const MeshEdges& edges, Executor& executor);

/// What is bad about a remesh of this mesh, if anything. All limits are in the .cpp. What the
/// options ask for is not bad: no features, no fit, edges of several lengths.
std::vector<RemeshWarning> find_warnings(const Mesh& mesh, const InputSigns& signs,
                                         const RemeshOptions& options, const Remesh& remesh);

/// Adds the warning of a distance from the input to the remesh that is large beside the input's
/// diagonal: for those who have measured it.
void warn_of_distance(double largest, double diagonal, Remesh& remesh);

/// How much more is inside a remesh than inside its mesh, as a share; nothing unless both are
/// closed.
std::optional<double> volume_error(const Mesh& mesh, bool is_closed, const Remesh& remesh);

}  // namespace geolloyd
