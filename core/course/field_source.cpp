#include "core/course/field_source.h"

#include "core/fields/cross_field.h"
#include "core/fields/curvature_field.h"
#include "core/fields/tangent_field_file.h"

namespace geolloyd {

std::vector<TangentSpace> find_field(const FieldSource& source, const Mesh& mesh,
                                     const MeshEdges& edges, Executor& executor) {
  if (source.vfield.empty()) return {};
  if (source.has_curvature_field()) return curvature_field(mesh, edges, executor);
  if (source.has_cross_field()) return cross_field(mesh, edges, executor);
  return read_tangent_field(source.vfield, mesh.vertex_count());
}

}  // namespace geolloyd
