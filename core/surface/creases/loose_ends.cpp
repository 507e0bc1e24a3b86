#include "core/surface/creases/loose_ends.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/surface/features/degrees.h"

namespace geolloyd {
namespace {

using ExtentOf = std::function<CurveExtent(EdgeId)>;
using IsShort = std::function<bool(const CurveExtent&)>;

class LooseEnds {
 public:
  LooseEnds(const EdgeAngles& angles, const std::vector<EdgeId>& creases)
      : angles_(angles),
        creases_(creases),
        is_boundary_(angles.mesh().vertex_count(), 0),
        is_cut_(creases.size(), 0) {
    const MeshEdges& edges = angles.edges();
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.corners(e).size() == 2) continue;
      for (const VertexId v : edges.ends[e]) is_boundary_[v] = 1;
    }
    for (std::uint32_t i = 0; i < creases.size(); ++i) {
      for (const VertexId v : edges.ends[creases[i]]) at_.emplace_back(v, i);
    }
    std::sort(at_.begin(), at_.end());
  }

  void cut(const ExtentOf& extent, const IsShort& is_short) {
    std::vector<VertexId> ends = loose_ends();
    while (!ends.empty()) {
      VertexId v = ends.back();
      ends.pop_back();
      if (!is_loose(v)) continue;
      std::vector<std::uint32_t> curve;
      CurveExtent sum;
      do {
        const std::uint32_t i = next_edge(v, curve.empty() ? no_id : curve.back());
        curve.push_back(i);
        sum.add(extent(creases_[i]));
        v = other_end(i, v);
      } while (degree(v) == 2 && is_short(sum));
      if (!is_short(sum)) continue;
      for (const std::uint32_t i : curve) is_cut_[i] = 1;
      ends.push_back(v);
    }
  }

  void straighten(double reach) {
    constexpr double bent_cosine = cosine_of_degrees(10);
    for (const VertexId end : loose_ends()) {
      if (!is_loose(end)) continue;
      std::vector<std::uint32_t> curve;
      std::vector<Vec3> directions;
      double sum = 0;
      VertexId v = end;
      do {
        const std::uint32_t i = next_edge(v, curve.empty() ? no_id : curve.back());
        curve.push_back(i);
        sum += angles_.length(creases_[i]);
        const VertexId next = other_end(i, v);
        const std::vector<Vec3>& positions = angles_.mesh().positions;
        directions.push_back(normalized(positions[next] - positions[v]));
        v = next;
      } while (degree(v) == 2 && sum <= reach);
      if (sum <= reach) continue;
      std::size_t tail = curve.size() - 1;
      while (tail > 0 && dot(directions[tail - 1], directions.back()) > bent_cosine) --tail;
      for (std::size_t i = 0; i < tail; ++i) is_cut_[curve[i]] = 1;
    }
  }

  [[nodiscard]] bool is_cut(std::size_t i) const { return is_cut_[i] != 0; }

 private:
  template <class Visit>
  void for_each_at(VertexId v, Visit&& visit) const {
    auto at = std::lower_bound(at_.begin(), at_.end(), std::pair<VertexId, std::uint32_t>{v, 0});
    for (; at != at_.end() && at->first == v; ++at) {
      if (is_cut_[at->second] == 0) visit(at->second);
    }
  }
  [[nodiscard]] std::size_t degree(VertexId v) const {
    std::size_t count = 0;
    for_each_at(v, [&](std::uint32_t) { ++count; });
    return count;
  }
  [[nodiscard]] bool is_loose(VertexId v) const { return is_boundary_[v] == 0 && degree(v) == 1; }
  [[nodiscard]] std::vector<VertexId> loose_ends() const {
    std::vector<VertexId> ends;
    for (const auto& [v, i] : at_) {
      if (is_loose(v)) ends.push_back(v);
    }
    return ends;
  }
  [[nodiscard]] VertexId other_end(std::uint32_t i, VertexId v) const {
    const auto& [a, b] = angles_.edges().ends[creases_[i]];
    return v == a ? b : a;
  }
  [[nodiscard]] std::uint32_t next_edge(VertexId v, std::uint32_t before) const {
    std::uint32_t next = no_id;
    for_each_at(v, [&](std::uint32_t i) {
      if (i != before && next == no_id) next = i;
    });
    return next;
  }

  const EdgeAngles& angles_;
  const std::vector<EdgeId>& creases_;
  std::vector<std::uint8_t> is_boundary_;               // per vertex
  std::vector<std::uint8_t> is_cut_;                    // per crease
  std::vector<std::pair<VertexId, std::uint32_t>> at_;  // a vertex, and a crease there; ascending
};

std::vector<EdgeId> without_cut(const LooseEnds& ends, const std::vector<EdgeId>& creases) {
  std::vector<EdgeId> left;
  for (std::size_t i = 0; i < creases.size(); ++i) {
    if (!ends.is_cut(i)) left.push_back(creases[i]);
  }
  return left;
}

}  // namespace

void cut_loose_ends(const EdgeAngles& angles, const ExtentOf& extent, const IsShort& is_short,
                    std::vector<EdgeId>& creases) {
  LooseEnds ends(angles, creases);
  ends.cut(extent, is_short);
  creases = without_cut(ends, creases);
}

void cut_bent_tails(const EdgeAngles& angles, double reach, std::vector<EdgeId>& creases) {
  LooseEnds ends(angles, creases);
  ends.straighten(reach);
  creases = without_cut(ends, creases);
}

}  // namespace geolloyd
