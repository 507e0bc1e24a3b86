#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// How long the edges of a remesh are to be.
struct Sizing {
  double spacing = 0;         ///< of as many sites, evenly spread; mesh units
  std::vector<double> sizes;  ///< per vertex of the mesh: length of edges there, in spacings;
                              ///< empty: 1 everywhere
};

/// The distance between `sites` sites evenly spread over an area.
double spacing_of(double area, double sites);
/// How many sites so far apart cover it.
double sites_at(double area, double spacing);
/// About as many vertices a remesh has whose sites are so far apart, but for what boundary and
/// features change: at least 4. Throws InvalidInput where they are more than 1e9.
std::size_t expected_sites(double area, double spacing);

/// What options say, but for the curvature: lengths per vertex, or none. Throws InvalidInput where
/// they do not fit the mesh, are not usable numbers above 0, or are given twice.
std::vector<double> wanted_lengths(const Mesh& mesh, const SizingOptions& options);
/// Lengths in proportion to curvature^(-adapt/2), curvatures (curvature.h) from a tenth to a
/// hundred times their mean.
std::vector<double> lengths_of_curvatures(std::span<const double> curvature, double adapt);

/// The sizes that have these lengths, limited in growth; or else lengths in proportion to them, as
/// the number of vertices or the mean length of edges that `options` give asks for. Throws
/// InvalidInput where the longest is more than 1000 times the shortest.
Sizing find_sizing(const Mesh& mesh, const MeshEdges& edges, std::span<const double> lengths,
                   const RemeshOptions& options, Executor& executor = sequential());

/// What options say, but for the curvature: sizes from wanted_lengths(), else from the field; none
/// of neither.
Sizing find_sizing(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
                   Executor& executor = sequential());

}  // namespace geolloyd
