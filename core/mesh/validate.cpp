#include <cstddef>
#include <string>

#include "core/base/vec3.h"
#include "core/mesh/mesh.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

[[noreturn]] void refuse(const char* kind, std::size_t id, const std::string& what) {
  throw InvalidInput("mesh: " + std::string(kind) + " " + std::to_string(id) + ": " + what);
}

}  // namespace

void validate_contents(const Mesh& mesh) {
  if (!ids_suffice(mesh.vertex_count(), mesh.triangle_count())) {
    throw InvalidInput("mesh: more vertices or triangles than 32-bit ids can count");
  }
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (const double coordinate : mesh.positions[v]) {
      if (is_usable(coordinate)) continue;
      refuse("vertex", v,
             "coordinate " + std::to_string(coordinate) + " is not a finite number of usable size");
    }
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId v : mesh.triangles[t]) {
      if (v < mesh.vertex_count()) continue;
      refuse("triangle", t,
             "names vertex " + std::to_string(v) + ", but the mesh has " +
                 std::to_string(mesh.vertex_count()));
    }
  }
}

void validate(const Mesh& mesh) {
  if (mesh.triangles.empty()) throw InvalidInput("mesh: no triangles");
  validate_contents(mesh);
}

}  // namespace geolloyd
