#include "core/surface/outer_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/rounding.h"

namespace geolloyd {
namespace {

// A closed polygon of boundary vertices.
class Loop {
 public:
  Loop(const FineMesh& mesh, std::vector<VertexId> vertices)
      : mesh_(mesh), vertices_(std::move(vertices)), arc_(vertices_.size() + 1, 0) {
    for (std::size_t i = 0; i < size(); ++i) {
      arc_[i + 1] = arc_[i] + norm(position(i + 1) - position(i));
    }
  }

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] double length() const { return arc_.back(); }
  [[nodiscard]] const std::vector<VertexId>& vertices() const { return vertices_; }

  /// Three sites on it would be closer together than they should.
  [[nodiscard]] bool is_pinhole(double spacing) const {
    constexpr double least_share = 0.6;  // of a spacing
    const double third = length() / 3;
    if (third < least_share * spacing) return true;
    if (third > 1.5 * spacing) return false;
    const Vec3 a = position(0);
    const Vec3 b = point_at(0, third);
    const Vec3 c = point_at(0, 2 * third);
    return std::min({norm(a - b), norm(b - c), norm(c - a)}) < least_share * spacing;
  }

  /// Places in `vertices` at which it turns most sharply within `reach`, ascending.
  [[nodiscard]] std::vector<std::size_t> corners(double reach) const {
    std::vector<double> turn(size());  // cosine
    for (std::size_t i = 0; i < size(); ++i) turn[i] = cosine_of_turn(i, reach);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < size(); ++i) {
      constexpr double sharp_cosine = 0.6427876096865394;  // of 50 degrees
      if (turn[i] < sharp_cosine && is_sharpest(turn, i, reach)) found.push_back(i);
    }
    return found;
  }

  /// From one place to a later one, or around to it.
  [[nodiscard]] OuterChain chain(std::size_t from, std::size_t to) const {
    OuterChain chain;
    for (std::size_t i = from; i <= to; ++i) {
      chain.vertices.push_back(vertices_[i % size()]);
      chain.arc.push_back(
          i == from ? 0 : chain.arc.back() + (arc_[(i - 1) % size() + 1] - arc_[(i - 1) % size()]));
    }
    return chain;
  }

 private:
  [[nodiscard]] const Vec3& position(std::size_t i) const {
    return mesh_.positions[vertices_[i % size()]];
  }

  // At `way` along the loop from vertex i; negative: backward.
  [[nodiscard]] Vec3 point_at(std::size_t i, double way) const {
    const std::size_t step = way > 0 ? 1 : size() - 1;
    if (!(length() > 0)) return position(i);
    double left = std::abs(way);
    if (left >= length()) left = std::fmod(left, length());  // which is exact
    while (true) {
      const std::size_t next = (i + step) % size();
      const double edge = norm(position(next) - position(i));
      if (left < edge) return position(i) + (position(next) - position(i)) * (left / edge);
      left -= edge;
      i = next;
    }
  }

  [[nodiscard]] double cosine_of_turn(std::size_t i, double reach) const {
    const Vec3 in = normalized(position(i) - point_at(i, -reach));
    const Vec3 out = normalized(point_at(i, reach) - position(i));
    return dot(in, out);
  }

  // Of equals, the first one.
  [[nodiscard]] bool is_sharpest(const std::vector<double>& turn, std::size_t i,
                                 double reach) const {
    for (const std::size_t step : {std::size_t{1}, size() - 1}) {
      double way = 0;
      for (std::size_t j = i; way <= reach;) {
        const std::size_t next = (j + step) % size();
        way += norm(position(next) - position(j));
        j = next;
        if (j == i || way > reach) break;
        if (std::pair(turn[j], j) < std::pair(turn[i], i)) return false;
      }
    }
    return true;
  }

  const FineMesh& mesh_;
  std::vector<VertexId> vertices_;
  std::vector<double> arc_;
};

// Every boundary vertex has two outer edges. A loop begins at its smallest vertex and goes toward
// the smaller of its neighbours.
std::vector<std::vector<VertexId>> find_loops(const SurfaceInput& input) {
  std::vector<std::array<VertexId, 2>> both;  // in both directions
  for (const auto& [a, b] : input.outer_edges) {
    both.push_back({a, b});
    both.push_back({b, a});
  }
  std::sort(both.begin(), both.end());
  std::vector<bool> is_done(both.size(), false);
  std::vector<std::vector<VertexId>> loops;
  for (std::size_t i = 0; i < both.size(); i += 2) {
    if (is_done[i]) continue;
    std::vector<VertexId>& loop = loops.emplace_back();
    VertexId before = no_id;
    for (std::size_t at = i; !is_done[at];) {
      is_done[at] = true;
      const VertexId v = both[at][0];
      loop.push_back(v);
      const VertexId next = both[at][1] != before ? both[at][1] : both[at + 1][1];
      before = v;
      const auto found =
          std::lower_bound(both.begin(), both.end(), std::array<VertexId, 2>{next, 0});
      at = static_cast<std::size_t>(found - both.begin());
    }
  }
  return loops;
}

Vec3 point_at(const FineMesh& mesh, const OuterChain& chain, double at) {
  const auto above = std::upper_bound(chain.arc.begin() + 1, chain.arc.end() - 1, at);
  const auto edge = static_cast<std::size_t>(above - chain.arc.begin()) - 1;
  const Vec3& a = mesh.positions[chain.vertices[edge]];
  const Vec3& b = mesh.positions[chain.vertices[edge + 1]];
  const double length = chain.arc[edge + 1] - chain.arc[edge];
  return length > 0 ? Vec3(a + (b - a) * ((at - chain.arc[edge]) / length)) : a;
}

// How often `spacing` goes into `length`, and no more than a chain has edges.
std::size_t intervals_of(const OuterChain& chain, double length, double spacing) {
  const std::size_t most = chain.vertices.size() - 1;
  if (!(length < spacing * static_cast<double>(most))) return most;
  return std::clamp(round_to_whole(length / spacing), std::min(chain.least_intervals, most), most);
}

// Where even places, so many as there are spacings, are joined by straight lines.
double length_of_chords(const FineMesh& mesh, const OuterChain& chain, double spacing) {
  const std::size_t count = intervals_of(chain, chain.length(), spacing);
  double sum = 0;
  Vec3 last = mesh.positions[chain.vertices.front()];
  for (std::size_t i = 1; i <= count; ++i) {
    const Vec3 next =
        point_at(mesh, chain, chain.length() * static_cast<double>(i) / static_cast<double>(count));
    sum += norm(next - last);
    last = next;
  }
  return sum;
}

// A loop that is to have few sites keeps three corners or none: chains between one or two would be
// too short for even spacing.
void add_loop(const FineMesh& mesh, const Loop& loop, double spacing, OuterChains& outer) {
  constexpr double few = 6;  // spacings
  const std::vector<std::size_t> corners = loop.corners(spacing / 2);
  if (corners.empty() || (corners.size() < 3 && loop.length() < few * spacing)) {
    const std::size_t start = corners.empty() ? 0 : corners.front();
    OuterChain& chain = outer.chains.emplace_back(loop.chain(start, start + loop.size()));
    chain.is_loop = true;
    chain.least_intervals = 3;
    chain.of_chords = length_of_chords(mesh, chain, spacing);
    return;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + loop.size();
    OuterChain& chain = outer.chains.emplace_back(loop.chain(corners[i], to));
    chain.of_chords = length_of_chords(mesh, chain, spacing);
    outer.corners.push_back(loop.vertices()[corners[i]]);
  }
}

std::size_t index_of(const std::vector<VertexId>& ascending_ids, VertexId v) {
  return static_cast<std::size_t>(std::lower_bound(ascending_ids.begin(), ascending_ids.end(), v) -
                                  ascending_ids.begin());
}

class OuterSitePlacer {
 public:
  OuterSitePlacer(const SurfaceInput& input, const OuterChains& outer)
      : input_(input), outer_(outer) {}

  OuterSites run(double spacing) {
    result_.label.assign(outer_.vertices.size(), no_id);
    for (const VertexId v : outer_.corners) {
      add_site(input_.fine.positions[v], v);
      label_of(v) = static_cast<RegionId>(result_.sites.size() - 1);
    }
    for (const OuterChain& chain : outer_.chains) add_chain(chain, chain.intervals(spacing));
    return std::move(result_);
  }

 private:
  void add_site(const Vec3& position, VertexId near) {
    result_.sites.push_back(position);
    result_.part.push_back(input_.part[near]);
  }

  RegionId& label_of(VertexId v) { return result_.label[index_of(outer_.vertices, v)]; }

  [[nodiscard]] RegionId corner_site(VertexId v) const {
    return static_cast<RegionId>(index_of(outer_.corners, v));
  }

  void add_chain(const OuterChain& chain, std::size_t intervals) {
    std::vector<std::size_t> place = even_places(chain, intervals);
    const bool is_even = has_all_places(place, intervals);
    if (!is_even) place = places_at_vertices(chain, intervals);
    std::vector<RegionId> site(intervals + 1);
    for (std::size_t i = 0; i <= intervals; ++i) {
      if ((i == 0 || i == intervals) && !chain.is_loop) {
        site[i] = corner_site(i == 0 ? chain.vertices.front() : chain.vertices.back());
      } else if (i == intervals) {
        site[i] = site[0];
      } else {
        site[i] = static_cast<RegionId>(result_.sites.size());
        const auto at = std::find(place.begin(), place.end(), i) - place.begin();
        const double even =
            chain.length() * static_cast<double>(i) / static_cast<double>(intervals);
        add_site(is_even ? point_at(input_.fine, chain, even)
                         : input_.fine.positions[chain.vertices[static_cast<std::size_t>(at)]],
                 chain.vertices.front());
      }
    }
    const std::size_t last = chain.vertices.size() - 1;
    for (std::size_t i = chain.is_loop ? 0 : 1; i < last; ++i) {
      label_of(chain.vertices[i]) = site[place[i]];
    }
  }

  // Per vertex of a chain: the nearest of so many even places.
  static std::vector<std::size_t> even_places(const OuterChain& chain, std::size_t intervals) {
    std::vector<std::size_t> place;
    const double step = chain.length() / static_cast<double>(intervals);
    for (const double arc : chain.arc) {
      const std::size_t nearest = step > 0 ? round_to_whole(arc / step) : 0;
      place.push_back(std::min(nearest, intervals));
    }
    return place;
  }

  static bool has_all_places(const std::vector<std::size_t>& place, std::size_t intervals) {
    for (std::size_t i = 1; i < intervals; ++i) {
      if (std::find(place.begin(), place.end(), i) == place.end()) return false;
    }
    return true;
  }

  // Where edges are longer than the spacing: sites on vertices, counted instead of measured.
  static std::vector<std::size_t> places_at_vertices(const OuterChain& chain,
                                                     std::size_t intervals) {
    std::vector<std::size_t> place;
    const std::size_t edges = chain.vertices.size() - 1;
    for (std::size_t i = 0; i <= edges; ++i) place.push_back(i * intervals / edges);
    return place;
  }

  const SurfaceInput& input_;
  const OuterChains& outer_;
  OuterSites result_;
};

// Per part: whether it has room for sites beside a pinhole.
std::vector<std::uint8_t> find_roomy_parts(const SurfaceInput& input, double spacing) {
  constexpr double room = 8;  // square spacings
  std::vector<double> area(input.parts, 0);
  for (TriangleId t = 0; t < input.fine.triangle_count(); ++t) {
    area[input.part[input.fine.triangles[t][0]]] += input.fine.area[t];
  }
  std::vector<std::uint8_t> is_roomy;
  is_roomy.reserve(area.size());
  for (const double a : area) is_roomy.push_back(a > room * spacing * spacing ? 1 : 0);
  return is_roomy;
}

}  // namespace

std::size_t OuterChain::intervals(double spacing) const {
  return intervals_of(*this, of_chords, spacing);
}

OuterChains find_outer_chains(const SurfaceInput& input, double spacing, bool may_have_pinholes) {
  OuterChains outer;
  const std::vector<std::uint8_t> is_roomy = find_roomy_parts(input, spacing);
  for (std::vector<VertexId>& vertices : find_loops(input)) {
    const bool may_be_pinhole = may_have_pinholes && is_roomy[input.part[vertices.front()]] != 0;
    outer.loops.push_back(vertices.front());
    const Loop loop(input.fine, std::move(vertices));
    if (may_be_pinhole && loop.is_pinhole(spacing)) {
      outer.pinholes.push_back(loop.vertices());
    } else {
      add_loop(input.fine, loop, spacing, outer);
      outer.vertices.insert(outer.vertices.end(), loop.vertices().begin(), loop.vertices().end());
    }
  }
  std::sort(outer.corners.begin(), outer.corners.end());
  std::sort(outer.vertices.begin(), outer.vertices.end());
  return outer;
}

OuterSites place_outer_sites(const SurfaceInput& input, const OuterChains& outer, double spacing) {
  return OuterSitePlacer(input, outer).run(spacing);
}

std::vector<std::array<RegionId, 2>> neighbours_on_chains(const OuterChains& outer,
                                                          std::span<const RegionId> label) {
  std::vector<std::array<RegionId, 2>> pairs;
  for (const OuterChain& chain : outer.chains) {
    RegionId before = no_id;
    for (const VertexId v : chain.vertices) {
      const RegionId r = label[index_of(outer.vertices, v)];
      if (before != no_id && r != before) pairs.push_back(ascending(before, r));
      before = r;
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace geolloyd
