#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace geolloyd {

/// A place that may carry a region: vertex v is v, triangle t's barycentre is vertex_count + t, as
/// the mixed graph's input ids are.
using PointId = std::uint32_t;

/// A mesh edge that does not have two triangles.
struct IrregularEdge {
  std::array<VertexId, 2> ends;
  std::uint32_t triangles;
};

/// Triangles of its own, or those of a mesh, which must live on.
class SurfaceTriangles {
 public:
  SurfaceTriangles() = default;
  explicit SurfaceTriangles(std::vector<Triangle> own) : own_(std::move(own)) {}
  static SurfaceTriangles of(const std::vector<Triangle>& mesh_triangles) {
    SurfaceTriangles triangles;
    triangles.given_ = &mesh_triangles;
    return triangles;
  }

  [[nodiscard]] std::size_t size() const { return all().size(); }
  [[nodiscard]] const Triangle& operator[](std::size_t i) const { return all()[i]; }
  [[nodiscard]] auto begin() const { return all().begin(); }
  [[nodiscard]] auto end() const { return all().end(); }

 private:
  [[nodiscard]] const std::vector<Triangle>& all() const {
    return given_ != nullptr ? *given_ : own_;
  }

  const std::vector<Triangle>* given_ = nullptr;
  std::vector<Triangle> own_;
};

/// A partition spread over the whole surface: a triangulation of the mesh's surface whose points
/// each have a region, and where each region is connected along the triangulation's edges.
///
/// In graphs of vertices it is the mesh. In the others barycentres are points too, and each edge's
/// two triangles make a quadrilateral with the edge, or the way across it, as diagonal: whichever
/// joins points of one region (both may: the one nearer to its seed). Vertices that are no nodes
/// belong to the region that is nearest by way of a triangle around them, ties to the smaller.
/// Arcs of the dense and mixed graphs may cross others'; what they alone joined to its seed is
/// given to the nearest neighbouring region. Parts of the mesh that no seed reaches are left out.
/// Lengths within a triangle are isotropic, whatever the metric of the graph.
struct RegionSurface {
  std::size_t vertex_count = 0;
  std::size_t region_count = 0;
  PointId first_node = 0;             ///< points from here on may be nodes, and so seeds
  SurfaceTriangles triangles;         ///< of points; oriented like the mesh's
  std::vector<RegionId> region;       ///< per point; no_id where it is on no triangle
  std::vector<double> distance;       ///< per point, to its seed, mesh units
  std::vector<PointId> nearest_node;  ///< per point below first_node: the point it got these from
  std::vector<IrregularEdge> irregular_edges;  ///< ascending
  std::vector<PointId> reassigned_points;  ///< points that went to another region than their node's

  [[nodiscard]] Vec3 position(const Mesh& mesh, PointId point) const;
};

}  // namespace geolloyd
