#include "core/surface/flips/glide_paths.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace geolloyd {
namespace {

constexpr std::size_t longest_path = 6;
constexpr std::size_t most_found = 24;
constexpr std::size_t most_kept = 4;
constexpr std::size_t most_flips = 4000;

class PathSearch {
 public:
  explicit PathSearch(GlidePatch patch) : patch_(std::move(patch)) {}

  std::vector<FlipPath> run() {
    go_on({0}, longest_path);
    std::stable_sort(paths_.begin(), paths_.end(),
                     [](const FlipPath& a, const FlipPath& b) { return a.size() < b.size(); });
    if (paths_.size() > most_kept) paths_.resize(most_kept);
    return std::move(paths_);
  }

 private:
  // Depth first, with flips next to these vertices.
  void go_on(const std::vector<VertexId>& moving, std::size_t left) {
    for (const auto& [b, c] : edges_near(moving)) {
      if (paths_.size() >= most_found || flips_ >= most_flips) return;
      const FlippableTriangles::Side side = patch_.triangles().side_of(b, c);
      if (!patch_.can_flip(side)) continue;
      const FlippableTriangles::Quad quad = patch_.triangles().quad_of(side);
      const VertexId a = quad.a;
      const VertexId d = quad.d;
      const int change = change_of(a, 1) + change_of(d, 1) + change_of(b, -1) + change_of(c, -1);
      if (change > 0 || (change == 0 && left <= 1)) continue;
      if (!diagonals_.empty() && diagonals_.back() == ascending(b, c)) continue;
      ++flips_;
      patch_.flip(side);
      path_.push_back(ascending(b, c));
      diagonals_.push_back(ascending(a, d));
      if (change < 0) {
        paths_.push_back(path_);
      } else {
        go_on(irregular_of({a, d, b, c}), left - 1);
      }
      patch_.flip(patch_.triangles().side_of(a, d));
      path_.pop_back();
      diagonals_.pop_back();
    }
  }

  // Of these vertices, and opposite to them; ascending.
  [[nodiscard]] std::vector<std::array<VertexId, 2>> edges_near(
      const std::vector<VertexId>& vertices) const {
    std::vector<std::array<VertexId, 2>> edges;
    for (const VertexId v : vertices) {
      patch_.triangles().visit_around(v, [&](TriangleId t) {
        const auto& [a, b, c] = patch_.triangles()[t];
        for (const auto& edge : {ascending(a, b), ascending(b, c), ascending(c, a)}) {
          edges.push_back(edge);
        }
      });
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  [[nodiscard]] std::vector<VertexId> irregular_of(std::array<VertexId, 4> vertices) const {
    std::vector<VertexId> irregular;
    for (const VertexId v : vertices) {
      if (patch_.excess(v) != 0) irregular.push_back(v);
    }
    return irregular;
  }

  // Of the square of excess; a vertex of the boundary has none.
  [[nodiscard]] int change_of(VertexId v, int more) const {
    const int excess = patch_.excess(v);
    return patch_.is_inside(v) ? more * (2 * excess + more) : 0;
  }

  GlidePatch patch_;
  FlipPath path_;
  FlipPath diagonals_;
  std::vector<FlipPath> paths_;
  std::size_t flips_ = 0;
};

}  // namespace

std::vector<FlipPath> find_glide_paths(GlidePatch patch) {
  return PathSearch(std::move(patch)).run();
}

}  // namespace geolloyd
