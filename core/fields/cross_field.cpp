#include "core/fields/cross_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "core/base/loops.h"
#include "core/base/vec3.h"
#include "core/fields/curvature_field.h"
#include "core/fields/principal_direction.h"
#include "core/fields/tangent_plane.h"

namespace geolloyd {
namespace {

constexpr int rounds_per_level = 24;
constexpr std::size_t few_nodes = 32;      // of the coarsest level
constexpr double pull_of_curvature = 0.2;  // at most, times that of a neighbour
constexpr double pull_of_features = 1000;  // times that of a neighbour
constexpr double cosine_of_sharp = 0.766;  // 40 degrees

// The fourth power of a direction, times a weight.
struct Cross {
  double p = 0;
  double q = 0;

  Cross& operator+=(const Cross& other) {
    p += other.p;
    q += other.q;
    return *this;
  }
};

double size_of(const Cross& c) {
  return std::sqrt(c.p * c.p + c.q * c.q);
}

Cross product(const Cross& a, const Cross& b) {
  return {a.p * b.p - a.q * b.q, a.p * b.q + a.q * b.p};
}

Cross conjugate(const Cross& c) {
  return {c.p, -c.q};
}

Cross scaled(double factor, const Cross& c) {
  return {factor * c.p, factor * c.q};
}

Cross unit(const Cross& c) {
  const double size = size_of(c);
  return size > 0 ? Cross{c.p / size, c.q / size} : Cross{1, 0};
}

Cross fourth_power(double x, double y) {
  const Cross square{x * x - y * y, 2 * x * y};
  return product(square, square);
}

// How a cross in one plane is written in another: turned and, where the normals face away from each
// other, mirrored before.
struct PlaneTurn {
  Cross turn{1, 0};
  bool is_mirrored = false;

  [[nodiscard]] Cross of(const Cross& c) const {
    return product(turn, is_mirrored ? conjugate(c) : c);
  }
  [[nodiscard]] PlaneTurn after(const PlaneTurn& first) const {
    return {of(first.turn), is_mirrored != first.is_mirrored};
  }
  // Of a turn of length 1.
  [[nodiscard]] PlaneTurn inverse() const {
    return {is_mirrored ? turn : conjugate(turn), is_mirrored};
  }
};

// What a node sees of a neighbour: the sum of the ways there.
struct CrossLink {
  std::uint32_t to = no_id;
  double weight = 0;
  PlaneTurn passage;  // times the weight
};

struct CrossLevel {
  std::vector<std::uint32_t> first_link{0};  // per node, and one more
  std::vector<CrossLink> links;
  std::vector<Cross> pull;            // per node: what it is to follow
  std::vector<std::uint32_t> coarse;  // per node: that of the next level
  std::vector<PlaneTurn> to_coarse;   // per node

  [[nodiscard]] std::size_t size() const { return pull.size(); }
  [[nodiscard]] std::span<const CrossLink> links_of(std::size_t node) const {
    return {links.data() + first_link[node], links.data() + first_link[node + 1]};
  }
};

// The tangent planes of vertices, with the directions of curvature as axes.
class CrossPlanes {
 public:
  CrossPlanes(const Mesh& mesh, const MeshEdges& edges, Executor& executor)
      : mesh_(mesh),
        edges_(edges),
        edges_at_(edges_at_vertices(mesh.vertex_count(), edges, executor)),
        axes_(curvature_field(mesh, edges, edges_at_, executor)) {}

  [[nodiscard]] const TangentSpace& axes(VertexId v) const { return axes_[v]; }

  [[nodiscard]] CrossLevel level(Executor& executor) const {
    CrossLevel level;
    const std::size_t count = mesh_.vertex_count();
    level.pull.resize(count);
    level.first_link.assign(count + 1, 0);
    for (std::size_t v = 0; v < count; ++v) {
      level.first_link[v + 1] = edges_at_.end[v];
    }
    level.links.resize(edges_at_.entry.size());
    parallel_for(executor, count, small_items, [&](std::size_t i) {
      const auto v = static_cast<VertexId>(i);
      level.pull[v] = pull(v);
      CrossLink* link = level.links.data() + level.first_link[v];
      for (const std::uint32_t e : edges_at_[v]) {
        const VertexId other = edges_.ends[e][edges_.ends[e][0] == v ? 1 : 0];
        *link++ = {other, 1, passage(other, v)};
      }
    });
    return level;
  }

 private:
  [[nodiscard]] Vec3 normal(VertexId v) const {
    return cross(axes_[v].tangent, axes_[v].bitangent);
  }

  [[nodiscard]] PlaneTurn passage(VertexId from, VertexId to) const {
    const Vec3 there = normal(to);
    const Vec3 here = normal(from);
    const bool is_mirrored = dot(here, there) < 0;
    const Vec3 first = transported(axes_[from].tangent, is_mirrored ? Vec3(-here) : here, there);
    return {unit(fourth_power(dot(first, axes_[to].tangent), dot(first, axes_[to].bitangent))),
            is_mirrored};
  }

  [[nodiscard]] Vec3 triangle_normal(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    const std::vector<Vec3>& p = mesh_.positions;
    return normalized(cross(p[b] - p[a], p[c] - p[a]));
  }

  [[nodiscard]] bool is_feature(std::size_t edge) const {
    const auto corners = edges_.corners(edge);
    if (corners.size() != 2) return true;
    const bool is_turned = edge_start(mesh_, corners[0]) == edge_start(mesh_, corners[1]);
    const double cosine =
        dot(triangle_normal(triangle_of(corners[0])), triangle_normal(triangle_of(corners[1])));
    return (is_turned ? -cosine : cosine) < cosine_of_sharp;
  }

  // Features that meet, but not at right angles, pull nowhere.
  [[nodiscard]] Cross pull(VertexId v) const {
    Cross sum;
    int features = 0;
    for (const std::uint32_t e : edges_at_[v]) {
      if (!is_feature(e)) continue;
      const Vec3 d = mesh_.positions[edges_.ends[e][1]] - mesh_.positions[edges_.ends[e][0]];
      sum += fourth_power_of_direction(dot(d, axes_[v].tangent), dot(d, axes_[v].bitangent));
      ++features;
    }
    if (2 * size_of(sum) > features) return scaled(pull_of_features, unit(sum));
    if (features > 0) return {};
    const double ratio = axes_[v].tangent_magnitude / axes_[v].bitangent_magnitude;
    return {pull_of_curvature * (ratio - 1) / (most_stretch - 1), 0};
  }

  static Cross fourth_power_of_direction(double x, double y) {
    const Cross direction = unit({x, y});
    return fourth_power(direction.p, direction.q);
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  Bucketed<std::uint32_t> edges_at_;  // ascending
  std::vector<TangentSpace> axes_;
};

// Each node with the unpaired neighbour of the largest weight, the first of several. Nodes without
// neighbours stay behind.
void pair_nodes(CrossLevel& level, CrossLevel& coarse) {
  level.coarse.assign(level.size(), no_id);
  level.to_coarse.resize(level.size());
  for (std::uint32_t v = 0; v < level.size(); ++v) {
    if (level.coarse[v] != no_id || level.links_of(v).empty()) continue;
    const CrossLink* nearest = nullptr;
    for (const CrossLink& link : level.links_of(v)) {
      if (level.coarse[link.to] != no_id || link.to == v) continue;
      if (nearest == nullptr || link.weight > nearest->weight) nearest = &link;
    }
    const auto id = static_cast<std::uint32_t>(coarse.pull.size());
    level.coarse[v] = id;
    coarse.pull.push_back(level.pull[v]);
    if (nearest == nullptr) continue;
    const PlaneTurn turn{unit(nearest->passage.turn), nearest->passage.is_mirrored};
    level.coarse[nearest->to] = id;
    level.to_coarse[nearest->to] = turn;
    coarse.pull[id] += turn.of(level.pull[nearest->to]);
  }
}

// Of those to the same node, sums; with a mirrored passage and without one apart.
void add_links(std::vector<CrossLink>& links, std::size_t first) {
  const auto begin = links.begin() + static_cast<std::ptrdiff_t>(first);
  const auto key = [](const CrossLink& link) {
    return std::pair(link.to, link.passage.is_mirrored);
  };
  std::stable_sort(begin, links.end(),
                   [&](const CrossLink& a, const CrossLink& b) { return key(a) < key(b); });
  std::size_t kept = first;
  for (std::size_t i = first; i < links.size(); ++i) {
    if (kept > first && key(links[kept - 1]) == key(links[i])) {
      links[kept - 1].weight += links[i].weight;
      links[kept - 1].passage.turn += links[i].passage.turn;
    } else {
      links[kept++] = links[i];
    }
  }
  links.erase(links.begin() + static_cast<std::ptrdiff_t>(kept), links.end());
}

// Half as many nodes, if all goes well.
CrossLevel coarsened(CrossLevel& level) {
  CrossLevel coarse;
  coarse.pull.reserve(level.size());
  pair_nodes(level, coarse);
  std::vector<std::array<std::uint32_t, 2>> members(coarse.size(), {no_id, no_id});
  for (std::uint32_t v = 0; v < level.size(); ++v) {
    if (level.coarse[v] == no_id) continue;
    auto& [first, second] = members[level.coarse[v]];
    (first == no_id ? first : second) = v;
  }
  coarse.first_link.reserve(coarse.size() + 1);
  coarse.links.reserve(level.links.size());
  for (std::uint32_t node = 0; node < coarse.size(); ++node) {
    for (const std::uint32_t v : members[node]) {
      if (v == no_id) continue;
      for (const CrossLink& link : level.links_of(v)) {
        const std::uint32_t to = level.coarse[link.to];
        if (to == node) continue;
        coarse.links.push_back(
            {to, link.weight,
             level.to_coarse[v].after(link.passage.after(level.to_coarse[link.to].inverse()))});
      }
    }
    add_links(coarse.links, coarse.first_link.back());
    coarse.first_link.push_back(static_cast<std::uint32_t>(coarse.links.size()));
  }
  return coarse;
}

void smooth(const CrossLevel& level, std::vector<Cross>& crosses, Executor& executor) {
  std::vector<Cross> before(crosses.size());
  for (int round = 0; round < rounds_per_level; ++round) {
    std::swap(before, crosses);
    parallel_for(executor, level.size(), small_items, [&](std::size_t v) {
      Cross sum = level.pull[v];
      double weight = 0;
      for (const CrossLink& link : level.links_of(v)) {
        sum += link.passage.of(before[link.to]);
        weight += link.weight;
      }
      sum += scaled(weight, before[v]);
      crosses[v] = size_of(sum) > 0 ? unit(sum) : before[v];
    });
  }
}

std::vector<Cross> smooth_crosses(CrossLevel finest, Executor& executor) {
  std::vector<CrossLevel> levels;
  levels.push_back(std::move(finest));
  while (levels.back().size() > few_nodes) {
    CrossLevel coarse = coarsened(levels.back());
    if (10 * coarse.size() > 9 * levels.back().size()) break;  // hubs leave no pairs
    levels.push_back(std::move(coarse));
  }
  std::vector<Cross> crosses;
  for (const Cross& pull : levels.back().pull) crosses.push_back(unit(pull));
  smooth(levels.back(), crosses, executor);
  for (std::size_t i = levels.size() - 1; i-- > 0;) {
    const CrossLevel& level = levels[i];
    std::vector<Cross> finer(level.size());
    parallel_for(executor, level.size(), small_items, [&](std::size_t v) {
      finer[v] = level.coarse[v] == no_id
                     ? unit(level.pull[v])
                     : level.to_coarse[v].inverse().of(crosses[level.coarse[v]]);
    });
    crosses = std::move(finer);
    smooth(level, crosses, executor);
  }
  return crosses;
}

}  // namespace

std::vector<TangentSpace> cross_field(const Mesh& mesh, const MeshEdges& edges,
                                      Executor& executor) {
  const CrossPlanes planes(mesh, edges, executor);
  const std::vector<Cross> crosses = smooth_crosses(planes.level(executor), executor);
  std::vector<TangentSpace> field(mesh.vertex_count());
  parallel_for(executor, field.size(), small_items, [&](std::size_t i) {
    const auto v = static_cast<VertexId>(i);
    const auto doubled = principal_direction(crosses[v].p, crosses[v].q);
    const auto [cosine, sine] = principal_direction(doubled[0], doubled[1]);
    const TangentSpace& axes = planes.axes(v);
    field[v] = {cosine * axes.tangent + sine * axes.bitangent,
                cosine * axes.bitangent - sine * axes.tangent, 1, 1};
  });
  return field;
}

}  // namespace geolloyd
