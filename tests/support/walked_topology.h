#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// What a mesh is like, found by counting and walking, without the code that is tested.
struct WalkedTopology {
  std::string flaw;  ///< the first reason why it is no manifold; empty where it is one
  /// Per connected part its Euler characteristic and number of boundary loops; ascending.
  std::vector<std::array<std::int64_t, 2>> parts;
};

class TopologyWalk {
 public:
  explicit TopologyWalk(const std::vector<Triangle>& triangles, std::size_t vertex_count)
      : triangles_(triangles), around_(vertex_count) {}

  WalkedTopology run() {
    WalkedTopology found;
    found.flaw = flaw_of_triangles();
    if (found.flaw.empty()) found.flaw = flaw_of_edges();
    if (found.flaw.empty()) found.flaw = flaw_of_fans();
    if (found.flaw.empty()) count_parts(found);
    return found;
  }

 private:
  using Edge = std::pair<VertexId, VertexId>;
  static constexpr TriangleId none = no_id;

  static Edge edge(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

  // All with three vertices, and no two with the same.
  std::string flaw_of_triangles() {
    std::vector<Triangle> sorted = triangles_;
    for (Triangle& t : sorted) std::sort(t.begin(), t.end());
    for (const Triangle& t : sorted) {
      if (t[0] == t[1] || t[1] == t[2]) return "a triangle names a vertex twice";
    }
    std::sort(sorted.begin(), sorted.end());
    const bool has_twins = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    return has_twins ? "two triangles have the same vertices" : "";
  }

  std::string flaw_of_edges() {
    std::vector<std::pair<Edge, TriangleId>> sides;
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      const Triangle& v = triangles_[t];
      for (std::size_t c = 0; c < 3; ++c) {
        around_[v[c]].push_back(t);
        sides.emplace_back(edge(v[c], v[(c + 1) % 3]), t);
      }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i;
      while (end < sides.size() && sides[end].first == sides[i].first) ++end;
      if (end - i > 2) return "an edge has " + std::to_string(end - i) + " triangles";
      edges_.push_back(
          {sides[i].first, {sides[i].second, end - i == 2 ? sides[i + 1].second : none}});
      i = end;
    }
    return "";
  }

  [[nodiscard]] const std::array<TriangleId, 2>& triangles_at(const Edge& e) const {
    return std::lower_bound(edges_.begin(), edges_.end(), e,
                            [](const auto& entry, const Edge& key) { return entry.first < key; })
        ->second;
  }

  // The two other vertices of a triangle.
  [[nodiscard]] std::array<VertexId, 2> others(TriangleId t, VertexId v) const {
    std::array<VertexId, 2> found{};
    std::size_t count = 0;
    for (const VertexId u : triangles_[t]) {
      if (u != v) found[count++] = u;
    }
    return found;
  }

  // Steps over the edges at a vertex, from triangle to triangle, to the end or around.
  [[nodiscard]] std::size_t walk(VertexId v, TriangleId first, VertexId over) const {
    std::size_t steps = 0;
    TriangleId at = first;
    while (true) {
      const auto& sides = triangles_at(edge(v, over));
      const TriangleId next = sides[0] == at ? sides[1] : sides[0];
      if (next == none || next == first) return steps;
      ++steps;
      at = next;
      const std::array<VertexId, 2> ends = others(at, v);
      over = ends[0] == over ? ends[1] : ends[0];
    }
  }

  // One fan about every vertex: the triangles that can be walked to are all.
  std::string flaw_of_fans() const {
    for (VertexId v = 0; v < around_.size(); ++v) {
      if (around_[v].empty()) return "vertex " + std::to_string(v) + " has no triangle";
      const TriangleId first = around_[v].front();
      const std::array<VertexId, 2> ends = others(first, v);
      const std::size_t one_way = walk(v, first, ends[0]);
      const std::size_t all = around_[v].size();
      if (one_way + 1 == all) continue;
      if (one_way + walk(v, first, ends[1]) + 1 == all) continue;
      return "the triangles of vertex " + std::to_string(v) + " are no fan";
    }
    return "";
  }

  void count_parts(WalkedTopology& found) const {
    const std::vector<std::size_t> part = flood([](const auto&) { return true; });
    const std::vector<std::size_t> loop =
        flood([](const auto& entry) { return entry.second[1] == none; });
    std::map<std::size_t, std::array<std::int64_t, 2>> by_part;
    for (const std::size_t p : part) ++by_part[p][0];
    for (const auto& [ends, sides] : edges_) --by_part[part[ends.first]][0];
    for (const Triangle& t : triangles_) ++by_part[part[t[0]]][0];
    std::vector<std::uint8_t> is_on_boundary(part.size(), 0);
    for (const auto& [ends, sides] : edges_) {
      if (sides[1] == none) is_on_boundary[ends.first] = is_on_boundary[ends.second] = 1;
    }
    for (std::size_t v = 0; v < part.size(); ++v) {
      if (is_on_boundary[v] != 0 && loop[v] == v) ++by_part[part[v]][1];
    }
    for (const auto& [name, topology] : by_part) found.parts.push_back(topology);
    std::sort(found.parts.begin(), found.parts.end());
  }

  // Per vertex: the smallest that is connected to it by edges of that kind.
  template <class IsMeant>
  [[nodiscard]] std::vector<std::size_t> flood(IsMeant&& is_meant) const {
    std::vector<std::vector<VertexId>> beside(around_.size());
    for (const auto& entry : edges_) {
      if (!is_meant(entry)) continue;
      beside[entry.first.first].push_back(entry.first.second);
      beside[entry.first.second].push_back(entry.first.first);
    }
    constexpr auto unseen = static_cast<std::size_t>(-1);
    std::vector<std::size_t> name(around_.size(), unseen);
    for (std::size_t v = 0; v < name.size(); ++v) {
      if (name[v] != unseen) continue;
      name[v] = v;
      for (std::vector<std::size_t> open = {v}; !open.empty();) {
        const std::size_t u = open.back();
        open.pop_back();
        for (const VertexId w : beside[u]) {
          if (name[w] != unseen) continue;
          name[w] = v;
          open.push_back(w);
        }
      }
    }
    return name;
  }

  const std::vector<Triangle>& triangles_;
  std::vector<std::vector<TriangleId>> around_;  // per vertex
  std::vector<std::pair<Edge, std::array<TriangleId, 2>>> edges_;
};

/// Of a mesh all whose vertices are to be used.
inline WalkedTopology walk_topology(const Mesh& mesh) {
  return TopologyWalk(mesh.triangles, mesh.vertex_count()).run();
}

}  // namespace geolloyd
