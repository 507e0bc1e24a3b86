#include "core/seams/stitching.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/mesh/mesh_edges.h"
#include "core/seams/places.h"

namespace geolloyd {
namespace {

// An edge of the mesh, and the places of its ends.
struct PlacedEdge {
  std::array<VertexId, 2> places;
  std::uint32_t edge = 0;
};

using EdgePair = std::array<std::uint32_t, 2>;

// What is stitched, and so what may come of it.
enum class Seams {
  cracks,  // of any mesh: no component gets more boundary loops than its parts had
  splits   // vertices that a file has several times
};

class Stitcher {
 public:
  Stitcher(const Mesh& mesh, Seams seams, std::vector<VertexId> place)
      : mesh_(mesh), seams_(seams), edges_(find_edges(mesh)), place_(std::move(place)) {}

  /// Per vertex: that which it becomes.
  std::vector<VertexId> run() {
    std::vector<VertexId> name(mesh_.vertex_count());
    for (VertexId v = 0; v < name.size(); ++v) name[v] = v;
    if (!has_boundary()) return name;
    find_pairs();
    // Each round takes back some pairs; after too many rounds all of them are.
    constexpr int most_rounds = 16;
    for (int round = 0;; ++round) {
      if (round == most_rounds) pairs_.clear();
      DisjointSets merged(mesh_.vertex_count());
      for (const EdgePair& pair : pairs_) join(pair, merged);
      for (VertexId v = 0; v < name.size(); ++v) name[v] = merged.find(v);
      if (pairs_.empty() || !take_back(name)) break;
    }
    return name;
  }

 private:
  [[nodiscard]] bool is_boundary(std::uint32_t edge) const {
    return edges_.corners(edge).size() == 1;
  }
  [[nodiscard]] bool has_boundary() const {
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (is_boundary(e)) return true;
    }
    return false;
  }

  // All edges whose ends are in places of the boundary, those in the same place beside each other.
  std::vector<PlacedEdge> edges_by_place() {
    std::vector<std::uint8_t> is_on_boundary(mesh_.vertex_count(), 0);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (!is_boundary(e)) continue;
      for (const VertexId v : edges_.ends[e]) is_on_boundary[place_[v]] = 1;
    }
    std::vector<PlacedEdge> placed;
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const auto [a, b] = ascending(place_[edges_.ends[e][0]], place_[edges_.ends[e][1]]);
      if (a != b && is_on_boundary[a] != 0 && is_on_boundary[b] != 0) placed.push_back({{a, b}, e});
    }
    std::sort(placed.begin(), placed.end(), [](const PlacedEdge& x, const PlacedEdge& y) {
      return x.places != y.places ? x.places < y.places : x.edge < y.edge;
    });
    return placed;
  }

  // First those alone in their place, everywhere; then those alone within a component of what that
  // makes.
  void find_pairs() {
    const std::vector<PlacedEdge> placed = edges_by_place();
    DisjointSets connected(mesh_.vertex_count());
    for (const auto& [a, b] : edges_.ends) connected.unite(a, b);
    std::vector<std::uint32_t> at;
    std::vector<std::vector<std::uint32_t>> crowded;
    for (std::size_t i = 0; i < placed.size();) {
      at.clear();
      const auto& places = placed[i].places;
      for (; i < placed.size() && placed[i].places == places; ++i) at.push_back(placed[i].edge);
      if (at.size() > 2) crowded.push_back(at);
      if (at.size() == 2 && offer(at[0], at[1])) {
        connected.unite(edges_.ends[at[0]][0], edges_.ends[at[1]][0]);
      }
    }
    for (auto& edges : crowded) {
      const auto component = [&](std::uint32_t e) { return connected.find(edges_.ends[e][0]); };
      std::stable_sort(edges.begin(), edges.end(), [&](std::uint32_t x, std::uint32_t y) {
        return component(x) < component(y);
      });
      for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        while (end < edges.size() && component(edges[end]) == component(edges[i])) ++end;
        if (end - i == 2) offer(edges[i], edges[i + 1]);
        i = end;
      }
    }
  }

  bool offer(std::uint32_t first, std::uint32_t second) {
    if (!is_boundary(first) || !is_boundary(second)) return false;
    const CornerId corner = edges_.corners(first)[0];
    const CornerId other = edges_.corners(second)[0];
    if (triangle_of(corner) == triangle_of(other)) return false;
    if (seams_ == Seams::splits && lie_on_each_other(corner, other)) return false;
    pairs_.push_back({first, second});
    return true;
  }

  // Two triangles at one edge, as those of a sheet with a front and a back.
  [[nodiscard]] bool lie_on_each_other(CornerId corner, CornerId other) const {
    return place_[apex(mesh_, corner)] == place_[apex(mesh_, other)];
  }

  void join(const EdgePair& pair, DisjointSets& merged) const {
    const auto [a, b] = edges_.ends[pair[0]];
    const auto [c, d] = edges_.ends[pair[1]];
    const bool is_same_way = place_[a] == place_[c];
    merged.unite(a, is_same_way ? c : d);
    merged.unite(b, is_same_way ? d : c);
  }

  // Takes back the pairs at what they make worse. False where there are none.
  bool take_back(const std::vector<VertexId>& name) {
    const std::vector<std::uint8_t> is_bad = bad_vertices(name);
    const auto before = pairs_.size();
    std::erase_if(pairs_, [&](const EdgePair& pair) {
      return is_bad[name[edges_.ends[pair[0]][0]]] != 0 ||
             is_bad[name[edges_.ends[pair[0]][1]]] != 0;
    });
    return pairs_.size() < before;
  }

  [[nodiscard]] std::vector<std::uint8_t> bad_vertices(const std::vector<VertexId>& name) const {
    Mesh made{{}, mesh_.triangles};
    made.positions.resize(mesh_.vertex_count());
    rename_vertices(made, name);
    const MeshEdges edges = find_edges(made);
    std::vector<std::uint8_t> is_bad(name.size(), 0);
    blame_crowds(made, edges, is_bad);
    if (seams_ == Seams::splits) return is_bad;
    for (const Triangle& t : made.triangles) {
      if (has_three_vertices(t)) continue;
      for (const VertexId v : t) is_bad[v] = 1;
    }
    blame_loops(made, edges, name, is_bad);
    return is_bad;
  }

  // Where three triangles have come to meet at an edge, or two to have the same vertices.
  void blame_crowds(const Mesh& made, const MeshEdges& edges,
                    std::vector<std::uint8_t>& is_bad) const {
    for (const TriangleId t : edges.duplicates) {
      if (std::binary_search(edges_.duplicates.begin(), edges_.duplicates.end(), t)) continue;
      for (const VertexId v : made.triangles[t]) is_bad[v] = 1;
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.corners(e).size() <= 2 || was_one_edge(edges.corners(e))) continue;
      for (const VertexId v : edges.ends[e]) is_bad[v] = 1;
    }
  }

  [[nodiscard]] bool was_one_edge(std::span<const CornerId> corners) const {
    const auto ends = [&](CornerId c) {
      return ascending(edge_start(mesh_, c), edge_end(mesh_, c));
    };
    return std::all_of(corners.begin(), corners.end(),
                       [&](CornerId c) { return ends(c) == ends(corners[0]); });
  }

  // The components that have more loops.
  void blame_loops(const Mesh& made, const MeshEdges& edges, const std::vector<VertexId>& name,
                   std::vector<std::uint8_t>& is_bad) const {
    const std::vector<VertexId> component = components_of(made);
    std::vector<std::int64_t> surplus(name.size(), 0);
    count_loops(edges, surplus, component, 1);
    std::vector<VertexId> of_part(name.size());
    for (VertexId v = 0; v < of_part.size(); ++v) of_part[v] = component[name[v]];
    count_loops(edges_, surplus, of_part, -1);
    for (VertexId v = 0; v < is_bad.size(); ++v) {
      if (surplus[component[v]] > 0) is_bad[v] = 1;
    }
  }

  // Adds `sign` per boundary loop to its component.
  static void count_loops(const MeshEdges& edges, std::vector<std::int64_t>& count,
                          const std::vector<VertexId>& component, int sign) {
    DisjointSets loops(component.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.corners(e).size() != 1) continue;
      const auto [a, b] = edges.ends[e];
      if (!loops.unite(a, b)) count[component[a]] += sign;
    }
  }

  const Mesh& mesh_;
  Seams seams_;
  MeshEdges edges_;
  std::vector<VertexId> place_;
  std::vector<EdgePair> pairs_;
};

}  // namespace

std::vector<VertexId> components_of(const Mesh& mesh) {
  DisjointSets sets(mesh.vertex_count());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.unite(a, b);
    sets.unite(b, c);
  }
  std::vector<VertexId> component(mesh.vertex_count());
  for (VertexId v = 0; v < component.size(); ++v) component[v] = sets.find(v);
  return component;
}

void rename_vertices(Mesh& mesh, const std::vector<VertexId>& name) {
  for (Triangle& t : mesh.triangles) {
    for (VertexId& v : t) v = name[v];
  }
}

std::vector<VertexId> stitch_boundaries(Mesh& mesh) {
  std::vector<VertexId> name = Stitcher(mesh, Seams::cracks, places_of(mesh)).run();
  rename_vertices(mesh, name);
  return name;
}

std::vector<VertexId> find_split_vertices(const Mesh& mesh) {
  const auto are_apart = [](const std::vector<VertexId>& name) {
    for (VertexId v = 0; v < name.size(); ++v) {
      if (name[v] != v) return false;
    }
    return true;
  };
  std::vector<VertexId> place = places_of(mesh);
  if (are_apart(place)) return {};
  std::vector<VertexId> name = Stitcher(mesh, Seams::splits, std::move(place)).run();
  return are_apart(name) ? std::vector<VertexId>() : name;
}

}  // namespace geolloyd
