#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/graph/mesh_graph.h"

namespace geolloyd {

/// The exact distance, in mesh units, between two points on, or for barycentres near, a surface.
using ExactDistance = std::function<double(const Vec3& a, const Vec3& b)>;

/// By how much the distances on a graph differ from exact ones: (graph - exact) / exact.
struct GraphError {
  std::size_t pairs = 0;
  double mean = 0;
  double rms = 0;
  double smallest = 0;  ///< negative where the graph has a shorter way than the surface
  double largest = 0;
};

/// Distances from one node to all, mesh units; infinite where there is no way.
std::vector<double> graph_distances(const Graph& graph, NodeId source);

/// Over the pairs of `sources` nodes, drawn at random, with all nodes at an exact
/// distance of at least `nearest` > 0 that they can reach. All 0 where there is no such pair.
GraphError measure_graph_error(const MeshGraph& mesh_graph, std::size_t sources,
                               std::uint64_t random_seed, double nearest,
                               const ExactDistance& exact);

}  // namespace geolloyd
