#include "core/repair/holes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/bounding_box.h"
#include "core/base/disjoint_sets.h"
#include "core/mesh/connectivity.h"
#include "core/repair/hole_surroundings.h"
#include "core/repair/hole_triangulation.h"
#include "core/seams/places.h"
#include "core/seams/stitching.h"

namespace geolloyd {
namespace {

// An edge of the boundary, against the direction of its triangle: as a triangle beyond has it.
struct Side {
  VertexId from = no_id;
  VertexId to = no_id;
  TriangleId triangle = no_id;
};

class HoleFiller {
 public:
  HoleFiller(Mesh& mesh, const RepairOptions& options, Touching touching, Repairs& repairs)
      : mesh_(mesh),
        options_(options),
        touching_(touching),
        repairs_(repairs),
        edges_(find_edges(mesh)),
        joined_(mesh.vertex_count()) {}

  std::vector<VertexId> run() {
    std::vector<VertexId> name(mesh_.vertex_count());
    for (VertexId v = 0; v < name.size(); ++v) name[v] = v;
    find_sides();
    if (sides_.empty()) return name;
    place_ = places_of(mesh_);
    find_place_edges();
    find_diagonals();
    for (std::uint32_t s = 0; s < sides_.size(); ++s) trace(s);
    fill_all();
    mesh_.triangles.insert(mesh_.triangles.end(), added_.begin(), added_.end());
    for (VertexId v = 0; v < name.size(); ++v) name[v] = joined_.find(v);
    rename_vertices(mesh_, name);
    return name;
  }

 private:
  // By their first vertex; a vertex that begins two belongs to a surface that is not oriented.
  void find_sides() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto corners = edges_.corners(e);
      if (corners.size() != 1) continue;
      sides_.push_back(
          {edge_end(mesh_, corners[0]), edge_start(mesh_, corners[0]), triangle_of(corners[0])});
    }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    is_traced_.assign(sides_.size(), 0);
  }

  // The side that begins where another ends, if there is exactly one.
  [[nodiscard]] std::optional<std::uint32_t> side_from(VertexId v) const {
    const auto found = std::lower_bound(sides_.begin(), sides_.end(), v,
                                        [](const Side& s, VertexId u) { return s.from < u; });
    if (found == sides_.end() || found->from != v) return std::nullopt;
    if (found + 1 != sides_.end() && (found + 1)->from == v) return std::nullopt;
    return static_cast<std::uint32_t>(found - sides_.begin());
  }

  static std::uint64_t key(VertexId a, VertexId b) {
    const auto [low, high] = ascending(a, b);
    return (std::uint64_t{low} << 32) | high;
  }

  // The edges between places on the boundary: no triangle that is added may have one inside a hole.
  void find_place_edges() {
    std::vector<std::uint8_t> is_on_boundary(mesh_.vertex_count(), 0);
    for (const Side& s : sides_) is_on_boundary[place_[s.from]] = is_on_boundary[place_[s.to]] = 1;
    for (const auto& [a, b] : edges_.ends) {
      if (is_on_boundary[place_[a]] != 0 && is_on_boundary[place_[b]] != 0) {
        place_edges_.insert(key(place_[a], place_[b]));
      }
    }
  }

  void find_diagonals() {
    component_ = components_of(mesh_);
    std::vector<GrowingBox> box(mesh_.vertex_count());
    for (const Triangle& t : mesh_.triangles) {
      for (const VertexId v : t) box[component_[v]].add(mesh_.positions[v]);
    }
    for (const Side& s : sides_) {
      const VertexId part = component_[s.from];
      diagonal_.try_emplace(part, norm(box[part].high - box[part].low));
    }
  }

  // Follows a loop, and finds each part of it that comes back to the same place and is small.
  void trace(std::uint32_t first) {
    if (is_traced_[first] != 0) return;
    std::vector<Side> loop;
    for (std::optional<std::uint32_t> s = first; s && is_traced_[*s] == 0;
         s = side_from(sides_[*s].to)) {
      is_traced_[*s] = 1;
      loop.push_back(sides_[*s]);
    }
    if (loop.back().to != loop.front().from) return;  // not oriented
    std::vector<Side> open;
    std::unordered_map<VertexId, std::size_t> begun;  // by place
    for (const Side& s : loop) {
      begun.emplace(place_[s.from], open.size());
      open.push_back(s);
      const auto start = begun.find(place_[s.to]);
      if (start == begun.end()) continue;
      const std::size_t begin = start->second;
      const std::vector<Side> hole(open.begin() + static_cast<std::ptrdiff_t>(begin), open.end());
      for (const Side& done : hole) begun.erase(place_[done.from]);
      open.resize(begin);
      if (is_small(hole)) holes_.push_back(hole);
    }
  }

  [[nodiscard]] bool is_small(const std::vector<Side>& hole) const {
    if (hole.size() <= options_.hole_edges) return true;
    double length = 0;
    for (const Side& s : hole) length += norm(mesh_.positions[s.from] - mesh_.positions[s.to]);
    return length <= options_.hole_share * diagonal_.at(component_[hole.front().from]);
  }

  void fill_all() {
    std::vector<GrowingBox> boxes(holes_.size());
    for (std::size_t h = 0; h < holes_.size(); ++h) {
      for (const Side& s : holes_[h]) boxes[h].add(mesh_.positions[s.from]);
    }
    HoleSurroundings surroundings(mesh_, boxes);
    for (std::size_t h = 0; h < holes_.size(); ++h) {
      ++(fill(h, surroundings) ? repairs_.holes_filled : repairs_.holes_left);
    }
  }

  bool fill(std::size_t h, HoleSurroundings& surroundings) {
    const std::vector<Side>& hole = holes_[h];
    if (hole.size() < 3 || !may_join(hole)) return false;
    const std::vector<Triangle> triangles = triangulate(hole, surroundings);
    if (triangles.empty()) return false;
    surroundings.add(h, corners_of(hole, triangles));
    const auto place_at = [&](std::uint32_t i) { return place_[hole[i].from]; };
    for (const auto& [i, j, k] : triangles) {
      added_.push_back({hole[i].from, hole[j].from, hole[k].from});
      place_edges_.insert(key(place_at(i), place_at(j)));
      place_edges_.insert(key(place_at(j), place_at(k)));
      place_edges_.insert(key(place_at(k), place_at(i)));
    }
    repairs_.triangles_added += triangles.size();
    for (std::size_t i = 0; i < hole.size(); ++i) {
      joined_.unite(hole[i].to, hole[i + 1 < hole.size() ? i + 1 : 0].from);
    }
    return true;
  }

  // The triangles that bend least. Where these pass through the surface, the best of those that do
  // not one by one; empty where together they do.
  [[nodiscard]] std::vector<Triangle> triangulate(const std::vector<Side>& hole,
                                                  const HoleSurroundings& surroundings) const {
    HoleOutline outline;
    for (const Side& s : hole) {
      const auto& [a, b, c] = mesh_.triangles[s.triangle];
      outline.corners.push_back(mesh_.positions[s.from]);
      outline.normals.emplace_back(
          cross(mesh_.positions[b] - mesh_.positions[a], mesh_.positions[c] - mesh_.positions[a]));
    }
    HoleLimits limits;
    limits.is_forbidden = [&](std::uint32_t i, std::uint32_t j) {
      return place_edges_.contains(key(place_[hole[i].from], place_[hole[j].from]));
    };
    const auto passes = [&](const std::vector<Triangle>& triangles) {
      return surroundings.is_in_the_way_of(corners_of(hole, triangles));
    };
    std::vector<Triangle> triangles = triangulate_hole(outline, limits);
    if (triangles.empty() || !passes(triangles)) return triangles;
    limits.is_blocked = [&](const Triangle& t) {
      return surroundings.is_in_the_way_of(corners_of(hole, t));
    };
    triangles = triangulate_hole(outline, limits);
    if (passes(triangles)) triangles.clear();
    return triangles;
  }

  [[nodiscard]] HoleSurroundings::Corners corners_of(const std::vector<Side>& hole,
                                                     const Triangle& t) const {
    return {mesh_.positions[hole[t[0]].from], mesh_.positions[hole[t[1]].from],
            mesh_.positions[hole[t[2]].from]};
  }
  [[nodiscard]] std::vector<HoleSurroundings::Corners> corners_of(
      const std::vector<Side>& hole, const std::vector<Triangle>& triangles) const {
    std::vector<HoleSurroundings::Corners> corners;
    corners.reserve(triangles.size());
    for (const Triangle& t : triangles) corners.push_back(corners_of(hole, t));
    return corners;
  }

  // Where a hole touches another one, its sides do not share a vertex. They may if the vertices
  // have no neighbour in common.
  [[nodiscard]] bool may_join(const std::vector<Side>& hole) {
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const VertexId a = hole[i].to;
      const VertexId b = hole[i + 1 < hole.size() ? i + 1 : 0].from;
      if (a == b) continue;
      if (touching_ == Touching::left) return false;
      if (have_common_neighbour(a, b)) return false;
    }
    return true;
  }
  bool have_common_neighbour(VertexId a, VertexId b) {
    if (!at_) at_ = triangles_at_vertices(mesh_.vertex_count(), mesh_.triangles);
    std::unordered_set<VertexId> beside;
    for (const TriangleId t : (*at_)[a]) {
      for (const VertexId v : mesh_.triangles[t]) beside.insert(v);
    }
    for (const TriangleId t : (*at_)[b]) {
      for (const VertexId v : mesh_.triangles[t]) {
        if (beside.contains(v)) return true;
      }
    }
    return false;
  }

  Mesh& mesh_;
  const RepairOptions& options_;
  Touching touching_;
  Repairs& repairs_;
  MeshEdges edges_;
  DisjointSets joined_;
  std::vector<Side> sides_;
  std::vector<std::uint8_t> is_traced_;
  std::vector<VertexId> place_;
  std::vector<VertexId> component_;
  std::unordered_set<std::uint64_t> place_edges_;
  std::unordered_map<VertexId, double> diagonal_;  // of the box of a component
  std::vector<std::vector<Side>> holes_;
  std::vector<Triangle> added_;
  std::optional<Bucketed<TriangleId>> at_;  // per vertex its triangles, once they are asked for
};

}  // namespace

std::vector<VertexId> fill_holes(Mesh& mesh, const RepairOptions& options, Touching touching,
                                 Repairs& repairs) {
  return HoleFiller(mesh, options, touching, repairs).run();
}

}  // namespace geolloyd
