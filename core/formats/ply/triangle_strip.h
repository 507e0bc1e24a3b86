#pragma once

// What the readers of mesh files share; not for users of the library.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "core/formats/mesh_readers.h"

namespace geolloyd {

/// Appends the triangles of a strip: each corner from the third on makes one with the two before
/// it, and every other one is turned around. -1 begins a new strip, and so does the largest of an
/// unsigned type (`restart`), unless it is a vertex. Triangles that name a vertex twice are joints
/// of the strip, and left out. Calls fail(message) where an index is out of range.
template <class Fail>
void add_strip(ParsedMesh& loaded, std::span<const std::int64_t> indices, std::int64_t restart,
               std::size_t vertex_count, Fail&& fail) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::int64_t index = indices[i];
    const bool is_vertex = static_cast<std::uint64_t>(index) < vertex_count;
    if (!is_vertex && index != -1 && index != restart) fail(bad_index(index, vertex_count));
    length = is_vertex ? length + 1 : 0;
    if (length < 3) continue;
    auto a = static_cast<VertexId>(indices[i - 2]);
    auto b = static_cast<VertexId>(indices[i - 1]);
    const auto c = static_cast<VertexId>(index);
    if (a == b || b == c || c == a) continue;
    if (length % 2 == 0) std::swap(a, b);
    loaded.mesh.triangles.push_back({a, b, c});
  }
}

}  // namespace geolloyd
