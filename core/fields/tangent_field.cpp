#include "core/fields/tangent_field.h"

#include <algorithm>
#include <array>

#include "core/base/vec3.h"
#include "core/fields/metric_mean.h"

namespace geolloyd {
namespace {

TangentSpace quarter_turn(const TangentSpace& s) {
  return {s.bitangent, -s.tangent, s.bitangent_magnitude, s.tangent_magnitude};
}

TangentSpace mirror_image(const TangentSpace& s) {
  return {s.tangent, -s.bitangent, s.tangent_magnitude, s.bitangent_magnitude};
}

double agreement(const TangentSpace& a, const TangentSpace& b) {
  return dot(a.tangent, b.tangent) + dot(a.bitangent, b.bitangent);
}

TangentSpace average_of_pair(const TangentSpace& a, const TangentSpace& b) {
  TangentSpace nearest = b;
  for (TangentSpace turned : {b, mirror_image(b)}) {
    for (int turn = 0; turn < 4; ++turn) {
      if (agreement(a, turned) > agreement(a, nearest)) nearest = turned;
      turned = quarter_turn(turned);
    }
  }
  return {normalized(a.tangent + nearest.tangent), normalized(a.bitangent + nearest.bitangent),
          (a.tangent_magnitude + nearest.tangent_magnitude) / 2,
          (a.bitangent_magnitude + nearest.bitangent_magnitude) / 2};
}

}  // namespace

TangentSpace average(const TangentSpace& a, const TangentSpace& b, Averaging averaging) {
  const bool as_metrics = averaging == Averaging::metric && has_plane(a) && has_plane(b);
  return as_metrics ? metric_mean(std::array{a, b}) : average_of_pair(a, b);
}

TangentSpace triangle_space(const Triangle& triangle, const std::vector<TangentSpace>& vertex_space,
                            Averaging averaging) {
  const std::array spaces = {vertex_space[triangle[0]], vertex_space[triangle[1]],
                             vertex_space[triangle[2]]};
  if (averaging == Averaging::metric && std::all_of(spaces.begin(), spaces.end(), has_plane)) {
    return metric_mean(spaces);
  }
  return average_of_pair(average_of_pair(spaces[0], spaces[1]), spaces[2]);
}

}  // namespace geolloyd
