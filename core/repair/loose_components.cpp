#include "core/repair/loose_components.h"

#include <algorithm>
#include <numeric>

#include "core/base/bucketing.h"
#include "core/seams/places.h"
#include "core/seams/stitching.h"

namespace geolloyd {
namespace {

// Triangles by component, the components in order of their smallest vertex.
Bucketed<TriangleId> triangles_by_component(const Mesh& mesh) {
  const std::vector<VertexId> component = components_of(mesh);
  std::vector<std::uint32_t> number(mesh.vertex_count(), 0);
  std::uint32_t count = 0;
  for (VertexId v = 0; v < number.size(); ++v) {
    if (component[v] == v) number[v] = count++;
  }
  return bucket_sort<TriangleId>(
      sequential(), count, mesh.triangle_count(), [&](std::size_t t, auto&& put) {
        put(number[component[mesh.triangles[t][0]]], static_cast<TriangleId>(t));
      });
}

void remove_sliver_components(MeshUnderRepair& state, Repairs& repairs) {
  const Mesh& mesh = state.mesh;
  const Bucketed<TriangleId> parts = triangles_by_component(mesh);
  std::vector<std::uint8_t> is_removed(mesh.triangle_count(), 0);
  std::size_t removed = 0;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto triangles = parts[part];
    if (!std::all_of(triangles.begin(), triangles.end(),
                     [&](TriangleId t) { return is_sliver(mesh, mesh.triangles[t]); })) {
      continue;
    }
    for (const TriangleId t : triangles) is_removed[t] = 1;
    removed += triangles.size();
  }
  if (removed == 0 || removed == mesh.triangle_count()) return;
  remove_triangles(state, is_removed);
  repairs.slivers_removed += removed;
}

// Triangles whose corners are in the same three places have the same number: that of the first.
class Twins {
 public:
  Twins(const Mesh& mesh, const std::vector<VertexId>& place)
      : group_(mesh.triangle_count()), size_(group_.size(), 0) {
    std::vector<Triangle> places(mesh.triangle_count());
    for (std::size_t t = 0; t < places.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) places[t][c] = place[mesh.triangles[t][c]];
      std::sort(places[t].begin(), places[t].end());
    }
    std::vector<TriangleId> order(mesh.triangle_count());
    std::iota(order.begin(), order.end(), TriangleId{0});
    std::sort(order.begin(), order.end(), [&](TriangleId a, TriangleId b) {
      return places[a] != places[b] ? places[a] < places[b] : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool is_twin = i > 0 && places[order[i]] == places[order[i - 1]];
      group_[order[i]] = is_twin ? group_[order[i - 1]] : order[i];
      has_any_ = has_any_ || is_twin;
      ++size_[group_[order[i]]];
    }
  }

  [[nodiscard]] bool has_any() const { return has_any_; }
  /// How many there are in the places of a triangle, itself included.
  std::uint32_t& count(TriangleId t) { return size_[group_[t]]; }

 private:
  std::vector<TriangleId> group_;
  std::vector<std::uint32_t> size_;  // per first triangle of a group
  bool has_any_ = false;
};

void remove_twin_components(MeshUnderRepair& state, Repairs& repairs) {
  const Mesh& mesh = state.mesh;
  const std::vector<VertexId> place = places_of(mesh);
  VertexId next = 0;
  if (std::all_of(place.begin(), place.end(), [&](VertexId p) { return p == next++; })) return;
  Twins twins(mesh, place);
  if (!twins.has_any()) return;
  const Bucketed<TriangleId> parts = triangles_by_component(mesh);
  std::vector<std::uint32_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return parts[a].size() != parts[b].size() ? parts[a].size() < parts[b].size() : a > b;
  });
  std::vector<std::uint8_t> is_removed(mesh.triangle_count(), 0);
  for (const std::uint32_t part : order) {
    const auto triangles = parts[part];
    // Without those of this component, one must stay at each place.
    for (const TriangleId t : triangles) --twins.count(t);
    const bool is_twin = std::all_of(triangles.begin(), triangles.end(),
                                     [&](TriangleId t) { return twins.count(t) > 0; });
    for (const TriangleId t : triangles) {
      if (is_twin) {
        is_removed[t] = 1;
      } else {
        ++twins.count(t);
      }
    }
    if (is_twin) repairs.duplicate_triangles += triangles.size();
  }
  remove_triangles(state, is_removed);
}

}  // namespace

void remove_loose_components(MeshUnderRepair& state, Repairs& repairs) {
  remove_sliver_components(state, repairs);
  remove_twin_components(state, repairs);
}

}  // namespace geolloyd
