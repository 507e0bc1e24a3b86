#include "core/dual/seed_insertion.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/disjoint_sets.h"

namespace geolloyd {
namespace {

using Edge = std::array<PointId, 2>;  // ascending
using Pair = std::array<RegionId, 2>;

// An edge within a region, and the triangles at it that lie within the region too.
struct InnerEdge {
  Edge ends = {no_id, no_id};
  std::array<std::uint32_t, 2> triangle = {no_id, no_id};
};

// Some ids, ascending, numbered without gaps.
class Numbering {
 public:
  void add(std::uint32_t id) { ids_.push_back(id); }
  void close() {
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  }
  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  [[nodiscard]] std::uint32_t operator[](std::uint32_t id) const {
    return static_cast<std::uint32_t>(std::lower_bound(ids_.begin(), ids_.end(), id) -
                                      ids_.begin());
  }

 private:
  std::vector<std::uint32_t> ids_;
};

// Pieces of curves, and which of them hang together.
class Curves {
 public:
  void add(Edge piece) { number_.emplace(piece, static_cast<std::uint32_t>(number_.size())); }
  void join(Edge a, Edge b) { joints_.emplace_back(a, b); }

  // Calls visit(part, point) for both ends of each piece.
  template <class Visit>
  void for_each_part(Visit&& visit) const {
    DisjointSets parts(number_.size());
    for (const auto& [a, b] : joints_) parts.unite(number_.at(a), number_.at(b));
    for (const auto& [piece, n] : number_) {
      for (const PointId p : piece) visit(parts.find(n), p);
    }
  }

 private:
  std::map<Edge, std::uint32_t> number_;
  std::vector<std::pair<Edge, Edge>> joints_;
};

class InsertionFinder {
 public:
  InsertionFinder(const RegionSurface& surface, const DualMesh& dual)
      : surface_(surface), dual_(dual), farthest_(surface.region_count, no_id) {}

  std::vector<SeedInsertion> run() {
    for (PointId p = 0; p < surface_.region.size(); ++p) {
      if (region(p) != no_id) improve(farthest_[region(p)], p);
    }
    gather();
    for (const ClosedBallViolation& violation : dual_.violations) {
      if (violation.is_of_input) continue;
      const std::size_t before = insertions_.size();
      switch (violation.kind) {
        case ViolationKind::region:
          close_loops(violation);
          part_boundaries(violation);
          break;
        case ViolationKind::contact:
          part_contact(violation);
          break;
        case ViolationKind::triple:
          add(violation, farthest_at_corners(violation));
          break;
        case ViolationKind::isolation:
          break;
      }
      for (const RegionId r : violation.regions) {
        if (insertions_.size() == before && r != no_id) add(violation, farthest_[r]);
      }
    }
    return std::move(insertions_);
  }

 private:
  [[nodiscard]] RegionId region(PointId p) const { return surface_.region[p]; }

  [[nodiscard]] bool is_farther(PointId a, PointId b) const {
    return std::tie(surface_.distance[a], a) > std::tie(surface_.distance[b], b);
  }

  // Where a seed for the sake of a point can be put.
  [[nodiscard]] PointId node_near(PointId p) const {
    return p < surface_.first_node ? surface_.nearest_node[p] : p;
  }

  // Another than the region's own.
  [[nodiscard]] bool is_open(PointId p) const { return surface_.distance[node_near(p)] > 0; }

  void improve(PointId& best, PointId p) const {
    if (is_open(p) && (best == no_id || is_farther(p, best))) best = p;
  }

  void add(const ClosedBallViolation& violation, PointId point) {
    if (point != no_id) insertions_.push_back({violation.regions, node_near(point)});
  }

  // What the violations are about: edges within regions, borders, and boundary.
  void gather() {
    std::vector<bool> is_asked(surface_.region_count, false);
    for (const ClosedBallViolation& v : dual_.violations) {
      if (v.is_of_input) continue;
      if (v.kind == ViolationKind::region) is_asked[v.regions[0]] = true;
      if (v.kind == ViolationKind::contact) contacts_[{v.regions[0], v.regions[1]}];
      if (v.kind == ViolationKind::triple) corners_[v.regions];
    }
    gather_boundaries(is_asked);
    for (std::uint32_t i = 0; i < surface_.triangles.size(); ++i) {
      const Triangle& t = surface_.triangles[i];
      const std::array<RegionId, 3> r = {region(t[0]), region(t[1]), region(t[2])};
      const bool is_inner = r[0] == r[1] && r[1] == r[2];
      if (!is_inner) gather_border(i, r);
      for (std::size_t c = 0; c < 3; ++c) {
        if (r[c] != r[(c + 1) % 3] || r[c] == no_id || !is_asked[r[c]]) continue;
        within_[r[c]].push_back({ascending(t[c], t[(c + 1) % 3]), {is_inner ? i : no_id, no_id}});
      }
    }
  }

  void gather_boundaries(const std::vector<bool>& is_asked) {
    for (const IrregularEdge& edge : surface_.irregular_edges) {
      if (edge.triangles != 1) continue;
      const auto [a, b] = edge.ends;
      for (const VertexId v : edge.ends) {
        if (is_asked[region(v)]) boundaries_[region(v)].add({v, v});
      }
      if (region(a) == region(b) && is_asked[region(a)]) {
        boundaries_[region(a)].join({a, a}, {b, b});
      }
    }
  }

  void gather_border(std::uint32_t i, const std::array<RegionId, 3>& r) {
    const Triangle& t = surface_.triangles[i];
    if (!corners_.empty()) {
      std::array<RegionId, 3> triple = r;
      std::sort(triple.begin(), triple.end());
      const auto found = corners_.find(triple);
      if (found != corners_.end()) found->second.push_back(i);
    }
    std::array<Edge, 3> last{};
    std::array<Curves*, 3> curve = {nullptr, nullptr, nullptr};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [a, b] = ascending(r[c], r[(c + 1) % 3]);
      const auto found = a == b ? contacts_.end() : contacts_.find({a, b});
      if (found == contacts_.end()) continue;
      curve[c] = &found->second;
      last[c] = ascending(t[c], t[(c + 1) % 3]);
      curve[c]->add(last[c]);
      for (std::size_t d = 0; d < c; ++d) {
        if (curve[d] == curve[c]) curve[c]->join(last[d], last[c]);
      }
    }
  }

  // Each edge once, with the triangles of the region at it.
  static void merge(std::vector<InnerEdge>& edges) {
    std::sort(edges.begin(), edges.end(), [](const InnerEdge& a, const InnerEdge& b) {
      return std::tie(a.ends, a.triangle[0]) < std::tie(b.ends, b.triangle[0]);
    });
    std::size_t kept = 0;
    for (const InnerEdge& e : edges) {
      if (kept > 0 && edges[kept - 1].ends == e.ends) {
        edges[kept - 1].triangle[1] = e.triangle[0];
      } else {
        edges[kept++] = e;
      }
    }
    edges.resize(kept);
  }

  // A tree of the nearest edges spans the region's points, a tree across the farthest of the others
  // its triangles and all that is outside; what is left closes one loop each that nothing fills
  // (tree and cotree: Erickson and Whittlesey 2005).
  void close_loops(const ClosedBallViolation& violation) {
    std::vector<InnerEdge>& edges = within_[violation.regions[0]];
    merge(edges);
    std::sort(edges.begin(), edges.end(), [this](const InnerEdge& a, const InnerEdge& b) {
      return std::tuple(later(a.ends), a.ends) < std::tuple(later(b.ends), b.ends);
    });
    Numbering points;
    Numbering faces;  // triangles, and no_id for all that is outside
    faces.add(no_id);
    for (const InnerEdge& e : edges) {
      for (std::size_t i = 0; i < 2; ++i) {
        points.add(e.ends[i]);
        faces.add(e.triangle[i]);
      }
    }
    points.close();
    faces.close();
    DisjointSets tree(points.size());
    std::vector<InnerEdge> others;
    for (const InnerEdge& e : edges) {
      if (!tree.unite(points[e.ends[0]], points[e.ends[1]])) others.push_back(e);
    }
    std::reverse(others.begin(), others.end());
    DisjointSets cotree(faces.size());
    for (const InnerEdge& e : others) {
      if (cotree.unite(faces[e.triangle[0]], faces[e.triangle[1]])) continue;
      PointId insertion = no_id;
      for (const PointId p : e.ends) improve(insertion, p);
      add(violation, insertion);
    }
  }

  // When the second of two points is reached.
  [[nodiscard]] double later(const Edge& e) const {
    return std::max(surface_.distance[e[0]], surface_.distance[e[1]]);
  }

  void part_boundaries(const ClosedBallViolation& violation) {
    const auto found = boundaries_.find(violation.regions[0]);
    if (found != boundaries_.end()) add(violation, farthest_of_nearest(found->second));
  }

  void part_contact(const ClosedBallViolation& violation) {
    const Curves& curves = contacts_.at({violation.regions[0], violation.regions[1]});
    add(violation, farthest_of_nearest(curves));
  }

  // Of each curve the point nearest to its seed, of these the farthest; no_id where none has room
  // for a seed.
  [[nodiscard]] PointId farthest_of_nearest(const Curves& curves) const {
    std::map<std::uint32_t, PointId> nearest;
    curves.for_each_part([&](std::uint32_t part, PointId p) {
      PointId& best = nearest.emplace(part, no_id).first->second;
      if (is_open(p) && (best == no_id || is_farther(best, p))) best = p;
    });
    PointId farthest = no_id;
    for (const auto& [part, p] : nearest) {
      if (p != no_id) improve(farthest, p);
    }
    return farthest;
  }

  [[nodiscard]] PointId farthest_at_corners(const ClosedBallViolation& violation) const {
    PointId farthest = no_id;
    for (const std::uint32_t i : corners_.at(violation.regions)) {
      for (const PointId p : surface_.triangles[i]) improve(farthest, p);
    }
    return farthest;
  }

  const RegionSurface& surface_;
  const DualMesh& dual_;
  std::vector<PointId> farthest_;  // per region
  std::map<RegionId, std::vector<InnerEdge>> within_;
  std::map<RegionId, Curves> boundaries_;  // vertices on the boundary
  std::map<Pair, Curves> contacts_;
  std::map<std::array<RegionId, 3>, std::vector<std::uint32_t>> corners_;
  std::vector<SeedInsertion> insertions_;
};

}  // namespace

std::vector<SeedInsertion> find_seed_insertions(const RegionSurface& surface,
                                                const DualMesh& dual) {
  return InsertionFinder(surface, dual).run();
}

std::vector<SeedInsertion> leave_out_neighbours(std::vector<SeedInsertion> insertions,
                                                std::size_t region_count) {
  constexpr std::array<RegionId, 3> nobody = {no_id, no_id, no_id};
  std::vector<std::array<RegionId, 3>> taken_by(region_count, nobody);
  std::erase_if(insertions, [&](const SeedInsertion& insertion) {
    const auto is_open = [&](RegionId r) {
      return r == no_id || taken_by[r] == nobody || taken_by[r] == insertion.regions;
    };
    const auto& regions = insertion.regions;
    if (!std::all_of(regions.begin(), regions.end(), is_open)) return true;
    for (const RegionId r : regions) {
      if (r != no_id) taken_by[r] = regions;
    }
    return false;
  });
  return insertions;
}

}  // namespace geolloyd
