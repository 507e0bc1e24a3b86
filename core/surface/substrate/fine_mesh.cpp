#include "core/surface/substrate/fine_mesh.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "core/mesh/connectivity.h"

namespace geolloyd {
namespace {

void find_triangles_at_vertices(FineMesh& mesh, Executor& executor) {
  const auto at = triangles_at_vertices(mesh.vertex_count(), mesh.triangles, executor);
  mesh.first_triangle.assign(1, 0);
  mesh.first_triangle.insert(mesh.first_triangle.end(), at.end.begin(), at.end.end());
  mesh.triangle_at.assign(at.entry.begin(), at.entry.end());
}

// The edges at a vertex, each with the corners opposite to it of its triangles.
class EdgesAtVertex {
 public:
  void find(const FineMesh& mesh, VertexId v) {
    entries_.clear();
    for (const TriangleId t : mesh.triangles_at(v)) {
      const Triangle& corners = mesh.triangles[t];
      for (std::uint32_t c = 0; c < 3; ++c) {
        if (corners[c] == v) continue;
        const std::uint32_t opposite = corners[(c + 1) % 3] == v ? (c + 2) % 3 : (c + 1) % 3;
        entries_.push_back((std::uint64_t{corners[c]} << 32) | (3 * t + opposite));
      }
    }
    sort_entries(entries_);
  }

  /// Calls visit(other end, corners) for each edge, by other end ascending.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t first = 0; first < entries_.size();) {
      const auto end = static_cast<VertexId>(entries_[first] >> 32);
      std::size_t last = first;
      while (last < entries_.size() && entries_[last] >> 32 == end) ++last;
      visit(end, std::span(entries_).subspan(first, last - first));
      first = last;
    }
  }

 private:
  std::vector<std::uint64_t> entries_;  // other end, corner; ascending
};

// What lies beyond the edge of the two corners.
void join_across(FineMesh& mesh, std::uint64_t first, std::uint64_t second) {
  const auto a = static_cast<std::uint32_t>(first);
  const auto b = static_cast<std::uint32_t>(second);
  mesh.across_open[a / 3][a % 3] = mesh.triangles[b / 3][b % 3];
  mesh.across_open[b / 3][b % 3] = mesh.triangles[a / 3][a % 3];
}

// One pass: the neighbours of each range of vertices are kept until it is known where they go.
void find_neighbours(FineMesh& mesh, Executor& executor) {
  mesh.across_open.assign(mesh.triangle_count(), {no_id, no_id, no_id});
  mesh.first_neighbour.assign(mesh.vertex_count() + 1, 0);
  std::vector<std::vector<VertexId>> of_range(mesh.vertex_count() / small_items + 1);
  parallel_for_ranges(executor, mesh.vertex_count(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        EdgesAtVertex edges;
                        std::vector<VertexId>& found = of_range[begin / small_items];
                        found.reserve(mesh.first_triangle[end] - mesh.first_triangle[begin]);
                        for (auto v = static_cast<VertexId>(begin); v < end; ++v) {
                          const std::size_t before = found.size();
                          edges.find(mesh, v);
                          edges.for_each([&](VertexId u, std::span<const std::uint64_t> corners) {
                            found.push_back(u);
                            if (v < u && corners.size() == 2) {
                              join_across(mesh, corners[0], corners[1]);
                            }
                          });
                          mesh.first_neighbour[v] =
                              static_cast<std::uint32_t>(found.size() - before);
                        }
                      });
  mesh.neighbour.resize(exclusive_scan<std::uint32_t>(executor, mesh.first_neighbour));
  parallel_for(executor, of_range.size(), 1, [&](std::size_t range) {
    std::copy(of_range[range].begin(), of_range[range].end(),
              mesh.neighbour.begin() + mesh.first_neighbour[range * small_items]);
    of_range[range] = std::vector<VertexId>();
  });
}

// Of all triangles, in their order.
double sum_in_order(const FineMesh& mesh, Executor& executor,
                    double (FineMesh::*of_triangle)(TriangleId) const) {
  std::vector<double> values(mesh.triangle_count());
  parallel_for(executor, values.size(), small_items,
               [&](std::size_t t) { values[t] = (mesh.*of_triangle)(static_cast<TriangleId>(t)); });
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

void find_whole(FineMesh& mesh, Executor& executor) {
  mesh.whole_area = sum_in_order(mesh, executor, &FineMesh::area);
  mesh.whole_sized_area = mesh.whole_area;
  mesh.whole_mass = mesh.whole_area;
  if (mesh.inverse_sizing.empty()) return;
  mesh.whole_sized_area = sum_in_order(mesh, executor, &FineMesh::sized_area);
  mesh.whole_mass = sum_in_order(mesh, executor, &FineMesh::mass);
}

void close_edges(FineMesh& mesh, std::span<const std::array<VertexId, 2>> edges) {
  for (const auto& edge : edges) {
    for (const TriangleId t : mesh.triangles_at(edge[0])) {
      const Triangle& corners = mesh.triangles[t];
      for (std::size_t c = 0; c < 3; ++c) {
        if (ascending(corners[(c + 1) % 3], corners[(c + 2) % 3]) == edge) {
          mesh.across_open[t][c] = no_id;
        }
      }
    }
  }
}

void connect(FineMesh& mesh, Executor& executor) {
  mesh.largest_trace = 1;
  for (const Metric& m : mesh.metric) mesh.largest_trace = std::max(mesh.largest_trace, m.trace());
  find_whole(mesh, executor);
  find_triangles_at_vertices(mesh, executor);
  find_neighbours(mesh, executor);
}

}  // namespace geolloyd
