#include "core/surface/site_budget.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/rounding.h"

namespace geolloyd {
namespace {

constexpr double root_3 = 1.7320508075688772;

}  // namespace

std::vector<SurfacePart> find_surface_parts(const SurfaceInput& input, const OuterChains& outer) {
  const FineMesh& fine = input.fine;
  std::vector<SurfacePart> parts(input.parts);
  std::vector<std::int64_t> doubled(input.parts, 0);  // inner edges count half for each triangle
  for (VertexId v = 0; v < fine.vertex_count(); ++v) doubled[input.part[v]] += 2;
  for (TriangleId t = 0; t < fine.triangle_count(); ++t) {
    const std::uint32_t part = input.part[fine.triangles[t][0]];
    doubled[part] += 2 - 3;
    parts[part].area += fine.area[t];
  }
  for (const auto& ends : input.outer_edges) --doubled[input.part[ends[0]]];
  for (std::size_t p = 0; p < parts.size(); ++p) parts[p].euler_characteristic = doubled[p] / 2;
  for (const auto& pinhole : outer.pinholes) {
    ++parts[input.part[pinhole.front()]].euler_characteristic;
  }
  for (const OuterChain& chain : outer.chains) {
    parts[input.part[chain.vertices.front()]].is_closed = false;
  }
  return parts;
}

std::size_t SiteBudget::total() const {
  return std::accumulate(free.begin(), free.end(), outer);
}

SiteBudgeter::SiteBudgeter(const SurfaceInput& input, const OuterChains& outer)
    : input_(input), outer_(outer), parts_(find_surface_parts(input, outer)) {}

// Triangles of an edge of `spacing` cover a part; Euler's formula gives their vertices.
std::vector<double> SiteBudgeter::wanted_free(double spacing) const {
  constexpr double least_closed = 4;
  std::vector<double> wanted(parts_.size());
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    wanted[p] = 2 * parts_[p].area / (root_3 * spacing * spacing) +
                static_cast<double>(parts_[p].euler_characteristic);
  }
  for (const OuterChain& chain : outer_.chains) {
    wanted[input_.part[chain.vertices.front()]] -=
        static_cast<double>(chain.intervals(spacing)) / 2;
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    wanted[p] = std::max(wanted[p], parts_[p].is_closed ? least_closed : 0);
  }
  return wanted;
}

SiteBudget SiteBudgeter::at_spacing(double spacing) const {
  SiteBudget budget{spacing, outer_.corners.size(), {}};
  for (const OuterChain& chain : outer_.chains) {
    budget.outer += chain.intervals(spacing) - (chain.is_loop ? 0 : 1);
  }
  for (const double wanted : wanted_free(spacing)) {
    budget.free.push_back(round_to_whole(wanted));
  }
  return budget;
}

SiteBudget SiteBudgeter::of_size(std::size_t count) const {
  double low = 1e-9;
  double high = 16;
  for (int i = 0; i < 200 && low < high * (1 - 1e-12); ++i) {
    const double middle = std::sqrt(low * high);
    (at_spacing(middle).total() > count ? low : high) = middle;
  }
  SiteBudget budget = at_spacing(high);
  const std::vector<double> wanted = wanted_free(high);
  std::vector<std::size_t> order(parts_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return wanted[a] - static_cast<double>(budget.free[a]) >
           wanted[b] - static_cast<double>(budget.free[b]);
  });
  const std::size_t total = budget.total();
  for (std::size_t i = 0; total + i < count; ++i) ++budget.free[order[i % order.size()]];
  return budget;
}

}  // namespace geolloyd
