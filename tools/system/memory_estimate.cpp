#include "tools/system/memory_estimate.h"

#include <algorithm>

namespace geolloyd {
namespace {

using Bytes = std::uint64_t;

// The program itself, libraries, stacks and small things.
constexpr Bytes base = 32'000'000;
constexpr Bytes per_thread = 300'000;
// What the allocator loses between blocks.
constexpr Bytes with_gaps(Bytes bytes) {
  return bytes + bytes / 10;
}

constexpr Bytes mesh_bytes(Bytes vertices, Bytes triangles) {
  return 24 * vertices + 12 * triangles;  // Mesh
}

// An edge has two ends and a first corner, a triangle is three corners (MeshEdges).
constexpr Bytes edge_bytes(Bytes edges, Bytes triangles) {
  return 12 * edges + 12 * triangles;
}

// Corners by vertex, eight bytes each, and as many counts per vertex as there are parts
// (bucket_sort).
constexpr Bytes finding_edges(Bytes vertices, Bytes triangles) {
  return 24 * triangles + 20 * vertices;
}

// Of E - V + F, and where triangles have no neighbours.
constexpr Bytes likely_edges(Bytes triangles) {
  return triangles * 3 / 2;
}

// Embree: corners and indices as floats and integers, and the tree above them. Measured: 73 to 97
// bytes for rays, 113 to 149 for nearest points.
constexpr Bytes scene_of_rays(Bytes triangles) {
  return 100 * triangles;
}
constexpr Bytes scene_of_points(Bytes triangles) {
  return 150 * triangles;
}

// MeshGraph: two ids, position, first arc and mass of a node; target and length of an arc.
Bytes graph_bytes(const RunSize& s) {
  return 4 * (s.vertices + s.triangles) + 36 * s.nodes + 16 * s.links;
}

// Links; rows of them, which become arcs, with a fifth that the allocator keeps from one to the
// next; and places in spatial order, counts, masses, the
// breadth-first tree. Edges go when links are there.
Bytes building_graph(const RunSize& s) {
  const Bytes spaces = s.has_field ? 64 * (s.vertices + s.triangles) : 0;  // TangentSpace
  // Before that, normals, axes, tensors, and how a tensor passes along each edge, either way.
  const Bytes curvature = s.has_curvature_field ? 140 * s.vertices + 56 * s.edges : 0;
  // For crosses, after that, what a vertex sees of its neighbours, on all levels.
  const Bytes crosses = s.has_cross_field ? 340 * s.vertices + 180 * s.edges : 0;
  const Bytes nodes = 4 * (s.vertices + s.triangles) + 80 * s.nodes;
  const Bytes with_edges = edge_bytes(s.edges, s.triangles) + nodes + 20 * s.links;
  return spaces + std::max({with_edges, nodes + 44 * s.links,
                            edge_bytes(s.edges, s.triangles) + std::max(curvature, crosses)});
}

// Keys, parents, what a node belongs to, sums of the greedy phase; and a copy of the partition in
// the result.
Bytes engine_bytes(const RunSize& s) {
  if (s.is_reference) return 80 * s.nodes;
  // Each thread has a copy of the region it works on: with few seeds, of much of the graph. On a
  // large region all work together, with keys and buckets for it.
  const Bytes at_work = 2 * std::min<Bytes>(s.threads, s.seeds);
  const Bytes copies = 160 * s.nodes + 16 * s.links;
  return 56 * s.nodes + (at_work < s.seeds ? copies / s.seeds * at_work : copies) +
         100 * s.nodes / std::max<Bytes>(s.seeds, 1);
}

// Measured: 180 to 240 bytes for a vertex of the surface, with coarse meshes, labels and dual.
constexpr Bytes moving_sites(Bytes fine_vertices) {
  return 250 * fine_vertices;
}

// Components, samplers, keys; or an engine and the arcs of a coarse graph.
Bytes choosing_seeds(const RunSize& s) {
  return 84 * s.nodes + (s.has_coarse_graph ? engine_bytes(s) + 24 * s.links : 0);
}

Bytes points(const RunSize& s) {
  return s.vertices + (s.has_triangle_nodes ? s.triangles : 0);
}

// RegionSurface: three triangles for one where barycentres are points, else those of the mesh.
Bytes surface_bytes(const RunSize& s) {
  return 12 * s.triangles * (s.has_triangle_nodes ? 3 : 0) + 16 * points(s);
}

// The regions spread over the surface, as they are and, while seeds are added, as they were and
// will be; what joins their points. Where triangles are nodes, the edges again.
Bytes making_dual(const RunSize& s) {
  if (!s.has_dual) return 0;
  const Bytes edges = s.has_triangle_nodes ? edge_bytes(s.edges, s.triangles) : 0;
  return edges + 3 * surface_bytes(s) + 30 * points(s);
}

// For the result, or for the vertices of the remesh.
Bytes finding_ground_truth(const RunSize& s) {
  return edge_bytes(s.edges, s.triangles) + surface_bytes(s) + scene_of_points(s.triangles) +
         40 * s.triangles + 12 * s.nodes;
}

// Points of the input near the remesh; mixtures of 64 bytes for its vertices and triangles, and as
// large a share of the properties as it has of the vertices.
Bytes carrying(Bytes triangles, Bytes vertices, Bytes remesh_vertices, Bytes property_bytes) {
  return scene_of_points(triangles) + 192 * remesh_vertices +
         property_bytes / std::max<Bytes>(vertices, 1) * remesh_vertices;
}

// The mesh again, normals, distances at its places; of a sample what its ray hits, light, region,
// colour, and a stroke where regions meet.
Bytes drawing(Bytes vertices, Bytes triangles, Bytes samples) {
  return mesh_bytes(vertices, triangles) + 24 * (vertices + triangles) + 16 * vertices +
         scene_of_rays(triangles) + 25 * samples;
}

}  // namespace

Bytes memory_to_read(Bytes file_bytes) {
  return file_bytes;
}

Bytes memory_to_check(Bytes vertices, Bytes triangles, Bytes property_bytes) {
  return base + with_gaps(mesh_bytes(vertices, triangles) + property_bytes +
                          finding_edges(vertices, triangles) +
                          edge_bytes(likely_edges(triangles), triangles));
}

std::uint64_t memory_to_repair(std::uint64_t vertices, std::uint64_t triangles) {
  // The input, the mesh under repair and its copy before a stage, with the edges of both, and a
  // dozen numbers for each vertex and each corner.
  return base + with_gaps(3 * mesh_bytes(vertices, triangles) +
                          2 * edge_bytes(likely_edges(triangles), triangles) +
                          finding_edges(vertices, triangles) + 60 * vertices + 40 * triangles);
}

Bytes memory_to_run(const RunSize& s) {
  const Bytes relaxing = graph_bytes(s) + engine_bytes(s);
  Bytes most = std::max({moving_sites(s.fine_vertices), building_graph(s),
                         graph_bytes(s) + choosing_seeds(s), relaxing + making_dual(s)});
  if (s.has_ground_truth) {
    most = std::max(most, relaxing + finding_ground_truth(s));
  }
  if (s.property_bytes > 0) {
    most = std::max(most, relaxing + carrying(s.triangles, s.vertices, s.seeds, s.property_bytes));
  }
  if (s.samples > 0) {
    most = std::max(most, relaxing + drawing(s.vertices, s.triangles, s.samples));
  }
  constexpr Bytes per_seed = 1000;  // totals, summaries, a vertex of the remesh
  return std::max(memory_to_check(s.vertices, s.triangles, s.property_bytes),
                  base + s.threads * per_thread +
                      with_gaps(mesh_bytes(s.vertices, s.triangles) + s.property_bytes + most +
                                per_seed * s.seeds));
}

Bytes memory_to_remesh(const RemeshSize& s) {
  // Measured: some 1600 for a site: the last steps that it took, and what fits it to the surface.
  // A field has spaces and metrics of the mesh's vertices, and metrics of the surface's.
  const Bytes field = s.has_field ? 112 * s.vertices + 48 * s.fine_vertices : 0;
  const Bytes moving = moving_sites(s.fine_vertices) + 1700 * s.remesh_vertices + field;
  const Bytes vertices = s.remesh_vertices;
  const Bytes judging = scene_of_points(2 * vertices) + finding_edges(vertices, 2 * vertices);
  const Bytes picture = s.samples > 0 ? drawing(vertices, 2 * vertices, s.samples) : 0;
  // Measured: the allocator still holds half of what moving took.
  const Bytes carried = s.property_bytes > 0 ? moving / 2 + carrying(s.triangles, s.vertices,
                                                                     vertices, s.property_bytes)
                                             : 0;
  return std::max(memory_to_check(s.vertices, s.triangles, s.property_bytes),
                  base + s.threads * per_thread +
                      with_gaps(mesh_bytes(s.vertices, s.triangles) + s.property_bytes +
                                std::max({moving, judging, picture, carried})));
}

Bytes memory_to_draw(Bytes vertices, Bytes triangles, Bytes samples, Bytes property_bytes) {
  return base + with_gaps(mesh_bytes(vertices, triangles) + property_bytes +
                          edge_bytes(likely_edges(triangles), triangles) +
                          drawing(vertices, triangles, samples));
}

Bytes memory_to_judge(Bytes triangles, Bytes others) {
  const auto loaded = [](Bytes t) { return mesh_bytes(t / 2, t) + edge_bytes(likely_edges(t), t); };
  return base + with_gaps(loaded(triangles) + loaded(others) +
                          scene_of_points(std::max(triangles, others)) +
                          finding_edges(triangles / 2, triangles));
}

Bytes memory_to_subdivide(Bytes triangles, Bytes times) {
  const Bytes before = mesh_bytes(triangles / 2, triangles) +
                       edge_bytes(likely_edges(triangles), triangles) + 12 * triangles;
  return base + before + mesh_bytes(times * triangles / 2, times * triangles);
}

Bytes memory_to_generate(Bytes triangles) {
  return base + mesh_bytes(triangles / 2, triangles);
}

}  // namespace geolloyd
