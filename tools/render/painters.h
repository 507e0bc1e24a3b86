#pragma once

#include <span>
#include <vector>

#include "core/fields/tangent_field.h"
#include "core/graph/mesh_graph.h"
#include "core/voronoi/partition.h"
#include "tools/render/canvas.h"
#include "tools/render/surface_colours.h"

namespace geolloyd {

// What can be seen on a mesh. Lengths and widths are in pixels of the picture, so that the same
// scene looks alike at all sizes.

/// A partition and the colours of its regions; what is referred to must live on.
struct PartitionView {
  const MeshGraph& mesh_graph;
  const Partition& partition;
  std::span<const NodeId> seeds;
  std::span<const Colour> region_colour;
};

/// The surface in its own colours, if it has any.
Canvas paint_surface(const Scene& scene, Executor& executor, const SurfaceColours& colours = {});

/// The surface and the edges of the scene's mesh, but for those opposite to corners that are
/// hidden: of each corner 0 or 1, or none at all.
Canvas paint_mesh(const Scene& scene, Executor& executor, const SurfaceColours& colours = {},
                  std::span<const std::uint8_t> is_hidden = {});

/// Regions, borders between them, seeds as dots.
Canvas paint_regions(const PartitionView& view, const Scene& scene, Executor& executor);

/// The shortest-path forest, each node joined to its parent, on pale regions. Lines are wider the
/// more surface is reached by them; where nodes are smaller than some pixels, the finest are left
/// out.
Canvas paint_trees(const PartitionView& view, const Scene& scene, Executor& executor);

/// The regions of points that are nearest to a seed through space, seeds as light dots, the
/// centroids of these regions (mesh units, on the surface) as dark ones: where a seed is at its
/// centroid, that hides it.
Canvas paint_ground_truth(const PartitionView& view, std::span<const RegionId> region_of_node,
                          std::span<const Vec3> centroid, const Scene& scene, Executor& executor);

/// Both directions of a tangent field at vertices evenly spread over the picture, as long as their
/// magnitudes: the one of larger magnitude blue, the other orange.
Canvas paint_field(std::span<const TangentSpace> vertex_space, const Scene& scene,
                   Executor& executor);

}  // namespace geolloyd
