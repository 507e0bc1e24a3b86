#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "geolloyd/choices.h"
#include "geolloyd/mesh.h"
#include "geolloyd/quality.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

struct Remesh;
struct RemeshOptions;
struct SurfacePoint;

/// Remeshes the surface of `mesh` as regularly as can be: sites move on the surface itself until
/// their cells are centroidal, and the dual of the cells is the remesh (core/surface; after
/// Rapetta's thesis). It has `vertex_count` vertices, or more where its topology needs them; those
/// on boundary and features come first. Lengths are in mesh units. `mesh` may have any flaws; where
/// its edges have three and more triangles it is cut apart. Throws InvalidInput where the mesh is
/// not valid or has no area, or where an option is not usable.
Remesh remesh(const Mesh& mesh, const RemeshOptions& options, Runtime& runtime = all_threads());

/// Properties of a mesh's vertices as they are at points of it, such as the places of a remesh's
/// vertices: one value per place, in their order. Numbers are interpolated linearly; parts of
/// colours are then rounded, and normals get length 1. Labels go by the largest sum of barycentric
/// coordinates, the smaller one of equals. Throws InvalidInput where properties or places do not
/// fit the mesh.
std::vector<Property> values_at(const Mesh& mesh, const std::vector<Property>& of_vertices,
                                const std::vector<SurfacePoint>& places,
                                Runtime& runtime = all_threads());

/// A point of a mesh: on a triangle, by its barycentric coordinates (not negative; their sum is 1
/// but for rounding).
struct SurfacePoint {
  TriangleId triangle = no_id;
  std::array<double, 3> barycentric = {1, 0, 0};
};

/// How far a remesh has come. Sites come in levels, each with about four times as many as the
/// one before.
struct RemeshProgress {
  std::size_t sites = 0;         ///< of this level
  std::size_t wanted_sites = 0;  ///< of the last level
  std::size_t iteration = 0;     ///< within the level
  double energy_ratio = 0;       ///< over that of the hexagonal tiling of the plane with as many
  /// Where a site of this level is, mesh units. Not to be called later.
  std::function<Vec3(std::size_t site)> place;
  bool finds_sizes = false;  ///< these are sites of the quick remesh for
                             ///< SizingOptions::equal_error, of which nothing is kept
};

/// Edges of a mesh at which its surface turns.
enum class Creases {
  automatic,  ///< from 40 degrees on, where the surface beside them is flat; none on scans
  by_angle,   ///< from an angle on
  none
};

/// What a remesh keeps as it is: curves of edges of the mesh become curves of edges of the remesh.
/// The boundary always does.
struct FeatureOptions {
  Creases creases = Creases::automatic;
  double crease_angle = 40;  ///< by_angle: degrees, above 0 and up to 180
  bool small = true;  ///< shorter edges where loops and walls are smaller than edges otherwise are;
                      ///< they take up to a third of the vertices
  std::vector<std::array<VertexId, 2>> edges;  ///< further ones, in any order
  std::vector<std::uint32_t> groups;           ///< per triangle, or empty: borders between them
  std::vector<VertexId> fixed_vertices;        ///< become vertices of the remesh, in that place
};

/// Edges that are longer in some places than in others: one of four says where.
struct SizingOptions {
  std::vector<double> edge_lengths;  ///< per vertex of the mesh: wanted there; above 0. Mesh units;
                                     ///< in proportion, where the number of vertices or the mean
                                     ///< length is given, too
  std::vector<double> densities;  ///< per vertex: lengths in proportion to density^(-1/4); above 0
  double adapt = 0;               ///< lengths in proportion to curvature^(-adapt/2); up to 2
  double growth = 1.12;           ///< maximum ratio of the lengths of adjacent edges; above 1
  bool equal_error = false;       ///< lengths by which the remesh is about as far from the input
                                  ///< everywhere: found by a quick remesh
};

/// `vertex_count` or `edge_length` is given, or SizingOptions::edge_lengths alone; what is not
/// given is 0.
struct RemeshOptions {
  std::size_t vertex_count = 0;  ///< at least 4
  double edge_length = 0;        ///< mean of the remesh's, mesh units; above 0
  SizingOptions sizing;
  /// One per vertex, or none. Triangles are to be regular in its metric; `edge_length` is measured
  /// in it, too. Where `sizing` asks for lengths, only the ratio of magnitudes counts, and lengths
  /// are those in the mean of directions.
  std::vector<TangentSpace> field;
  FeatureOptions features;
  bool fit =
      true;  ///< move vertices off the surface in the end, where that brings the remesh closer
  /// Called by the calling thread now and then. False ends the moving of sites and the fit, and
  /// glides are given up: the remesh is then made from the sites there are.
  std::function<bool(const RemeshProgress&)> progress;
};

/// One iteration of a surface remesh.
struct SurfaceStep {
  std::size_t sites = 0;
  std::size_t mesh_vertices = 0;  ///< of the mesh that the sites moved on: a coarse one, or the
                                  ///< whole surface
  double energy = 0;              ///< after it, mesh units
  double seconds = 0;             ///< from the start of the first one to its end
};

/// What may be bad about a remesh.
enum class RemeshFlaw {
  vertices,           ///< many more than asked for
  topology,           ///< no manifold, or not of the input's topology
  volume,             ///< another one inside than inside the input, where both are closed
  distance,           ///< part of the input is far from the remesh: found by who measures
  fit,                ///< could bring the remesh hardly closer
  features,           ///< the input has long sharp edges, and none are kept
  split_vertices,     ///< of the input: where they are, its surface is not joined
  small_parts,        ///< of the input: smaller than a triangle of the remesh
  limit,              ///< the input was not cut as finely as it should be
  self_intersections  ///< triangles cross (quality.h), and none of the input do
};

/// "vertices" and so on, for scripts.
std::string_view name_of(RemeshFlaw flaw);

struct RemeshWarning {
  RemeshFlaw flaw;
  std::string text;  ///< for people: one line, with the figures
};

/// A remesh whose vertices stand for points of the surface of the mesh, anywhere, and are there
/// unless they were fitted.
struct Remesh {
  Mesh mesh;
  std::vector<SurfacePoint> places;  ///< per vertex: the point of the input it stands for
  std::size_t curve_vertices = 0;    ///< the first vertices: on boundary and features
  std::vector<std::array<VertexId, 2>> feature_edges;  ///< edges along features; ascending
  bool creases_left_out = false;  ///< with them there would be several times as many vertices as
                                  ///< asked for
  std::size_t subresolution_holes =
      0;  ///< loops too short for vertices of their own: a triangle is missing
  std::size_t vertices_asked_for = 0;  ///< or what the edge length makes of it
  bool interrupted = false;            ///< the progress callback ended the moving of sites
  std::vector<SurfaceStep> steps;
  std::vector<double> edge_lengths;  ///< per vertex: what SizingOptions ask for there, mesh units;
                                     ///< empty where they ask for nothing
  double energy = 0;  ///< integral over the surface of |x - vertex of its cell|^2, mesh units;
                      ///< times edge_length^-4, relative to an even spread, where edge lengths vary
  double energy_of_hexagonal_tiling = 0;  ///< of the plane, with as much area and as many cells
  MeshTopology topology;
  std::vector<PartTopology> surface_parts;  ///< of the input, cut apart where it is no manifold;
                                            ///< ascending
  std::size_t edges_flipped = 0;            ///< of the dual, for larger angles
  std::size_t glides = 0;                   ///< paths of flips by which pairs of irregular vertices
                                            ///< met and were gone, and vertices moved
  std::size_t vertices_fitted = 0;          ///< moved off the surface, or off curves
  double distance_before_fit = 0;  ///< from points of the input to the remesh, whose curves were
                                   ///< fitted already: root of the mean square, mesh units; 0
                                   ///< without a fit
  double distance_after_fit = 0;
  std::size_t vertices_cut = 0;         ///< of the input: where it is no manifold
  double small_feature_share = 0;       ///< of the vertices: those that shorter edges at small
                                        ///< features took
  bool small_features_limited = false;  ///< these would have taken more than they may, and some
                                        ///< edges are half as long again as they need
  std::vector<std::array<TriangleId, 2>>
      self_intersections;       ///< pairs of triangles, as self_intersections() finds them
  std::size_t small_parts = 0;  ///< of the input: smaller than a triangle of the remesh; none are
                                ///< counted where edge lengths vary
  bool was_cut_short = false;   ///< edges of the input were not halved any more at the limit
  std::vector<RemeshWarning>
      warnings;                     ///< what is bad, if anything (core/course/remesh_warnings.h)
  std::size_t violations_left = 0;  ///< of the closed ball property; 0: the topology is proven
  std::uint64_t fingerprint = 0;    ///< of the whole course; the same on every machine

  /// Of feature_edges together, mesh units.
  [[nodiscard]] double feature_length() const;
  /// False also without triangles.
  [[nodiscard]] bool is_manifold() const;
  /// Each part has the Euler characteristic and the boundary loops of one of surface_parts.
  [[nodiscard]] bool has_input_topology() const;
};

}  // namespace geolloyd
