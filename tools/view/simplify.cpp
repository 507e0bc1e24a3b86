#include "tools/view/simplify.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace geolloyd {
namespace {

using Positions = std::vector<float>;

constexpr double finest_grid = 1 << 16;  // cells from -1 to 1: three of their numbers fit a key

struct CellVertex {
  std::uint64_t cell;
  std::uint32_t vertex;
};

std::vector<CellVertex> sort_into_cells(const Positions& positions, double cells) {
  std::vector<CellVertex> sorted(positions.size() / 3);
  for (std::size_t v = 0; v < sorted.size(); ++v) {
    std::uint64_t cell = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double place = (std::clamp(double{positions[3 * v + c]}, -1.0, 1.0) + 1) / 2 * cells;
      cell = cell << 20 | static_cast<std::uint64_t>(place);
    }
    sorted[v] = {cell, static_cast<std::uint32_t>(v)};
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const CellVertex& a, const CellVertex& b) { return a.cell < b.cell; });
  return sorted;
}

std::size_t count_cells(const std::vector<CellVertex>& sorted) {
  std::size_t count = sorted.empty() ? 0 : 1;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].cell != sorted[i - 1].cell) ++count;
  }
  return count;
}

// The finest grid that has no more cells with vertices, among those a tenth apart.
std::vector<CellVertex> fitting_cells(const Positions& positions, std::size_t most) {
  // A surface in a ball of radius 1 meets some 8 cells^2 of a grid.
  double cells = std::min(finest_grid, 2 * std::sqrt(static_cast<double>(most)));
  for (;; cells = std::max(1.0, std::floor(cells / 1.1))) {
    std::vector<CellVertex> sorted = sort_into_cells(positions, cells);
    if (cells <= 1 || count_cells(sorted) <= most) return sorted;
  }
}

std::uint32_t nearest_to_mean(const Positions& positions, const CellVertex* begin,
                              const CellVertex* end) {
  const auto place = [&](std::size_t v) -> Vec3 {
    return {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
  };
  Vec3 mean = Vec3::Zero();
  for (const CellVertex* i = begin; i != end; ++i) mean += place(i->vertex);
  mean /= static_cast<double>(end - begin);
  const CellVertex* best = begin;
  for (const CellVertex* i = begin; i != end; ++i) {
    if (norm(place(i->vertex) - mean) < norm(place(best->vertex) - mean)) best = i;
  }
  return best->vertex;
}

// What stays, by old number, ascending, and what old vertices become.
struct Kept {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> vertex_of;
};

Kept choose(const Positions& positions, const std::vector<std::uint32_t>& corners,
            std::size_t most) {
  const std::vector<CellVertex> sorted = fitting_cells(positions, most);
  Kept kept;
  kept.vertex_of.resize(sorted.size());
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::find_if(begin, sorted.end(),
                                  [&](const CellVertex& v) { return v.cell != begin->cell; });
    const std::uint32_t stays = nearest_to_mean(positions, &*begin, &*begin + (end - begin));
    for (auto i = begin; i != end; ++i) kept.vertex_of[i->vertex] = stays;
    kept.vertices.push_back(stays);
    begin = end;
  }
  std::sort(kept.vertices.begin(), kept.vertices.end());
  std::vector<std::uint32_t> number(sorted.size());
  for (std::size_t i = 0; i < kept.vertices.size(); ++i) {
    number[kept.vertices[i]] = static_cast<std::uint32_t>(i);
  }
  for (std::uint32_t& v : kept.vertex_of) v = number[v];
  for (std::size_t t = 0; t < corners.size() / 3; ++t) {
    const std::uint32_t a = kept.vertex_of[corners[3 * t]];
    const std::uint32_t b = kept.vertex_of[corners[3 * t + 1]];
    const std::uint32_t c = kept.vertex_of[corners[3 * t + 2]];
    if (a != b && b != c && c != a) kept.triangles.push_back(static_cast<std::uint32_t>(t));
  }
  return kept;
}

template <class Number>
void keep(std::vector<Number>& values, const std::vector<std::uint32_t>& entries,
          std::size_t components, std::size_t first, std::vector<Number>& kept) {
  for (const std::uint32_t entry : entries) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>((first + entry) * components);
    kept.insert(kept.end(), begin, begin + static_cast<std::ptrdiff_t>(components));
  }
}

void keep(BundleArray& array, const Kept& kept) {
  std::visit(
      [&](auto& values) {
        std::remove_reference_t<decltype(values)> left;
        if (array.per != "triangle") keep(values, kept.vertices, array.components, 0, left);
        if (array.per != "vertex") {
          const std::size_t first = array.per == "both" ? kept.vertex_of.size() : 0;
          keep(values, kept.triangles, array.components, first, left);
        }
        values = std::move(left);
      },
      array.values);
}

BundleArray& find(Bundle& bundle, const std::string& name) {
  return *std::find_if(bundle.arrays.begin(), bundle.arrays.end(),
                       [&](const BundleArray& array) { return array.name == name; });
}

}  // namespace

void simplify(Bundle& bundle, std::size_t vertex_limit) {
  auto& corners = std::get<std::vector<std::uint32_t>>(find(bundle, "triangles").values);
  const Kept kept =
      choose(std::get<Positions>(find(bundle, "positions").values), corners, vertex_limit);
  std::erase_if(bundle.arrays, [](const BundleArray& array) { return array.name == "parent"; });
  for (std::uint32_t& corner :
       std::get<std::vector<std::uint32_t>>(find(bundle, "triangles").values)) {
    corner = kept.vertex_of[corner];
  }
  for (BundleArray& array : bundle.arrays) {
    if (!array.per.empty()) keep(array, kept);
  }
}

}  // namespace geolloyd
