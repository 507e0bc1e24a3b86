#include "core/seams/cut_apart.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/loops.h"
#include "core/mesh/connectivity.h"

namespace geolloyd {
namespace {

// The fans of triangles around one vertex, joined across edges of two triangles.
class Fans {
 public:
  /// How many there are. `at` are the triangles at `v`.
  std::size_t find(const Mesh& mesh, VertexId v, std::span<const TriangleId> at) {
    fan_.resize(at.size());
    edges_.clear();
    for (std::size_t i = 0; i < at.size(); ++i) {
      fan_[i] = i;
      for (const VertexId u : mesh.triangles[at[i]]) {
        if (u != v) edges_.emplace_back(u, i);
      }
    }
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t i = 0; i < edges_.size();) {
      std::size_t end = i;
      while (end < edges_.size() && edges_[end].first == edges_[i].first) ++end;
      if (end - i == 2) join(edges_[i].second, edges_[i + 1].second);
      i = end;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      fan_[i] = fan_[fan_[i]];  // an earlier one, which knows its first already
      count += fan_[i] == i ? 1 : 0;
    }
    return count;
  }
  /// The first triangle of that of triangle i.
  std::size_t root(std::size_t i) {
    while (fan_[i] != i) i = fan_[i] = fan_[fan_[i]];
    return i;
  }

 private:
  void join(std::size_t i, std::size_t j) {
    const std::size_t a = root(i);
    const std::size_t b = root(j);
    fan_[std::max(a, b)] = std::min(a, b);
    fan_[i] = fan_[j] = std::min(a, b);
  }

  std::vector<std::size_t> fan_;
  std::vector<std::pair<VertexId, std::size_t>> edges_;  // to a vertex, of a triangle
};

// The quick way to know most vertices: a walk from triangle to triangle around `v` that comes back
// to the first one after all. Each edge on the way has two triangles. Not for many triangles,
// because each step looks at all of them.
bool is_closed_fan(const Mesh& mesh, VertexId v, std::span<const TriangleId> at) {
  if (at.empty()) return true;
  constexpr std::size_t many = 32;
  if (at.size() > many) return false;
  const auto next_corner = [&](std::size_t i) {
    const Triangle& t = mesh.triangles[at[i]];
    return t[0] == v ? t[1] : t[1] == v ? t[2] : t[0];
  };
  const auto last_corner = [&](std::size_t i) {
    const Triangle& t = mesh.triangles[at[i]];
    return t[0] == v ? t[2] : t[1] == v ? t[0] : t[1];
  };
  std::size_t i = 0;
  for (std::size_t steps = 1;; ++steps) {
    const VertexId shared = last_corner(i);
    std::size_t beyond = at.size();
    for (std::size_t j = 0; j < at.size(); ++j) {
      if (j == i) continue;
      if (last_corner(j) == shared) return false;
      if (next_corner(j) != shared) continue;
      if (beyond < at.size()) return false;
      beyond = j;
    }
    if (beyond == at.size()) return false;
    if (beyond == 0) return steps == at.size();
    if (steps == at.size()) return false;
    i = beyond;
  }
}

}  // namespace

CutVertices cut_apart(Mesh& mesh, Executor& executor) {
  const auto at = triangles_at_vertices(mesh.vertex_count(), mesh.triangles, executor);
  std::vector<std::vector<VertexId>> found(executor.threads());
  parallel_for_ranges(executor, mesh.vertex_count(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t worker) {
                        Fans fans;
                        for (auto v = static_cast<VertexId>(begin); v < end; ++v) {
                          if (is_closed_fan(mesh, v, at[v])) continue;
                          if (fans.find(mesh, v, at[v]) > 1) found[worker].push_back(v);
                        }
                      });
  std::vector<VertexId> broken;
  for (const auto& part : found) broken.insert(broken.end(), part.begin(), part.end());
  std::sort(broken.begin(), broken.end());

  struct Renaming {
    CornerId corner;
    VertexId vertex;
  };
  std::vector<Renaming> renamings;
  CutVertices cut{broken.size(), {}};
  Fans fans;
  for (const VertexId v : broken) {
    fans.find(mesh, v, at[v]);
    std::vector<VertexId> copy(at[v].size(), v);
    for (std::size_t i = 1; i < at[v].size(); ++i) {
      if (fans.root(i) == i) {
        copy[i] = static_cast<VertexId>(mesh.positions.size());
        const Vec3 position = mesh.positions[v];
        mesh.positions.push_back(position);
        cut.copy_of.push_back(v);
      }
      const Triangle& t = mesh.triangles[at[v][i]];
      const CornerId corner = 3 * at[v][i] + (t[0] == v ? 0 : t[1] == v ? 1 : 2);
      renamings.push_back({corner, copy[fans.root(i)]});
    }
  }
  for (const auto& [corner, vertex] : renamings) mesh.triangles[corner / 3][corner % 3] = vertex;
  return cut;
}

}  // namespace geolloyd
