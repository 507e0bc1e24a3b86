#pragma once

// What the readers of mesh files share; not for users of the library.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/formats/mesh_readers.h"

namespace geolloyd {

/// Gives equal points one id, in the order of their first appearance. A hash table with linear
/// probing, at most half full, whose keys are the positions themselves. A search in it ends after
/// `longest_search` slots, and what has no place within them is in an ordered map: so a file whose
/// points were chosen to collide costs a factor of log n, and not of n. On scans the map is empty.
class Welder {
 public:
  explicit Welder(ParsedMesh& loaded) : loaded_(loaded) {}

  VertexId id_of(Vec3 point) {
    point.array() += 0.0;  // -0 becomes 0
    std::vector<Vec3>& positions = loaded_.mesh.positions;
    if (2 * positions.size() >= slots_.size()) grow();
    VertexId& id = place_of(point);
    if (id == no_id) {
      id = static_cast<VertexId>(positions.size());
      positions.push_back(point);
    } else {
      ++loaded_.welded_corners;
    }
    return id;
  }

 private:
  static constexpr std::size_t longest_search = 64;

  struct ByCoordinates {
    bool operator()(const Vec3& a, const Vec3& b) const {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    }
  };

  static std::size_t hash(const Vec3& point) {
    std::uint64_t bits = 0;
    for (const double coordinate : point) {
      bits = (bits ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15;
      bits ^= bits >> 32;
    }
    return bits;
  }

  // Where the id of the point is, or is to be (no_id).
  VertexId& place_of(const Vec3& point) {
    const std::size_t mask = slots_.size() - 1;
    const std::size_t first = hash(point);
    for (std::size_t i = 0; i < longest_search; ++i) {
      VertexId& slot = slots_[(first + i) & mask];
      if (slot == no_id || loaded_.mesh.positions[slot] == point) return slot;
    }
    return crowded_out_.try_emplace(point, no_id).first->second;
  }

  void grow() {
    slots_.assign(std::max<std::size_t>(2 * slots_.size(), 1024), no_id);
    crowded_out_.clear();
    for (std::size_t v = 0; v < loaded_.mesh.vertex_count(); ++v) {
      place_of(loaded_.mesh.positions[v]) = static_cast<VertexId>(v);
    }
  }

  ParsedMesh& loaded_;
  std::vector<VertexId> slots_;
  std::map<Vec3, VertexId, ByCoordinates> crowded_out_;
};

}  // namespace geolloyd
