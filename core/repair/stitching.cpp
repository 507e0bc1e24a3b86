#include "core/repair/stitching.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/disjoint_sets.h"

namespace geolloyd {
namespace {

// An edge of the mesh, and the places of its ends.
struct PlacedEdge {
  std::array<VertexId, 2> places;
  std::uint32_t edge = 0;
};

using EdgePair = std::array<std::uint32_t, 2>;

class Stitcher {
 public:
  explicit Stitcher(const Mesh& mesh) : mesh_(mesh), edges_(find_edges(mesh)) {}

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
    place_ = places_of(mesh_);
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
    const TriangleId t = triangle_of(edges_.corners(first)[0]);
    if (t == triangle_of(edges_.corners(second)[0])) return false;
    pairs_.push_back({first, second});
    return true;
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

  // Those of edges with three triangles, of triangles that name a vertex twice or are the same, and
  // of components that have more loops.
  [[nodiscard]] std::vector<std::uint8_t> bad_vertices(const std::vector<VertexId>& name) const {
    Mesh made{{}, mesh_.triangles};
    made.positions.resize(mesh_.vertex_count());
    rename_vertices(made, name);
    const MeshEdges edges = find_edges(made);
    std::vector<std::uint8_t> is_bad(name.size(), 0);
    const auto blame = [&](const auto& vertices) {
      for (const VertexId v : vertices) is_bad[v] = 1;
    };
    for (const Triangle& t : made.triangles) {
      if (!has_three_vertices(t)) blame(t);
    }
    for (const TriangleId t : edges.duplicates) blame(made.triangles[t]);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.corners(e).size() > 2) blame(edges.ends[e]);
    }
    const std::vector<VertexId> component = components_of(made);
    std::vector<std::int64_t> surplus(name.size(), 0);
    count_loops(edges, surplus, component, 1);
    std::vector<VertexId> of_part(name.size());
    for (VertexId v = 0; v < of_part.size(); ++v) of_part[v] = component[name[v]];
    count_loops(edges_, surplus, of_part, -1);
    for (VertexId v = 0; v < is_bad.size(); ++v) {
      if (surplus[component[v]] > 0) is_bad[v] = 1;
    }
    return is_bad;
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
  MeshEdges edges_;
  std::vector<VertexId> place_;
  std::vector<EdgePair> pairs_;
};

}  // namespace

std::vector<VertexId> stitch_boundaries(Mesh& mesh) {
  std::vector<VertexId> name = Stitcher(mesh).run();
  rename_vertices(mesh, name);
  return name;
}

}  // namespace geolloyd
