#pragma once

#include <span>
#include <string>

#include "core/graph/mesh_graph.h"
#include "core/mesh/mesh.h"
#include "core/regions/tessellation.h"
#include "core/voronoi/partition.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/render/surface_colours.h"
#include "tools/view/bundle.h"

namespace geolloyd {

// What the viewer shows, as arrays of a bundle. All ids are input ids or regions. The placement of
// the bundle must be that of the mesh: it comes first.

/// positions, triangles; colours where the mesh has its own. Vertices of no triangle keep their
/// ids.
void add_mesh(Bundle& bundle, const Mesh& mesh, const SurfaceColours& colours = {});

/// region, seeds, seed_id and palette; adjacent regions differ in colour.
void add_regions(Bundle& bundle, const MeshGraph& mesh_graph, const Partition& partition,
                 std::span<const NodeId> seeds);
/// The same with these colours.
void add_regions(Bundle& bundle, const MeshGraph& mesh_graph, const Partition& partition,
                 std::span<const NodeId> seeds, std::span<const Colour> colours);

/// region_nodes, region_area and region_energy.
void add_region_figures(Bundle& bundle, std::span<const RegionSummary> regions);

/// parent: per input id the next one on the way to the seed, or none. The viewer draws the lines.
void add_trees(Bundle& bundle, const MeshGraph& mesh_graph, const Partition& partition);

/// field: per vertex the tangent and the bitangent, as long as their magnitudes are beside the
/// largest of all.
void add_field(Bundle& bundle, std::span<const TangentSpace> vertex_space);

/// truth_region and truth_centroids.
void add_truth(Bundle& bundle, const MeshGraph& mesh_graph, const GroundTruth& truth);

/// remesh_positions and remesh_triangles.
void add_remesh(Bundle& bundle, const Mesh& remesh);

/// A frame of the timeline: its regions and seeds.
void add_frame(Bundle& bundle, const std::string& label, double energy, const MeshGraph& mesh_graph,
               const Partition& partition, std::span<const NodeId> seeds);

}  // namespace geolloyd
