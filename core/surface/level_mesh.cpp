#include "core/surface/level_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

// Vertices on the boundary are merged with others on it alone.
std::vector<std::uint32_t> merging_groups(const LevelMesh& level) {
  return {level.is_outer.begin(), level.is_outer.end()};
}

}  // namespace

LevelMesh fine_level(const SurfaceInput& input, const OuterChains& outer) {
  LevelMesh level{&input.fine, input.part, outer.vertices, {}};
  level.is_outer.assign(input.fine.vertex_count(), 0);
  for (const VertexId v : outer.vertices) level.is_outer[v] = 1;
  return level;
}

LevelMeshes::LevelMeshes(const SurfaceInput& input, const OuterChains& outer,
                         std::span<const double> spacings, Executor& executor)
    : area_(input.parts, 0) {
  for (TriangleId t = 0; t < input.fine.triangle_count(); ++t) {
    area_[input.part[input.fine.triangles[t][0]]] += input.fine.area[t];
  }
  levels_.reserve(spacings.size() + 1);
  coarse_.reserve(spacings.size());
  levels_.push_back(fine_level(input, outer));
  for (const double spacing : spacings) {
    add_coarser(spacing, executor);
    of_.push_back(levels_.size() - 1);
  }
}

// Grid cells of a fifth of the spacing: the energy measured on such a mesh is right but for some
// thousandths. A part so small that its least sites are closer together has smaller grid cells.
void LevelMeshes::add_coarser(double spacing, Executor& executor) {
  constexpr double cell_share = 0.2;
  constexpr double least_sites = 4;
  constexpr double worth_while = 0.6;  // as many vertices, at most
  std::vector<std::uint8_t> level_of_part;
  for (const double area : area_) {
    const double distance = std::min(spacing, std::sqrt(area / least_sites));
    std::uint8_t level = 0;
    for (double cell = 2; cell > cell_share * distance && level < 21; cell /= 2) ++level;
    level_of_part.push_back(level);
  }
  const LevelMesh& finer = levels_.back();
  std::vector<std::uint8_t> grid_level(finer.part.size());
  for (std::size_t v = 0; v < grid_level.size(); ++v) grid_level[v] = level_of_part[finer.part[v]];
  const std::vector<std::uint32_t> groups = merging_groups(finer);
  CoarseMesh coarse = coarsen(*finer.mesh, {groups, grid_level}, executor);
  const auto before = static_cast<double>(finer.mesh->vertex_count());
  if (static_cast<double>(coarse.mesh.vertex_count()) > worth_while * before) return;

  LevelMesh level;
  level.part.resize(coarse.mesh.vertex_count());
  level.is_outer.resize(coarse.mesh.vertex_count());
  for (std::size_t v = 0; v < coarse.vertex_of.size(); ++v) {
    level.part[coarse.vertex_of[v]] = finer.part[v];
    level.is_outer[coarse.vertex_of[v]] = finer.is_outer[v];
  }
  for (const VertexId v : finer.outer_vertices) {
    level.outer_vertices.push_back(coarse.vertex_of[v]);
  }
  coarse_.push_back(std::move(coarse));
  level.mesh = &coarse_.back().mesh;
  levels_.push_back(std::move(level));
}

std::vector<VertexId> LevelMeshes::map(const LevelMesh& finer, const LevelMesh& coarser) const {
  const auto from = static_cast<std::size_t>(&finer - levels_.data());
  const auto to = static_cast<std::size_t>(&coarser - levels_.data());
  std::vector<VertexId> stands_for(finer.part.size());
  for (std::size_t v = 0; v < stands_for.size(); ++v) stands_for[v] = static_cast<VertexId>(v);
  for (std::size_t level = from; level < to; ++level) {
    for (VertexId& v : stands_for) v = coarse_[level].vertex_of[v];
  }
  return stands_for;
}

}  // namespace geolloyd
