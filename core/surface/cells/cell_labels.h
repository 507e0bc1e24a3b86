#pragma once

#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/surface/substrate/fine_mesh.h"

namespace geolloyd {

/// Leaves each site the largest of the connected components of its cell, by vertices; of equals,
/// that with the smallest vertex; one with vertices that are fixed before others. The other
/// vertices lose their labels.
void keep_one_component(const FineMesh& mesh, std::size_t sites,
                        std::span<const std::uint8_t> is_fixed, std::vector<RegionId>& labels,
                        Executor& executor = sequential());

/// Gives vertices without a label that of the nearest of their neighbours' sites, of equals the
/// smallest, in rounds, so that no cell falls apart. Vertices that no label reaches stay
/// without.
void fill_gaps(const FineMesh& mesh, std::span<const Vec3> sites, std::vector<RegionId>& labels);

/// Per site: the mean inverse sizing of the vertices of its cell, 1 where it has none. Empty where
/// the mesh has no inverse sizing.
std::vector<double> inverse_sizing_at_sites(const FineMesh& mesh, std::size_t sites,
                                            std::span<const RegionId> labels);

/// Per site: the mean over the vertices of its cell of their metric, counted by the square of the
/// inverse sizing, so that its lengths are in spacings; that of even space where it has none. Empty
/// where the mesh has no metric.
std::vector<Metric> metric_at_sites(const FineMesh& mesh, std::size_t sites,
                                    std::span<const RegionId> labels);

/// Per site: the vertex of its cell, not fixed, that is farthest from it, and the square of that
/// distance; of equals, the smallest. no_id where it has none.
struct FarthestVertex {
  VertexId vertex = no_id;
  double square_distance = 0;
};
std::vector<FarthestVertex> farthest_vertices(const FineMesh& mesh, std::span<const Vec3> sites,
                                              std::span<const std::uint8_t> is_fixed,
                                              std::span<const RegionId> labels);

}  // namespace geolloyd
