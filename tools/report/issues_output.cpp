#include "tools/report/issues_output.h"

#include "core/base/bounding_box.h"
#include "core/mesh/mesh_quality.h"
#include "tools/files/csv.h"

namespace geolloyd {
namespace {

Vec3 place_of(const Mesh& mesh, const TrianglePair& pair) {
  const GrowingBox one = box_around(corners_of(mesh, mesh.triangles[pair[0]]));
  const GrowingBox other = box_around(corners_of(mesh, mesh.triangles[pair[1]]));
  return one.low.cwiseMax(other.low) / 2 + one.high.cwiseMin(other.high) / 2;
}

}  // namespace

void write_issues(const Mesh& mesh, std::span<const TrianglePair> self_intersections,
                  FileWriter& out) {
  out.text("kind,triangle,other_triangle,x,y,z\n");
  for (const TrianglePair& pair : self_intersections) {
    const Vec3 place = place_of(mesh, pair);
    write_row(out, "self_intersection", pair[0], pair[1], place.x(), place.y(), place.z());
  }
}

}  // namespace geolloyd
