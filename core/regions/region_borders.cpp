#include "core/regions/region_borders.h"

#include <algorithm>
#include <numbers>

namespace geolloyd {
namespace {

using Edge = std::array<PointId, 2>;  // ascending
using Place = std::uint32_t;          // number of a cut edge

// The cuts of one triangle between two regions, or of a corner between three.
struct TriangleCuts {
  std::array<Place, 3> places = {no_id, no_id, no_id};  // the last only of a corner
};

class Borders {
 public:
  Borders(const Mesh& mesh, const RegionSurface& surface)
      : mesh_(mesh), surface_(surface), length_(surface.region_count, 0) {}

  std::vector<double> run() {
    gather();
    constexpr int passes = 6;
    for (int pass = 0; pass < passes; ++pass) smooth();
    for (const TriangleCuts& cuts : cuts_) measure(cuts);
    for (const IrregularEdge& edge : surface_.irregular_edges) {
      if (edge.triangles == 1) follow_boundary(edge.ends[0], edge.ends[1]);
    }
    return std::move(length_);
  }

 private:
  [[nodiscard]] RegionId region(PointId p) const { return surface_.region[p]; }

  void gather() {
    std::vector<std::array<Edge, 3>> edges_of;
    for (const Triangle& t : surface_.triangles) {
      std::array<Edge, 3> cut{};
      std::size_t count = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const PointId a = t[c];
        const PointId b = t[(c + 1) % 3];
        if (region(a) != region(b)) cut[count++] = {std::min(a, b), std::max(a, b)};
      }
      if (count == 0) continue;
      edges_.insert(edges_.end(), cut.begin(), cut.begin() + static_cast<std::ptrdiff_t>(count));
      edges_of.push_back(cut);
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    for (const Edge& e : edges_) at_.push_back(cut(e[0], e[1]));
    for (const std::array<Edge, 3>& cut : edges_of) {
      TriangleCuts cuts;
      const std::size_t count = cut[2] == Edge{} ? 2 : 3;
      for (std::size_t i = 0; i < count; ++i) {
        cuts.places[i] = static_cast<Place>(std::lower_bound(edges_.begin(), edges_.end(), cut[i]) -
                                            edges_.begin());
      }
      cuts_.push_back(cuts);
    }
  }

  // Where an edge between two regions is as far from one seed as from the other.
  [[nodiscard]] Vec3 cut(PointId a, PointId b) const {
    Vec3 from = surface_.position(mesh_, a);
    const Vec3 way = surface_.position(mesh_, b) - from;
    const double length = norm(way);
    if (!(length > 0)) return from;
    const double share = 0.5 + 0.5 * (surface_.distance[b] - surface_.distance[a]) / length;
    return from + std::clamp(share, 0.0, 1.0) * way;
  }

  // Each cut half way to the middle of its neighbours along the border. Ends stay.
  void smooth() {
    std::vector<Vec3> sum(at_.size(), Vec3::Zero());
    std::vector<std::uint8_t> neighbours(at_.size(), 0);
    const auto join = [&](Place a, const Vec3& b) {
      sum[a] += b;
      ++neighbours[a];
    };
    for (const TriangleCuts& cuts : cuts_) {
      const auto [a, b, c] = cuts.places;
      if (c == no_id) {
        join(a, at_[b]);
        join(b, at_[a]);
      } else {
        const Vec3 middle = (at_[a] + at_[b] + at_[c]) / 3;
        for (const Place p : cuts.places) join(p, middle);
      }
    }
    for (std::size_t i = 0; i < at_.size(); ++i) {
      if (neighbours[i] == 2) at_[i] = 0.5 * at_[i] + 0.25 * sum[i];
    }
  }

  void add(Place p, double length) {
    for (const PointId end : edges_[p]) {
      if (region(end) != no_id) length_[region(end)] += length;
    }
  }

  void measure(const TriangleCuts& cuts) {
    const auto [a, b, c] = cuts.places;
    if (c == no_id) {
      add(a, norm(at_[a] - at_[b]));
      return;
    }
    const Vec3 middle = (at_[a] + at_[b] + at_[c]) / 3;
    for (const Place p : cuts.places) add(p, norm(at_[p] - middle));
  }

  void follow_boundary(PointId a, PointId b) {
    const Vec3 middle = region(a) == region(b) ? surface_.position(mesh_, a) : cut(a, b);
    if (region(a) != no_id) length_[region(a)] += norm(surface_.position(mesh_, a) - middle);
    if (region(b) != no_id) length_[region(b)] += norm(surface_.position(mesh_, b) - middle);
  }

  const Mesh& mesh_;
  const RegionSurface& surface_;
  std::vector<double> length_;
  std::vector<Edge> edges_;  // between two regions, ascending
  std::vector<Vec3> at_;     // per edge: where it is cut
  std::vector<TriangleCuts> cuts_;
};

}  // namespace

std::vector<double> border_lengths(const Mesh& mesh, const RegionSurface& surface) {
  return Borders(mesh, surface).run();
}

double isoperimetric_ratio(double area, double perimeter) {
  return perimeter > 0 ? 4 * std::numbers::pi * area / (perimeter * perimeter) : 0;
}

}  // namespace geolloyd
