#pragma once

#include <cstddef>
#include <vector>

#include "geolloyd/mesh.h"
#include "geolloyd/relax.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// What a tessellation is judged by (thesis, section 6.1): the partition of the nodes by Euclidean
/// distance to the seeds, found exactly (Embree), instead of distance along the graph.
struct Evaluation {
  std::vector<RegionId> region;  ///< per input id: of the nearest seed, the smaller of equals
  std::vector<Vec3> centroid;    ///< per region: the point of the surface nearest to its centroid
  double node_agreement = 1;     ///< share of nodes that the graph puts into the same region
  double area_agreement = 1;     ///< the same by area
  double mean_distance_in_radii = 0;      ///< from seed to centroid, over the radius of a disc of
                                          ///< the region's area
  double energy = 0;                      ///< sum of mass * |node - seed|^2, mesh units
  double graph_energy = 0;                ///< the same sum, with the graph's regions
  double energy_of_hexagonal_tiling = 0;  ///< of the plane, with as much area and as many regions
};

/// `tessellation` is one of this `mesh`. Throws InvalidInput where it is not.
Evaluation evaluate(const Mesh& mesh, const Tessellation& tessellation,
                    Runtime& runtime = all_threads());

/// How far points of a surface are from another, mesh units.
struct DistanceFigures {
  double mean = 0;
  double rms = 0;      ///< root of the mean square
  double largest = 0;  ///< one-sided Hausdorff distance, as far as samples and vertices find it
};

/// How far two surfaces are apart (Cignoni et al. 1998, Metro). Mean and RMS are those of samples
/// spread evenly by area, the largest is that of the samples and all vertices of triangles.
struct SurfaceDistance {
  DistanceFigures from_first;  ///< of points of the first surface to the second
  DistanceFigures from_second;

  /// The larger of both directions, figure by figure.
  [[nodiscard]] DistanceFigures two_sided() const;
};

/// With so many samples on each surface, at least 1. Throws InvalidInput where a mesh is not valid
/// or has no area.
SurfaceDistance measure_distance(const Mesh& first, const Mesh& second, std::size_t samples,
                                 Runtime& runtime = all_threads());

/// An interval that holds a largest distance for certain, mesh units.
struct DistanceBounds {
  double lower = 0;
  double upper = 0;
};

/// How far two surfaces are apart at most, each point of them counted (Hausdorff distance).
struct SurfaceDistanceBounds {
  DistanceBounds from_first;  ///< of points of the first surface to the second
  DistanceBounds from_second;

  /// Of the larger of both directions.
  [[nodiscard]] DistanceBounds two_sided() const;
};

/// Bounds that are at most 1 % of `tolerance` apart (mesh units), or, where that is 0 or less than
/// the distance, 1 % of the lower one. Both are 0 where the triangles are the same; no distance
/// is measured better than to 1e-11 of the diagonal. Bounds are valid, but may be farther apart,
/// where that would need more than some ten million pieces of triangles. Throws InvalidInput where
/// a mesh is not valid.
SurfaceDistanceBounds certify_distance(const Mesh& first, const Mesh& second, double tolerance = 0,
                                       Runtime& runtime = all_threads());

/// The points of a surface that are closest to some points; of equally close ones that of the
/// smallest triangle. Throws InvalidInput where the mesh is not valid or a point not finite.
std::vector<SurfacePoint> closest_points(const Mesh& mesh, const std::vector<Vec3>& points,
                                         Runtime& runtime = all_threads());

/// A remesh that was tried, and bounds of how far it is from the mesh, of both ways
/// (certify_distance()).
struct ToleranceTrial {
  std::size_t vertices = 0;
  double distance = 0;  ///< the upper one, by which it is judged
  double lower = 0;
};

/// A remesh with about the fewest vertices that is near enough, and what was tried.
struct ToleranceRemesh {
  Remesh remesh;
  DistanceBounds bounds;  ///< of how far it is from the mesh, of both ways
  std::vector<ToleranceTrial> trials;
};

/// As remesh(), with as few vertices as keep the largest distance for certain within `tolerance`,
/// mesh units: of all that were tried and are, the one with the fewest. `options` name no vertex
/// count and no edge length; where they ask for no sizes and have no field, sizes are those of
/// equal error. Where the progress callback ends the work, the best one so far, or the last one.
/// Throws InvalidInput also where many vertices are not enough.
ToleranceRemesh remesh_within(const Mesh& mesh, double tolerance, RemeshOptions options,
                              Runtime& runtime = all_threads());

}  // namespace geolloyd
