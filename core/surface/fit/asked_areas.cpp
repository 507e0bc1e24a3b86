#include "core/surface/fit/asked_areas.h"

#include <cmath>

namespace geolloyd {

AskedAreas find_asked_areas(const MovingRemesh& remesh, bool is_graded) {
  constexpr int rounds = 4;
  std::vector<double> area(remesh.triangle_count());
  double sum = 0;
  for (std::size_t t = 0; t < area.size(); ++t) {
    const auto& [a, b, c] = remesh.triangles[t];
    const std::vector<Vec3>& p = remesh.positions;
    area[t] = norm(cross(p[b] - p[a], p[c] - p[a])) / 2;
    sum += area[t];
  }
  const double mean = sum / static_cast<double>(area.size());
  AskedAreas asked = {std::sqrt(4 / std::sqrt(3.0) * mean),
                      std::vector<double>(remesh.vertex_count(), mean)};
  for (int round = 0; is_graded && round < rounds; ++round) {
    for (std::size_t v = 0; v < asked.at_vertex.size(); ++v) {
      double around = 0;
      for (const TriangleId t : remesh.triangles_at[v]) around += area[t];
      const auto count = static_cast<double>(remesh.triangles_at[v].size());
      asked.at_vertex[v] = count > 0 ? around / count : mean;
    }
    for (std::size_t t = 0; t < area.size(); ++t) {
      const auto& [a, b, c] = remesh.triangles[t];
      area[t] = (asked.at_vertex[a] + asked.at_vertex[b] + asked.at_vertex[c]) / 3;
    }
  }
  return asked;
}

}  // namespace geolloyd
