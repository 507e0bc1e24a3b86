#pragma once

// What the readers of mesh files share; not for users of the library.

#include "core/formats/mesh_readers.h"
#include "core/seams/places.h"

namespace geolloyd {

/// Gives equal points one id, in the order of their first appearance.
class Welder {
 public:
  explicit Welder(ParsedMesh& loaded) : loaded_(loaded), table_(loaded.mesh.positions) {}

  VertexId id_of(Vec3 point) {
    point.array() += 0.0;  // -0 becomes 0
    std::vector<Vec3>& positions = loaded_.mesh.positions;
    VertexId& id = table_.id_at(point);
    if (id == no_id) {
      id = static_cast<VertexId>(positions.size());
      positions.push_back(point);
    } else {
      ++loaded_.welded_corners;
    }
    return id;
  }

 private:
  ParsedMesh& loaded_;
  PlaceTable table_;
};

}  // namespace geolloyd
