#include "core/surface/features/feature_curves.h"

#include <algorithm>
#include <utility>

#include "core/base/sorting.h"
#include "core/surface/features/curve_intervals.h"
#include "core/surface/features/edge_network.h"
#include "core/surface/features/polyline.h"

namespace geolloyd {
namespace {

// Cuts a path into curves, at its corners.
class CurveCutter {
 public:
  CurveCutter(const FineMesh& mesh, double spacing, FeatureCurves& curves)
      : mesh_(mesh), spacing_(spacing), curves_(curves) {}

  // A loop that is to have few sites keeps three corners or none: curves between one or two would
  // be too short for even spacing.
  void add_loop(const std::vector<VertexId>& vertices) {
    constexpr double few = 6;  // spacings
    const Polyline loop(mesh_, vertices, true);
    const std::vector<std::size_t> corners = loop.corners(spacing_);
    if (corners.empty() || (corners.size() < 3 && loop.sized_length() < few * spacing_)) {
      const std::size_t start = corners.empty() ? 0 : corners.front();
      curves_.curves.push_back(loop.curve(start, start + loop.size()));
      curves_.curves.back().is_loop = true;
      return;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool is_last = i + 1 == corners.size();
      const std::size_t to = is_last ? corners.front() + loop.size() : corners[i + 1];
      curves_.curves.push_back(loop.curve(corners[i], to));
      curves_.corners.push_back(vertices[corners[i]]);
    }
  }

  // Its ends are corners already.
  void add_path(const std::vector<VertexId>& vertices) {
    const Polyline path(mesh_, vertices, false);
    std::size_t from = 0;
    for (const std::size_t corner : path.corners(spacing_)) {
      curves_.curves.push_back(path.curve(from, corner));
      curves_.corners.push_back(vertices[corner]);
      from = corner;
    }
    curves_.curves.push_back(path.curve(from, vertices.size() - 1));
  }

 private:
  const FineMesh& mesh_;
  double spacing_;
  FeatureCurves& curves_;
};

// Per part: whether it has room for sites beside a sub-resolution hole.
std::vector<std::uint8_t> find_roomy_parts(const SurfaceInput& input, double spacing) {
  constexpr double room = 8;  // square spacings
  std::vector<double> area(input.parts, 0);
  for (TriangleId t = 0; t < input.fine.triangle_count(); ++t) {
    area[input.part[input.fine.triangles[t][0]]] += input.fine.sized_area(t);
  }
  std::vector<std::uint8_t> is_roomy;
  is_roomy.reserve(area.size());
  for (const double a : area) is_roomy.push_back(a > room * spacing * spacing ? 1 : 0);
  return is_roomy;
}

}  // namespace

FeatureCurves find_feature_curves(const SurfaceInput& input, double spacing,
                                  bool may_have_subresolution_holes) {
  FeatureCurves curves;
  std::vector<EdgeNetwork::Edge> edges = input.feature_edges;
  edges.insert(edges.end(), input.boundary_edges.begin(), input.boundary_edges.end());
  const EdgeNetwork whole(edges, input.fixed_vertices);
  edges = input.feature_edges;
  const std::vector<std::uint8_t> is_roomy = find_roomy_parts(input, spacing);
  for (std::vector<VertexId>& loop : EdgeNetwork(input.boundary_edges, {}).take_loops()) {
    curves.loops.push_back(loop.front());
    const bool has_node =
        std::any_of(loop.begin(), loop.end(), [&](VertexId v) { return whole.is_node(v); });
    if (may_have_subresolution_holes && !has_node && is_roomy[input.part[loop.front()]] != 0 &&
        Polyline(input.fine, loop, true).is_subresolution_hole(spacing)) {
      curves.subresolution_holes.push_back(std::move(loop));
    } else {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        edges.push_back(ascending(loop[i], loop[(i + 1) % loop.size()]));
      }
    }
  }
  for (const EdgeNetwork::Edge& e : edges) {
    curves.vertices.insert(curves.vertices.end(), e.begin(), e.end());
  }
  EdgeNetwork network(std::move(edges), input.fixed_vertices);
  curves.corners = network.nodes();
  curves.vertices.insert(curves.vertices.end(), curves.corners.begin(), curves.corners.end());
  CurveCutter cutter(input.fine, spacing, curves);
  for (const auto& path : network.take_paths()) cutter.add_path(path);
  for (const auto& loop : network.take_loops()) cutter.add_loop(loop);
  find_curve_intervals(input.fine, input.feature_edges, spacing, curves.curves);
  sort_and_deduplicate(curves.corners);
  sort_and_deduplicate(curves.vertices);
  return curves;
}

}  // namespace geolloyd
