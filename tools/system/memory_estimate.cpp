#include "tools/system/memory_estimate.h"

#include <algorithm>

namespace geolloyd {
namespace {

using Bytes = std::uint64_t;

// The program and its libraries: about 18 MB. The rest is what the allocator keeps of what was
// freed.
constexpr Bytes process = 45'000'000;
constexpr Bytes per_sample = 24;  // of a picture

// Sorting into buckets has counts for up to eight threads at once.
Bytes of_threads(const WorkSize& s, Bytes per_vertex) {
  return 500'000 * s.threads + per_vertex * s.vertices * std::min<Bytes>(s.threads, 8);
}

}  // namespace

Bytes bytes_to_read(const WorkSize& s) {
  return process + 45 * s.vertices + 66 * s.triangles + s.property_bytes;
}

// A region of one seed is the whole graph, of which all threads have copies.
Bytes bytes_to_relax(const WorkSize& s) {
  const Bytes field_vertices = s.has_field ? s.vertices : 0;
  const bool has_tree = s.has_ground_truth || s.property_bytes > 0;
  const Bytes fields = s.has_cross_field ? 710 * s.vertices : 0;
  const Bytes graph = 30 * s.nodes + 27 * s.arcs + 95 * field_vertices;
  const Bytes regions = 200 * s.nodes + 650 * s.nodes / std::max<Bytes>(s.sites, 1) +
                        1230 * s.sites + 235 * field_vertices + (has_tree ? 116 * s.triangles : 0);
  const Bytes picture =
      s.samples > 0 ? 40 * s.nodes + 17 * s.arcs + 10 * s.triangles + (per_sample + 4) * s.samples
                    : 0;
  return process + of_threads(s, 16) + 106 * s.vertices + s.property_bytes +
         std::max({fields, graph, regions, picture});
}

Bytes bytes_to_remesh(const WorkSize& s) {
  return process + of_threads(s, 7) + 230 * s.vertices + 90 * s.fine_vertices + 2250 * s.sites +
         (s.has_field ? 265 * s.vertices : 0) + per_sample * s.samples +
         (s.property_bytes > 0 ? 66 * s.triangles : 0) + s.property_bytes;
}

Bytes bytes_to_repair(const WorkSize& s) {
  return process + 160 * s.triangles + 2 * s.property_bytes;
}

Bytes bytes_to_draw(const WorkSize& s) {
  const Bytes per_vertex = s.has_cross_field ? 620 : s.has_field ? 265 : 0;
  return bytes_to_read(s) + per_vertex * s.vertices + per_sample * s.samples;
}

Bytes bytes_to_judge(const WorkSize& remesh, const WorkSize& original) {
  if (original.triangles == 0) return bytes_to_read(remesh);
  return process + 80 * (remesh.triangles + original.triangles) +
         140 * std::max(remesh.triangles, original.triangles) +
         (original.has_field ? 2600 * remesh.vertices + 100 * original.vertices : 0);
}

Bytes bytes_to_make(Bytes triangles, Bytes before) {
  return process + 24 * triangles + 66 * before;
}

}  // namespace geolloyd
