#include "bench/zoo/changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/subdivide.h"

namespace geolloyd::zoo {
namespace {

// Directions that are the same but for rounding.
std::array<std::int64_t, 3> direction_of(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.positions;
  const Vec3 normal = normalized(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
  const auto rounded = [](double x) {
    return static_cast<std::int64_t>(std::floor(1000 * x + 0.5));
  };
  return {rounded(normal.x()), rounded(normal.y()), rounded(normal.z())};
}

// By a quaternion of integers.
Vec3 aside(const Vec3& p) {
  constexpr double w = 5;
  const Vec3 axis(3, -2, 1);
  const double square = w * w + dot(axis, axis);
  const Vec3 turn = cross(axis, p);
  return p + (2 / square) * (w * turn + cross(axis, turn));
}

class Needles {
 public:
  Needles(Mesh& mesh, std::uint32_t pieces)
      : mesh_(mesh), pieces_(pieces), is_done_(mesh.triangle_count(), 0) {}

  void run() {
    const MeshEdges edges = find_edges(mesh_);
    double longest = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) longest = std::max(longest, length(edges, e));
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto corners = edges.corners(e);
      const bool is_free = std::none_of(corners.begin(), corners.end(),
                                        [&](CornerId c) { return is_done_[triangle_of(c)] != 0; });
      if (is_free && length(edges, e) > longest / 4) split({corners[0], corners[1]});
    }
  }

 private:
  [[nodiscard]] double length(const MeshEdges& edges, std::size_t e) const {
    return norm(mesh_.positions[edges.ends[e][1]] - mesh_.positions[edges.ends[e][0]]);
  }

  void split(const std::array<CornerId, 2>& corners) {
    const Vec3 from = mesh_.positions[edge_start(mesh_, corners[0])];
    const Vec3 to = mesh_.positions[edge_end(mesh_, corners[0])];
    std::vector<VertexId> way = {edge_start(mesh_, corners[0])};
    for (std::uint32_t k = 1; k < pieces_; ++k) {
      way.push_back(static_cast<VertexId>(mesh_.vertex_count()));
      mesh_.positions.emplace_back(from + (to - from) * (static_cast<double>(k) / pieces_));
    }
    way.push_back(edge_end(mesh_, corners[0]));
    fan(corners[0], way);
    std::reverse(way.begin(), way.end());
    fan(corners[1], way);
  }

  void fan(CornerId corner, const std::vector<VertexId>& way) {
    const VertexId top = apex(mesh_, corner);
    is_done_[triangle_of(corner)] = 1;
    mesh_.triangles[triangle_of(corner)] = {top, way[0], way[1]};
    for (std::size_t k = 1; k + 1 < way.size(); ++k) {
      mesh_.triangles.push_back({top, way[k], way[k + 1]});
    }
  }

  Mesh& mesh_;
  std::uint32_t pieces_;
  std::vector<std::uint8_t> is_done_;  // per triangle of the beginning
};

}  // namespace

Part with_split_vertices(Part part) {
  std::map<std::tuple<VertexId, std::array<std::int64_t, 3>>, VertexId> known;
  Mesh split;
  for (const Triangle& t : part.mesh.triangles) {
    const auto direction = direction_of(part.mesh, t);
    Triangle named{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto next = static_cast<VertexId>(split.vertex_count());
      const auto [entry, is_new] = known.try_emplace({t[c], direction}, next);
      if (is_new) split.positions.push_back(part.mesh.positions[t[c]]);
      named[c] = entry->second;
    }
    split.triangles.push_back(named);
  }
  part.mesh = std::move(split);
  part.is_split = true;
  return part;
}

Part as_soup(Part part) {
  Mesh soup;
  for (const Triangle& t : part.mesh.triangles) {
    const auto first = static_cast<VertexId>(soup.vertex_count());
    for (const VertexId v : t) soup.positions.push_back(part.mesh.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  part.mesh = std::move(soup);
  part.is_split = true;
  return part;
}

Part with_needles(Part part, std::uint32_t pieces) {
  Needles(part.mesh, pieces).run();
  return part;
}

Part with_fine_triangles(Part part, std::uint32_t frequency) {
  part.mesh = refine(part.mesh, frequency);
  return part;
}

Part turned_aside(Part part) {
  const auto turn = [](auto& points) {
    for (Vec3& p : points) p = aside(p);
  };
  turn(part.mesh.positions);
  for (auto& rim : part.truth.rims) turn(rim);
  for (SharpEdge& edge : part.truth.sharp) {
    turn(edge.ends);
    turn(edge.into);
  }
  return part;
}

Part with_short_numbers(Part part) {
  for (Vec3& p : part.mesh.positions) {
    for (Eigen::Index k = 0; k < 3; ++k) p[k] = static_cast<double>(static_cast<float>(p[k]));
  }
  return part;
}

Solid with_noise(Solid solid, double size, std::uint64_t random_seed) {
  std::uint64_t n = 0;
  for (Vec3& p : solid.mesh.positions) {
    for (Eigen::Index k = 0; k < 3; ++k) p[k] += size * (2 * random_unit(random_seed, n++) - 1);
  }
  return solid;
}

}  // namespace geolloyd::zoo
