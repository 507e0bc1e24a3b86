#include "geolloyd/fields.h"

#include "core/fields/cross_field.h"
#include "core/fields/curvature_field.h"

namespace geolloyd {

std::vector<TangentSpace> curvature_field(const Mesh& mesh, Runtime& runtime) {
  validate(mesh);
  return curvature_field(mesh, find_edges(mesh, runtime.executor()), runtime.executor());
}

std::vector<TangentSpace> cross_field(const Mesh& mesh, Runtime& runtime) {
  validate(mesh);
  return cross_field(mesh, find_edges(mesh, runtime.executor()), runtime.executor());
}

}  // namespace geolloyd
