#include "core/surface/features/curve_sites.h"

#include <algorithm>
#include <utility>

#include "core/base/sorting.h"

namespace geolloyd {
namespace {

std::size_t index_of(const std::vector<VertexId>& ascending_ids, VertexId v) {
  return static_cast<std::size_t>(std::lower_bound(ascending_ids.begin(), ascending_ids.end(), v) -
                                  ascending_ids.begin());
}

class CurveSitePlacer {
 public:
  CurveSitePlacer(const SurfaceInput& input, const FeatureCurves& curves)
      : input_(input), curves_(curves) {}

  CurveSites run(double spacing) {
    result_.label.assign(curves_.vertices.size(), no_id);
    for (const VertexId v : curves_.corners) {
      result_.sites.push_back(input_.fine.positions[v]);
      label_of(v) = static_cast<RegionId>(result_.sites.size() - 1);
    }
    for (const FeatureCurve& curve : curves_.curves) add_curve(curve, curve.intervals(spacing));
    return std::move(result_);
  }

 private:
  RegionId& label_of(VertexId v) { return result_.label[index_of(curves_.vertices, v)]; }

  [[nodiscard]] RegionId corner_site(VertexId v) const {
    return static_cast<RegionId>(index_of(curves_.corners, v));
  }

  void add_curve(const FeatureCurve& curve, std::size_t intervals) {
    std::vector<std::size_t> place = even_places(curve, intervals);
    const bool is_even = has_all_places(place, intervals);
    if (!is_even) place = places_at_vertices(curve, intervals);
    std::vector<RegionId> site(intervals + 1);
    for (std::size_t i = 0; i <= intervals; ++i) {
      if ((i == 0 || i == intervals) && !curve.is_loop) {
        site[i] = corner_site(i == 0 ? curve.vertices.front() : curve.vertices.back());
      } else if (i == intervals) {
        site[i] = site[0];
      } else {
        site[i] = static_cast<RegionId>(result_.sites.size());
        const auto at = std::find(place.begin(), place.end(), i) - place.begin();
        const double even = curve.place(i, intervals);
        result_.sites.push_back(
            is_even ? curve.point_at(input_.fine, even)
                    : input_.fine.positions[curve.vertices[static_cast<std::size_t>(at)]]);
      }
    }
    const std::size_t last = curve.vertices.size() - 1;
    for (std::size_t i = curve.is_loop ? 0 : 1; i < last; ++i) {
      label_of(curve.vertices[i]) = site[place[i]];
    }
  }

  // Per vertex of a curve: the nearest of so many even places.
  static std::vector<std::size_t> even_places(const FeatureCurve& curve, std::size_t intervals) {
    std::vector<std::size_t> place;
    std::size_t nearest = 0;
    for (const double arc : curve.arc) {
      while (nearest < intervals && curve.length() > 0 &&
             2 * arc >= curve.place(nearest, intervals) + curve.place(nearest + 1, intervals)) {
        ++nearest;
      }
      place.push_back(nearest);
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
  static std::vector<std::size_t> places_at_vertices(const FeatureCurve& curve,
                                                     std::size_t intervals) {
    std::vector<std::size_t> place;
    const std::size_t edges = curve.vertices.size() - 1;
    for (std::size_t i = 0; i <= edges; ++i) place.push_back(i * intervals / edges);
    return place;
  }

  const SurfaceInput& input_;
  const FeatureCurves& curves_;
  CurveSites result_;
};

}  // namespace

CurveSites place_curve_sites(const SurfaceInput& input, const FeatureCurves& curves,
                             double spacing) {
  return CurveSitePlacer(input, curves).run(spacing);
}

std::vector<std::array<RegionId, 2>> neighbours_on_curves(const FeatureCurves& curves,
                                                          std::span<const RegionId> label) {
  std::vector<std::array<RegionId, 2>> pairs;
  for (const FeatureCurve& curve : curves.curves) {
    RegionId before = no_id;
    for (const VertexId v : curve.vertices) {
      const RegionId r = label[index_of(curves.vertices, v)];
      if (before != no_id && r != before) pairs.push_back(ascending(before, r));
      before = r;
    }
  }
  sort_and_deduplicate(pairs);
  return pairs;
}

}  // namespace geolloyd
