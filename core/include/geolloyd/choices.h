#pragma once

#include <cstdint>
#include <functional>

#include "geolloyd/types.h"

namespace geolloyd {

/// Which parts of the mesh are nodes, and which of them are joined (the first five: thesis):
/// vertex          vertices; arcs along edges
/// vertex_dense    and between the two vertices opposite a shared edge
/// triangle        triangles; arcs across shared edges
/// triangle_dense  and between triangles that share a vertex, by way of it
/// mixed           vertices and triangles as in the first and third, and each triangle to its
/// corners
/// vertex_far      vertices; arcs along edges and straight over the surface, across up to five
/// edges
enum class GraphKind { vertex, vertex_dense, triangle, triangle_dense, mixed, vertex_far };

/// How the components of a displacement make its length: their root of squares, the sum of their
/// absolute values, or the largest of these.
enum class Norm { geodesic, manhattan, linf };

/// An anisotropic metric at one place: a displacement d costs the norm of (tangent_magnitude *
/// tangent.d, bitangent_magnitude * bitangent.d). Directions have length 1, or 0 for no direction.
/// The metric does not depend on the sign, order or handedness of the two directions.
struct TangentSpace {
  Vec3 tangent;
  Vec3 bitangent;
  double tangent_magnitude = 1;
  double bitangent_magnitude = 1;
};

/// How the tangent spaces at the ends of an arc, or at the corners of a triangle, become one.
enum class Averaging {
  pairwise,  ///< directions with those nearest to them, magnitudes with theirs (the thesis)
  metric,    ///< as metrics, any number at once (core/fields/metric_mean.h); for the geodesic norm
};

/// Other norms depend on the directions, which a metric may not have.
constexpr Averaging suggested_averaging(Norm norm) {
  return norm == Norm::geodesic ? Averaging::metric : Averaging::pairwise;
}

/// How the first seeds are chosen.
enum class SeedInit {
  random,            ///< uniformly over nodes (the thesis)
  random_area,       ///< with chances by mass
  farthest,          ///< each the node farthest from all before it (Gonzalez 1985)
  kmeans_plus_plus,  ///< with chances by mass * distance^2 to those before (Arthur, Vassilvitskii
                     ///< 2007)
  surface,           ///< near sites that have come to rest on the surface, as those of a remesh do
  coarse,            ///< where seeds come to rest on coarser graphs of the same metric
  automatic,         ///< surface, coarse or farthest, by the numbers of seeds and of nodes
};

/// The greedy phase: left out, or with the standard or the extended heuristic (thesis; formulas in
/// core/lloyd/seed_move.h). The precise phase uses the same heuristic; where there is no greedy
/// phase, the extended one.
enum class GreedyMode { off, standard, extended };

/// The mode that suits first seeds chosen in this way. From farthest-point seeds the greedy phase
/// takes time and raises the energy more often than it lowers it; from the other seeds it nearly
/// always lowers it (bench/results/greedy-phase.md).
constexpr GreedyMode suggested_greedy_mode(SeedInit init) {
  const bool is_even = init == SeedInit::farthest || init == SeedInit::surface ||
                       init == SeedInit::coarse || init == SeedInit::automatic;
  return is_even ? GreedyMode::off : GreedyMode::extended;
}

/// Greedy steps, macrosteps, then rounds of improvement.
enum class Phase { greedy, precise, improvement };

/// Why a relaxation ended.
enum class StopReason {
  converged,    ///< a macrostep ended with the seeds with which it began
  interrupted,  ///< the progress callback asked for it
  limit,        ///< of steps, in the options
  recurred      ///< the seeds came back to an earlier state, or 100 macrosteps lowered no energy
};

/// Where a relaxation stands. Reported after each greedy step, and now and then during a
/// macrostep.
struct Progress {
  Phase phase;
  std::uint32_t step;  ///< counts from 1 in each phase
  std::uint32_t seeds_moving;
  double energy;  ///< at the start of the step
};

/// Called by the calling thread now and then. False stops the work as soon as possible; the result
/// is then the best state met. An exception ends the work and reaches the caller.
using ProgressCallback = std::function<bool(const Progress&)>;

}  // namespace geolloyd
