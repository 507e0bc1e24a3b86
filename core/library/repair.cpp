#include "core/repair/repair.h"

#include <cmath>

#include "geolloyd/errors.h"

namespace geolloyd {

RepairedMesh repair(const Mesh& mesh, const RepairOptions& options, Runtime& runtime) {
  validate(mesh);
  if (!std::isfinite(options.hole_share) || options.hole_share < 0) {
    throw InvalidInput("repair: hole_share must be a number that is not negative");
  }
  return make_repaired_mesh(mesh, options, runtime.executor());
}

}  // namespace geolloyd
