#include "core/surface/sites/level_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/loops.h"
#include "core/base/sorting.h"

namespace geolloyd {
namespace {

// Per vertex of the fine mesh: its corner, or else its curve, from 1; or 0.
std::vector<std::uint32_t> number_curves(const DividedSurface& surface) {
  std::vector<std::uint32_t> number(surface.input.fine.vertex_count(), 0);
  std::uint32_t next = 1;
  for (const FeatureCurve& curve : surface.curves.curves) {
    for (const VertexId v : curve.vertices) number[v] = next;
    ++next;
  }
  for (const VertexId v : surface.curves.corners) number[v] = next++;
  return number;
}

// Grid cells of a fifth of the spacing: the energy measured on such a mesh is right but for some
// thousandths. A patch so small that its least sites are closer together has smaller grid cells.
std::uint8_t grid_level_for(double distance) {
  constexpr double cell_share = 0.2;
  std::uint8_t level = 0;
  for (double cell = 2; cell > cell_share * distance && level < 21; cell /= 2) ++level;
  return level;
}

}  // namespace

LevelMesh fine_level(const DividedSurface& surface) {
  LevelMesh level{&surface.input.fine, surface.patches.of_vertex, surface.curves.vertices, {}};
  level.is_on_curve.assign(level.patch.size(), 0);
  for (const VertexId v : level.curve_vertices) level.is_on_curve[v] = 1;
  return level;
}

LevelMeshes::LevelMeshes(const DividedSurface& surface, std::span<const double> spacings,
                         Executor& executor)
    : surface_(surface) {
  levels_.reserve(spacings.size() + 1);
  coarse_.reserve(spacings.size());
  patch_.reserve(spacings.size());
  levels_.push_back(fine_level(surface));
  std::vector<std::uint32_t> curve = number_curves(surface);
  for (const double spacing : spacings) {
    add_coarser(spacing, curve, executor);
    of_.push_back(levels_.size() - 1);
  }
}

void LevelMeshes::add_coarser(double spacing, std::vector<std::uint32_t>& curve,
                              Executor& executor) {
  constexpr double least_sites = 4;
  constexpr double worth_while = 0.6;  // as many vertices, at most
  std::vector<double> distance_in;
  for (const Patch& patch : surface_.patches.patches) {
    distance_in.push_back(std::min(spacing, std::sqrt(patch.area / least_sites)));
  }
  const LevelMesh& finer = levels_.back();
  std::vector<std::uint8_t> grid_level(finer.patch.size());
  parallel_for(executor, grid_level.size(), small_items, [&](std::size_t v) {
    grid_level[v] = grid_level_for(distance_in[finer.patch[v]] /
                                   finer.mesh->finest_at(static_cast<VertexId>(v)));
  });
  CoarseMesh coarse = coarsen(*finer.mesh, {curve, grid_level}, executor);
  const auto before = static_cast<double>(finer.mesh->vertex_count());
  if (static_cast<double>(coarse.mesh.vertex_count()) > worth_while * before) return;

  LevelMesh level;
  std::vector<PatchId> patch(coarse.mesh.vertex_count());
  level.is_on_curve.resize(coarse.mesh.vertex_count());
  std::vector<std::uint32_t> coarse_curve(coarse.mesh.vertex_count());
  for (std::size_t v = 0; v < coarse.vertex_of.size(); ++v) {
    patch[coarse.vertex_of[v]] = finer.patch[v];
    coarse_curve[coarse.vertex_of[v]] = curve[v];
    level.is_on_curve[coarse.vertex_of[v]] = finer.is_on_curve[v];
  }
  for (const VertexId v : finer.curve_vertices) {
    level.curve_vertices.push_back(coarse.vertex_of[v]);
  }
  close_features(coarse);
  coarse_.push_back(std::move(coarse));
  level.mesh = &coarse_.back().mesh;
  patch_.push_back(std::move(patch));
  level.patch = patch_.back();
  levels_.push_back(std::move(level));
  curve = std::move(coarse_curve);
}

// What is left of them.
void LevelMeshes::close_features(CoarseMesh& coarse) const {
  std::vector<std::array<VertexId, 2>> edges = surface_.input.feature_edges;
  if (edges.empty()) return;
  for (auto& [a, b] : edges) {
    for (const CoarseMesh& finer : coarse_) {
      a = finer.vertex_of[a];
      b = finer.vertex_of[b];
    }
    a = coarse.vertex_of[a];
    b = coarse.vertex_of[b];
    if (a > b) std::swap(a, b);
  }
  sort_and_deduplicate(edges);
  close_edges(coarse.mesh, edges);
}

void LevelMeshes::forget_coarser() {
  coarse_ = std::vector<CoarseMesh>();
  patch_ = std::vector<std::vector<PatchId>>();
  levels_.resize(1);
}

std::vector<VertexId> LevelMeshes::map(const LevelMesh& finer, const LevelMesh& coarser) const {
  const auto from = static_cast<std::size_t>(&finer - levels_.data());
  const auto to = static_cast<std::size_t>(&coarser - levels_.data());
  std::vector<VertexId> stands_for(finer.patch.size());
  for (std::size_t v = 0; v < stands_for.size(); ++v) stands_for[v] = static_cast<VertexId>(v);
  for (std::size_t level = from; level < to; ++level) {
    for (VertexId& v : stands_for) v = coarse_[level].vertex_of[v];
  }
  return stands_for;
}

}  // namespace geolloyd
