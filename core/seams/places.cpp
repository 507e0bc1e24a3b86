#include "core/seams/places.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace geolloyd {
namespace {

constexpr std::size_t longest_search = 64;
constexpr std::size_t fewest_slots = 1024;

// -0 becomes 0.
std::size_t hash_of_place(const Vec3& point) {
  std::uint64_t bits = 0;
  for (const double coordinate : point) {
    bits = (bits ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9e3779b97f4a7c15;
    bits ^= bits >> 32;
  }
  return bits;
}

}  // namespace

bool PlaceTable::ByCoordinates::operator()(const Vec3& a, const Vec3& b) const {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

VertexId& PlaceTable::id_at(const Vec3& point) {
  if (2 * positions_.size() >= slots_.size()) grow();
  return find(point);
}

VertexId& PlaceTable::find(const Vec3& point) {
  const std::size_t mask = slots_.size() - 1;
  const std::size_t first = hash_of_place(point);
  for (std::size_t i = 0; i < longest_search; ++i) {
    VertexId& slot = slots_[(first + i) & mask];
    if (slot == no_id || positions_[slot] == point) return slot;
  }
  return crowded_out_.try_emplace(point, no_id).first->second;
}

void PlaceTable::begin_anew() {
  slots_.assign(std::max(2 * std::bit_ceil(positions_.size() + 1), fewest_slots), no_id);
  crowded_out_.clear();
}

void PlaceTable::grow() {
  begin_anew();
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    VertexId& id = find(positions_[v]);
    if (id == no_id) id = static_cast<VertexId>(v);
  }
}

std::vector<VertexId> places_of(const Mesh& mesh) {
  PlaceTable table(mesh.positions);
  table.begin_anew();
  std::vector<VertexId> place(mesh.vertex_count());
  for (VertexId v = 0; v < place.size(); ++v) {
    VertexId& id = table.id_at(mesh.positions[v]);
    if (id == no_id) id = v;
    place[v] = id;
  }
  return place;
}

}  // namespace geolloyd
