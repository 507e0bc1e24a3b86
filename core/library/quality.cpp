#include "geolloyd/quality.h"

#include "core/repair/crossings.h"

namespace geolloyd {

std::vector<std::array<TriangleId, 2>> self_intersections(const Mesh& mesh, Runtime& runtime) {
  validate_contents(mesh);
  return find_crossings(mesh, runtime.executor());
}

}  // namespace geolloyd
