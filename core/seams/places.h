#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// Finds points in equal places (-0 is 0). A hash table with linear probing, at most half full,
/// whose keys are the positions themselves. A search in it ends after `longest_search` slots, and
/// what has no place within them is in an ordered map: so points that were chosen to collide cost
/// a factor of log n, and not of n. On scans the map is empty.
class PlaceTable {
 public:
  /// `positions` must live on, and has all that are in the table; others may come behind them.
  explicit PlaceTable(const std::vector<Vec3>& positions) : positions_(positions) {}

  /// The id of the place of this point: no_id where it is new. Then the caller sets it to that of
  /// an equal position before the next call.
  VertexId& id_at(const Vec3& point);
  /// Makes room for all positions, of which none is in the table yet.
  void begin_anew();

 private:
  struct ByCoordinates {
    bool operator()(const Vec3& a, const Vec3& b) const;
  };

  VertexId& find(const Vec3& point);
  void grow();

  const std::vector<Vec3>& positions_;
  std::vector<VertexId> slots_;
  std::map<Vec3, VertexId, ByCoordinates> crowded_out_;
};

/// Per vertex the smallest vertex in the very same place. Near-linear.
std::vector<VertexId> places_of(const Mesh& mesh);

}  // namespace geolloyd
