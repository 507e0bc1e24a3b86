#include "core/surface/result/quick_remesh.h"

#include <cmath>
#include <utility>

#include "core/mesh/mesh_topology.h"
#include "core/surface/cells/cell_labels.h"
#include "core/surface/features/patches.h"
#include "core/surface/fit/largest_distances.h"
#include "core/surface/fit/surface_fit.h"
#include "core/surface/result/site_places.h"
#include "core/surface/result/surface_repair.h"
#include "core/surface/sites/site_levels.h"
#include "core/surface/sizing/equal_error.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/sizing.h"

namespace geolloyd {
namespace {

class QuickRemesher {
 public:
  QuickRemesher(const Mesh& mesh, const SurfaceInput& input, std::span<const Metric> shape,
                std::size_t count, const RemeshOptions& options, Runtime& runtime)
      : mesh_(mesh),
        input_(input),
        shape_(shape),
        count_(count),
        relaxer_(input, options, runtime, true),
        executor_(runtime.executor()),
        surface_(input, spacing_of(input.fine.whole_sized_area, static_cast<double>(count)), true,
                 executor_) {}

  std::vector<double> run() {
    if (!rest()) return {};
    Mesh remesh = dual();
    const MeshEdges edges = find_edges(remesh);
    if (!find_topology(remesh, edges).is_manifold()) return {};
    fit(remesh);
    if (relaxer_.is_interrupted()) return {};
    const std::vector<MeasuredCell> cells = measured_cells(remesh);
    const std::vector<double> lengths = lengths_of_equal_error(cells, static_cast<double>(count_));
    return has_far_cells(cells, smoothed(edges, lengths)) ? at_mesh(lengths)
                                                          : std::vector<double>();
  }

 private:
  // False after an interrupt.
  bool rest() {
    constexpr RestEffort little = {.vertex_visits = 1'000'000,
                                   .fewest_iterations = 5,
                                   .most_iterations = 50,
                                   .tries_again = false};
    constexpr std::size_t few = 1000;
    RestingSites resting = rest_sites(surface_, count_, relaxer_, little, executor_);
    if (relaxer_.is_interrupted()) return false;
    dualised_ = repair_dual(surface_, std::move(resting), 2 * count_ + few, relaxer_, executor_);
    relaxer_.release_engine();
    return !relaxer_.is_interrupted();
  }

  Mesh dual() {
    Mesh remesh;
    places_ = place_sites(mesh_, input_, dualised_.state.sites.positions, dualised_.state.labels,
                          executor_);
    for (const SurfacePoint& place : places_) {
      remesh.positions.push_back(position_of(mesh_, place));
    }
    remesh.triangles = std::move(dualised_.dual.triangles);
    return remesh;
  }

  void fit(Mesh& remesh) {
    constexpr int rounds = 2;
    const auto keep_going = [this] { return relaxer_.ask(dualised_.state.sites); };
    fit_to_surface(input_, dualised_.state.labels, dualised_.state.sites.on_curves,
                   shapes_at(mesh_, shape_, places_), remesh, executor_, {rounds, keep_going});
  }

  [[nodiscard]] std::vector<MeasuredCell> measured_cells(const Mesh& remesh) const {
    const std::vector<double> distance = largest_distances(
        input_, dualised_.state.labels, surface_.curves.vertices, remesh, executor_);
    const std::vector<double> inverse_sizing =
        inverse_sizing_at_sites(input_.fine, distance.size(), dualised_.state.labels);
    const double spacing =
        spacing_of(input_.fine.whole_sized_area, static_cast<double>(distance.size()));
    std::vector<MeasuredCell> cells;
    cells.reserve(distance.size());
    for (std::size_t r = 0; r < distance.size(); ++r) {
      const double shorter = inverse_sizing.empty() ? 1 : inverse_sizing[r];
      cells.push_back({spacing / shorter, distance[r]});
    }
    return cells;
  }

  // Cells without six neighbours are farther, but where they are is another matter in the next
  // remesh.
  static std::vector<double> smoothed(const MeshEdges& edges, const std::vector<double>& lengths) {
    std::vector<double> sum = lengths;
    std::vector<double> count(lengths.size(), 1);
    for (const auto& [a, b] : edges.ends) {
      sum[a] += lengths[b];
      sum[b] += lengths[a];
      ++count[a];
      ++count[b];
    }
    for (std::size_t r = 0; r < sum.size(); ++r) sum[r] /= count[r];
    return sum;
  }

  // Where all are about equally far, lengths that vary make the largest distance larger.
  [[nodiscard]] bool has_far_cells(std::span<const MeasuredCell> cells,
                                   std::span<const double> lengths) const {
    constexpr double much_shorter = 0.8;
    const double even = std::sqrt(static_cast<double>(cells.size()) / static_cast<double>(count_));
    for (std::size_t r = 0; r < cells.size(); ++r) {
      if (lengths[r] < much_shorter * even * cells[r].length) return true;
    }
    return false;
  }

  // The mean number of cells on the triangles about a vertex.
  [[nodiscard]] std::vector<double> at_mesh(const std::vector<double>& at_sites) const {
    const FineMesh& fine = input_.fine;
    std::vector<double> cells(mesh_.vertex_count(), 0);
    std::vector<double> area(mesh_.vertex_count(), 0);
    for (TriangleId t = 0; t < fine.triangle_count(); ++t) {
      double sum = 0;
      for (const VertexId v : fine.triangles[t]) {
        const double length = at_sites[dualised_.state.labels[v]];
        sum += 1 / (3 * length * length);
      }
      const double of_triangle = fine.area(t);
      for (const VertexId v : mesh_.triangles[input_.origin[t]]) {
        cells[v] += of_triangle * sum;
        area[v] += of_triangle;
      }
    }
    for (std::size_t v = 0; v < cells.size(); ++v) {
      cells[v] = cells[v] > 0 ? std::sqrt(area[v] / cells[v]) : 1;
    }
    return cells;
  }

  const Mesh& mesh_;
  const SurfaceInput& input_;
  std::span<const Metric> shape_;
  std::size_t count_;
  SiteRelaxer relaxer_;
  Executor& executor_;
  DividedSurface surface_;
  DualisedSites dualised_;
  std::vector<SurfacePoint> places_;
};

}  // namespace

std::vector<double> lengths_by_quick_remesh(const Mesh& mesh, const SurfaceInput& input,
                                            std::span<const Metric> shape, std::size_t count,
                                            const RemeshOptions& options, Runtime& runtime) {
  return QuickRemesher(mesh, input, shape, count, options, runtime).run();
}

}  // namespace geolloyd
