#include "core/repair/slivers.h"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/mesh/connectivity.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

// The triangles at a vertex; those that no longer are may still be named by the lists.
class Stars {
 public:
  explicit Stars(const Mesh& mesh)
      : mesh_(mesh), first_(triangles_at_vertices(mesh.vertex_count(), mesh.triangles)) {}

  void add(VertexId v, TriangleId t) { more_[v].push_back(t); }

  /// Ascending; empty where there are too many to look at.
  [[nodiscard]] std::optional<std::vector<TriangleId>> at(VertexId v) const {
    constexpr std::size_t most = 256;
    const auto first = first_[v];
    const auto more = more_.find(v);
    if (first.size() + (more == more_.end() ? 0 : more->second.size()) > most) return std::nullopt;
    std::vector<TriangleId> found(first.begin(), first.end());
    if (more != more_.end()) {
      found.insert(found.end(), more->second.begin(), more->second.end());
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::erase_if(found, [&](TriangleId t) {
      const Triangle& c = mesh_.triangles[t];
      return c[0] == no_id || (c[0] != v && c[1] != v && c[2] != v);
    });
    return found;
  }

 private:
  const Mesh& mesh_;
  Bucketed<TriangleId> first_;
  std::unordered_map<VertexId, std::vector<TriangleId>> more_;
};

Triangle replaced(Triangle t, VertexId from, VertexId to) {
  std::replace(t.begin(), t.end(), from, to);
  return t;
}

bool has_vertex(const Triangle& t, VertexId v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

class SliverRemover {
 public:
  explicit SliverRemover(Mesh& mesh) : mesh_(mesh), stars_(mesh) {}

  /// Triangles left out have no_id as their first vertex. Returns how many slivers are left.
  std::size_t run(const std::vector<TriangleId>& slivers) {
    std::deque<TriangleId> open(slivers.begin(), slivers.end());
    std::size_t budget = 8 * slivers.size() + 64;
    while (!open.empty() && budget > 0) {
      --budget;
      const TriangleId t = open.front();
      open.pop_front();
      if (!is_open(t)) continue;
      changed_.clear();
      if (!(leave_out_ear(t) || collapse(t) || flip(t))) continue;
      for (const TriangleId u : changed_) {
        if (is_open(u)) open.push_back(u);
      }
      // Those that did not work may do so now.
      for (const TriangleId u : changed_) {
        if (mesh_.triangles[u][0] == no_id) continue;
        for (const VertexId v : mesh_.triangles[u]) {
          const auto star = stars_.at(v);
          if (!star) continue;
          for (const TriangleId beside : *star) {
            if (beside != u && is_open(beside)) open.push_back(beside);
          }
        }
      }
    }
    std::size_t left = 0;
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) left += is_open(t) ? 1 : 0;
    return left;
  }

 private:
  [[nodiscard]] bool is_open(TriangleId t) const {
    const Triangle& c = mesh_.triangles[t];
    return c[0] != no_id && is_sliver(mesh_, c);
  }
  [[nodiscard]] Vec3 normal(const Triangle& t) const {
    const Vec3& a = mesh_.positions[t[0]];
    return cross(mesh_.positions[t[1]] - a, mesh_.positions[t[2]] - a);
  }
  [[nodiscard]] double flatness_of(const Triangle& t) const {
    return flatness(mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]);
  }
  [[nodiscard]] double length(VertexId a, VertexId b) const {
    return norm(mesh_.positions[a] - mesh_.positions[b]);
  }

  // Whether a triangle stays within 60 degrees of what it was; a sliver may become anything.
  [[nodiscard]] bool keeps_direction(const Triangle& before, const Triangle& after) const {
    if (is_sliver(mesh_, before)) return true;
    const Vec3 n = normal(before);
    const Vec3 m = normal(after);
    return dot(n, m) > 0.5 * (norm(n) * norm(m));
  }

  // The triangles at an edge, looked for at the end that has fewer; empty where both have too many.
  [[nodiscard]] std::optional<std::vector<TriangleId>> at_edge(VertexId a, VertexId b) const {
    auto star = stars_.at(a);
    VertexId other = b;
    if (!star) {
      star = stars_.at(b);
      other = a;
    }
    if (star) {
      std::erase_if(*star, [&](TriangleId t) { return !has_vertex(mesh_.triangles[t], other); });
    }
    return star;
  }

  // The corners of a triangle from its longest edge on: its two ends, then the corner opposite.
  [[nodiscard]] Triangle from_longest_edge(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    const double ab = length(a, b);
    const double bc = length(b, c);
    const double ca = length(c, a);
    if (ab >= bc && ab >= ca) return {a, b, c};
    return bc >= ca ? Triangle{b, c, a} : Triangle{c, a, b};
  }

  void leave_out(TriangleId t) {
    mesh_.triangles[t][0] = no_id;
    changed_.push_back(t);
  }
  void replace(TriangleId t, const Triangle& by) {
    const Triangle before = std::exchange(mesh_.triangles[t], by);
    for (const VertexId v : by) {
      if (!has_vertex(before, v)) stars_.add(v, t);
    }
    changed_.push_back(t);
  }

  bool leave_out_ear(TriangleId t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    int boundary_edges = 0;
    for (const auto& [u, v] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      const auto at = at_edge(u, v);
      if (!at) return false;
      boundary_edges += at->size() == 1 ? 1 : 0;
    }
    if (boundary_edges != 2) return false;
    leave_out(t);
    return true;
  }

  bool collapse(TriangleId t) {
    const auto [a, b, c] = from_longest_edge(t);
    const bool is_first = length(b, c) <= length(c, a);
    const VertexId d = is_first ? b : a;
    if (length(c, d) > sliver_flatness * length(a, b)) return false;
    return collapse_edge(c, d) || collapse_edge(d, c);
  }

  // Whether the vertex is on the boundary; empty where it has too many triangles.
  [[nodiscard]] std::optional<bool> is_on_boundary(VertexId v) const {
    const auto star = stars_.at(v);
    if (!star) return std::nullopt;
    std::vector<VertexId> rim;
    for (const TriangleId t : *star) {
      for (const VertexId u : mesh_.triangles[t]) {
        if (u != v) rim.push_back(u);
      }
    }
    std::sort(rim.begin(), rim.end());
    for (std::size_t i = 0; i < rim.size(); i += 2) {
      if (i + 1 == rim.size() || rim[i] != rim[i + 1]) return true;
    }
    return false;
  }

  // Moves `from` onto `to`, where the topology stays (link condition: Dey, Edelsbrunner, Guha and
  // Nekhayev 1999) and no triangle turns.
  bool collapse_edge(VertexId from, VertexId to) {
    const auto star = stars_.at(from);
    const auto from_is_outer = is_on_boundary(from);
    if (!star || !from_is_outer) return false;
    std::vector<TriangleId> gone;
    std::vector<VertexId> opposite;
    for (const TriangleId t : *star) {
      if (!has_vertex(mesh_.triangles[t], to)) continue;
      gone.push_back(t);
      for (const VertexId v : mesh_.triangles[t]) {
        if (v != from && v != to) opposite.push_back(v);
      }
    }
    // Where `to` is inside, the edge collapses the other way. Else it cuts through the surface.
    if (*from_is_outer && gone.size() == 2) return false;
    if (star->size() == gone.size()) return false;  // nothing of `from` would be left
    for (const VertexId apex : opposite) {
      const auto beside = at_edge(from, apex);
      const auto beyond = at_edge(to, apex);
      if (!beside || !beyond || beside->size() + beyond->size() < 3) return false;
    }
    for (const TriangleId t : *star) {
      const Triangle& before = mesh_.triangles[t];
      if (has_vertex(before, to)) continue;
      const Triangle after = replaced(before, from, to);
      if (!keeps_direction(before, after)) return false;
      std::size_t apexes = 0;
      for (const VertexId v : before) {
        if (v == from) continue;
        const auto common = at_edge(v, to);
        if (!common) return false;
        if (std::find(opposite.begin(), opposite.end(), v) == opposite.end()) {
          if (!common->empty()) return false;
        } else if (++apexes == 2 && is_any_like(*common, after)) {
          return false;
        }
      }
    }
    for (const TriangleId t : gone) leave_out(t);
    for (const TriangleId t : *star) {
      if (mesh_.triangles[t][0] != no_id) replace(t, replaced(mesh_.triangles[t], from, to));
    }
    return true;
  }

  // Whether one has the vertices of `triangle`, in any order.
  [[nodiscard]] bool is_any_like(const std::vector<TriangleId>& triangles,
                                 const Triangle& triangle) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](TriangleId t) {
      return std::all_of(triangle.begin(), triangle.end(),
                         [&](VertexId v) { return has_vertex(mesh_.triangles[t], v); });
    });
  }

  bool flip(TriangleId t) {
    const auto [a, b, c] = from_longest_edge(t);
    const auto at = at_edge(a, b);
    if (!at) return false;
    if (at->size() == 1) {
      const auto is_outer = is_on_boundary(c);
      if (!is_outer || *is_outer) return false;
      leave_out(t);
      return true;
    }
    const TriangleId other = (*at)[0] == t ? (*at)[1] : (*at)[0];
    const Triangle before = mesh_.triangles[other];
    VertexId d = no_id;
    for (const VertexId v : before) {
      if (v != a && v != b) d = v;
    }
    const auto joined = at_edge(c, d);
    if (c == d || !joined || !joined->empty()) return false;
    const Triangle first = replaced(before, b, c);
    const Triangle second = replaced(before, a, c);
    const double flattest_before = std::min(flatness_of(mesh_.triangles[t]), flatness_of(before));
    if (std::min(flatness_of(first), flatness_of(second)) <= flattest_before) return false;
    if (!keeps_direction(before, first) || !keeps_direction(before, second)) return false;
    replace(t, first);
    replace(other, second);
    return true;
  }

  Mesh& mesh_;
  Stars stars_;
  std::vector<TriangleId> changed_;  // by the last step
};

}  // namespace

void remove_slivers(MeshUnderRepair& state, Repairs& repairs) {
  Mesh& mesh = state.mesh;
  std::vector<TriangleId> slivers;
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    if (is_sliver(mesh, mesh.triangles[t])) slivers.push_back(t);
  }
  if (slivers.empty()) return;
  const std::size_t left = SliverRemover(mesh).run(slivers);
  repairs.slivers_removed += slivers.size() - std::min(slivers.size(), left);
  std::vector<std::uint8_t> is_removed(mesh.triangle_count(), 0);
  for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
    is_removed[t] = mesh.triangles[t][0] == no_id ? 1 : 0;
  }
  remove_triangles(state, is_removed);
}

}  // namespace geolloyd
