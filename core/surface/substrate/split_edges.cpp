#include "core/surface/substrate/split_edges.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/types.h"
#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

using Ends = std::array<VertexId, 2>;

// Opposite to each corner, the smaller end first.
std::array<Ends, 3> edges_of(const Triangle& t) {
  return {ascending(t[1], t[2]), ascending(t[2], t[0]), ascending(t[0], t[1])};
}

// Long edges are halved, their halves too, and so on, whatever becomes of the triangles at them.
// Triangles of some height are cut in four as often as that makes them lower; all their edges are
// long. What is left is thin: the points on its longest edge are joined to those on the other two.
// So a needle gets as many pieces as its edges have. Cutting it in four until its edges are short
// would give it the square of that.
class Splitting {
 public:
  /// Only `candidates` may have long edges.
  Splitting(Mesh& mesh, std::vector<TriangleId>& origin, EdgeSizes& sizes, double longest,
            const std::vector<TriangleId>& candidates)
      : mesh_(mesh), origin_(origin), sizes_(sizes), longest_(longest) {
    for (const TriangleId t : candidates) look_at(t);
  }

  /// Halves no more edges once there are `vertex_limit` vertices. Returns the pieces of thin
  /// triangles, within which an edge may be long still.
  std::vector<TriangleId> run(std::size_t vertex_limit) {
    while (!long_edges_.empty() && mesh_.vertex_count() < vertex_limit) {
      halve_edges();
      for (const TriangleId t : std::exchange(to_split_, {})) {
        if (is_thin(mesh_.triangles[t])) {
          thin_.push_back({t, levels_.size() - 1});
        } else {
          cut_in_four(t);
        }
      }
    }
    for (const auto& [t, level] : thin_) zip(t, level);
    return std::move(pieces_);
  }

 private:
  // The edges that were halved at once.
  struct Level {
    std::vector<Ends> edges;  // ascending, each once
    VertexId first_middle;
  };
  struct ThinTriangle {
    TriangleId triangle;
    std::size_t level;  // of its edges
  };

  [[nodiscard]] Vec3 middle(const Ends& ends) const {
    return (mesh_.positions[ends[0]] + mesh_.positions[ends[1]]) / 2;
  }
  [[nodiscard]] double length(VertexId a, VertexId b) const {
    const Vec3 edge = mesh_.positions[a] - mesh_.positions[b];
    if (sizes_.metric.empty()) return norm(edge);
    return (0.5 * (sizes_.metric[a] + sizes_.metric[b])).length(edge);
  }
  [[nodiscard]] double longest_at(const Ends& ends) const {
    const std::vector<double>& sizes = sizes_.sizes;
    return sizes.empty() ? longest_ : longest_ * std::min(sizes[ends[0]], sizes[ends[1]]);
  }

  // Where coordinates are too coarse for a middle, so that a half is nearly as long as the whole,
  // an edge is as short as it can be.
  [[nodiscard]] bool is_long(const Ends& ends) const {
    if (!(length(ends[0], ends[1]) > longest_at(ends))) return false;
    const double length = norm(mesh_.positions[ends[0]] - mesh_.positions[ends[1]]);
    const Vec3 m = middle(ends);
    return norm(m - mesh_.positions[ends[0]]) < 0.75 * length &&
           norm(m - mesh_.positions[ends[1]]) < 0.75 * length;
  }

  bool add_if_long(const Ends& ends) {
    if (!is_long(ends)) return false;
    long_edges_.push_back(ends);
    return true;
  }

  void look_at(TriangleId t) {
    int count = 0;
    for (const Ends& ends : edges_of(mesh_.triangles[t])) count += add_if_long(ends) ? 1 : 0;
    if (count > 0) to_split_.push_back(t);
  }

  void halve_edges() {
    Level& level = levels_.emplace_back(Level{std::exchange(long_edges_, {}), 0});
    std::sort(level.edges.begin(), level.edges.end());
    level.edges.erase(std::unique(level.edges.begin(), level.edges.end()), level.edges.end());
    level.first_middle = static_cast<VertexId>(mesh_.positions.size());
    for (const Ends& ends : level.edges) {
      const auto m = static_cast<VertexId>(mesh_.positions.size());
      mesh_.positions.push_back(middle(ends));
      add_sizes_between(ends);
      for (const VertexId end : ends) add_if_long({end, m});
    }
  }

  void add_sizes_between(const Ends& ends) {
    auto& [sizes, metric] = sizes_;
    if (!sizes.empty()) sizes.push_back((sizes[ends[0]] + sizes[ends[1]]) / 2);
    if (!metric.empty()) metric.push_back(0.5 * (metric[ends[0]] + metric[ends[1]]));
  }

  [[nodiscard]] VertexId middle_of(const Ends& ends, std::size_t level) const {
    if (level >= levels_.size()) return no_id;
    const std::vector<Ends>& edges = levels_[level].edges;
    const auto found = std::lower_bound(edges.begin(), edges.end(), ends);
    if (found == edges.end() || *found != ends) return no_id;
    return levels_[level].first_middle + static_cast<VertexId>(found - edges.begin());
  }

  // Its height over the longest edge is at most half of what is long, or an edge is short.
  [[nodiscard]] bool is_thin(const Triangle& t) const {
    double base = 0;
    double longest = std::numeric_limits<double>::infinity();
    for (const Ends& ends : edges_of(t)) {
      if (!is_long(ends)) return true;
      base = std::max(base, length(ends[0], ends[1]));
      longest = std::min(longest, longest_at(ends));
    }
    return 4 * triangle_area(mesh_, t) <= longest * base;
  }

  void cut_in_four(TriangleId t) {
    const Triangle whole = mesh_.triangles[t];
    const std::array<Ends, 3> edges = edges_of(whole);
    std::array<VertexId, 3> m{};
    for (std::size_t c = 0; c < 3; ++c) m[c] = middle_of(edges[c], levels_.size() - 1);
    mesh_.triangles[t] = m;
    look_at(t);
    for (std::size_t c = 0; c < 3; ++c) {
      look_at(add_piece({whole[c], m[(c + 2) % 3], m[(c + 1) % 3]}, t));
    }
  }

  TriangleId add_piece(const Triangle& piece, TriangleId of) {
    mesh_.triangles.push_back(piece);
    origin_.push_back(TriangleId{origin_[of]});
    return static_cast<TriangleId>(mesh_.triangles.size() - 1);
  }

  // The vertices on an edge, from `a` to before `b`.
  void append_side(VertexId a, VertexId b, std::size_t level, std::vector<VertexId>& side) const {
    const VertexId m = middle_of(ascending(a, b), level);
    if (m == no_id) {
      side.push_back(a);
      return;
    }
    append_side(a, m, level + 1, side);
    append_side(m, b, level + 1, side);
  }

  // From one end of the longest edge to the other, always the shorter way across; of equal ones,
  // that from the next vertex on the longest edge.
  void zip(TriangleId t, std::size_t level) {
    const auto [a, b, c] = turned(mesh_.triangles[t], level);
    lower_.clear();
    append_side(a, b, level, lower_);
    upper_.clear();
    append_side(b, c, level, upper_);
    append_side(c, a, level, upper_);
    upper_.push_back(a);
    std::reverse(upper_.begin(), upper_.end());  // from a by c to b

    mesh_.triangles[t] = {a, lower_[1], upper_[1]};
    pieces_.push_back(t);
    const std::size_t last_lower = lower_.size() - 1;
    const std::size_t last_upper = upper_.size() - 2;
    std::size_t i = 1;
    std::size_t j = 1;
    while (i < last_lower || j < last_upper) {
      if (j == last_upper || (i < last_lower && is_shorter_below(i, j))) {
        pieces_.push_back(add_piece({lower_[i], lower_[i + 1], upper_[j]}, t));
        ++i;
      } else {
        pieces_.push_back(add_piece({lower_[i], upper_[j + 1], upper_[j]}, t));
        ++j;
      }
    }
    pieces_.push_back(add_piece({lower_[i], b, upper_[j]}, t));
  }

  [[nodiscard]] bool is_shorter_below(std::size_t i, std::size_t j) const {
    return length(lower_[i + 1], upper_[j]) <= length(lower_[i], upper_[j + 1]);
  }

  // With the longest of its halved edges first; of equals, the first one.
  [[nodiscard]] Triangle turned(const Triangle& t, std::size_t level) const {
    Triangle best{};
    double longest = -1;
    for (std::size_t c = 0; c < 3; ++c) {
      const Triangle other = {t[c], t[(c + 1) % 3], t[(c + 2) % 3]};
      const double own = length(other[0], other[1]);
      if (own > longest && middle_of(ascending(other[0], other[1]), level) != no_id) {
        best = other;
        longest = own;
      }
    }
    return best;
  }

  Mesh& mesh_;
  std::vector<TriangleId>& origin_;
  EdgeSizes& sizes_;
  double longest_;
  std::vector<Ends> long_edges_;      // to be halved next
  std::vector<TriangleId> to_split_;  // with such edges
  std::vector<Level> levels_;
  std::vector<ThinTriangle> thin_;
  std::vector<TriangleId> pieces_;
  std::vector<VertexId>
      lower_;  // of the triangle that is zipped: its longest edge, but for the end
  std::vector<VertexId> upper_;  // its other edges
};

}  // namespace

void split_long_edges(Mesh& mesh, std::vector<TriangleId>& origin, EdgeSizes& sizes, double longest,
                      std::size_t vertex_limit) {
  if (!(longest > 0)) return;
  std::vector<TriangleId> candidates(mesh.triangle_count());
  for (std::size_t t = 0; t < candidates.size(); ++t) candidates[t] = static_cast<TriangleId>(t);
  while (!candidates.empty() && mesh.vertex_count() < vertex_limit) {
    candidates = Splitting(mesh, origin, sizes, longest, candidates).run(vertex_limit);
  }
}

}  // namespace geolloyd
